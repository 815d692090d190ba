#pragma once

#include <string>

namespace maquette::sim {

/// Prints to standard error. Where that is closed or full nobody can be told, and the command goes
/// on.
void remark(const std::string& text);

}  // namespace maquette::sim
