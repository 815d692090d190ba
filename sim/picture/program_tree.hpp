#pragma once

#include <filesystem>

namespace maquette::sim {

/// The top of the tree that the running program is part of. Built or installed, the program stands
/// in a folder of it, beside lib/maquette with the picture module and share/maquette with what is
/// shipped as data. Throws std::filesystem::filesystem_error where /proc is not mounted.
[[nodiscard]] std::filesystem::path program_tree();

}  // namespace maquette::sim
