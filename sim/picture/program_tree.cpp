#include "sim/picture/program_tree.hpp"

namespace maquette::sim {

std::filesystem::path program_tree() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
}

}  // namespace maquette::sim
