#pragma once

#include <string>
#include <vector>

#include "sim/page/html.hpp"
#include "sim/page/section.hpp"

namespace maquette::sim {

/// A whole page: one file that needs no other, with every section and a list of them. It says all
/// without scripts; with them it plots, sorts and probes. Its policy of contents lets it fetch
/// nothing. Equal sections give equal bytes.
[[nodiscard]] std::string page(const std::string& title, const std::vector<Section>& sections);

}  // namespace maquette::sim
