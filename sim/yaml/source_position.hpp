#pragma once

#include <string>

namespace maquette::sim {

/// Where a value stands in a description: lines and columns count from 1.
struct SourcePosition {
  std::string file;
  int line = 1;
  int column = 1;
};

}  // namespace maquette::sim
