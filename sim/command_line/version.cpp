#include "sim/command_line/version.hpp"

#include "revision.hpp"

namespace maquette::sim {

const char* version() { return MAQUETTE_VERSION; }

const char* revision() { return k_revision; }

}  // namespace maquette::sim
