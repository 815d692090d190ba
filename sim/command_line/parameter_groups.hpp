#pragma once

#include <string>

#include "sim/scene/description_loader.hpp"

namespace maquette::sim {

/// What a description gives and leaves not as by default, in groups by the first step of its paths,
/// in which lines fit into 100 columns and each group onto a screen; how many more there are.
[[nodiscard]] std::string parameter_groups(const Description& description);

/// A text whose lines that are longer than 100 columns go on, indented, on the next ones.
[[nodiscard]] std::string wrapped(const std::string& text);

}  // namespace maquette::sim
