#pragma once

#include <string>
#include <systemc>

namespace maquette::models {

/// Reports that a master has broken the rules of the bus: an exception out of the kernel's run.
inline void report_misuse(const std::string& what) {
  SC_REPORT_ERROR("/maquette/versabus", what.c_str());
}

}  // namespace maquette::models
