#pragma once

#include <string>
#include <vector>

#include "sim/fields/key_table.hpp"

namespace maquette::sim {

/// The parts of descriptions whose keys can be explained: primitives, and groups of scenes and
/// studies.
std::vector<std::string> explained_parts();

/// The keys of such a part. Throws DescriptionError for another name.
std::vector<KeyRow> keys_of_part(const std::string& part);

/// The keys of such a part, what they mean and what is allowed, from their declarations, and an
/// example. Throws DescriptionError for another name.
std::string key_help(const std::string& part);

}  // namespace maquette::sim
