#pragma once

#include <string>

namespace maquette::sim {

/// A table of all keys of stats.json with unit and meaning, one per line. "boards[].pixels" stands
/// for the pixels of each board.
std::string describe_statistics();

}  // namespace maquette::sim
