#pragma once

#include "sim/sweep/study.hpp"

namespace maquette::sim {

/// Gives a study what it does not say: a name, and where it varies the number of boards speed-up
/// and efficiency as columns. Its files must have been put in their places (inline_files).
void complete(Study& study);

}  // namespace maquette::sim
