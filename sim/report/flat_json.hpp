#pragma once

#include <string>
#include <utility>
#include <vector>

namespace maquette::sim {

/// The values of a structured text, each with its path ("boards[2].compute_s"), in the order of the
/// text. Numbers keep their decimal digits, so exact times stay exact.
using FlatValues = std::vector<std::pair<std::string, std::string>>;

/// The values of a JSON text. `name` is that of the file, for the error message. An empty group
/// has no value. Throws DescriptionError with the place of what is not JSON.
FlatValues flatten_json(const std::string& text, const std::string& name);

}  // namespace maquette::sim
