#pragma once

#include <string>

#include "sim/report/flat_json.hpp"

namespace maquette::sim {

/// The values of a YAML text, with paths as in flatten_json and scalars as they are written. `name`
/// is that of the file, for the error message. Throws DescriptionError with the place of what is
/// not YAML.
FlatValues flatten_yaml(const std::string& text, const std::string& name);

}  // namespace maquette::sim
