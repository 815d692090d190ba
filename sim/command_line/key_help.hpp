#pragma once

#include <string>
#include <vector>

namespace maquette::sim {

/// The parts of descriptions whose keys can be explained: primitives, and groups of scenes and
/// studies.
std::vector<std::string> explained_parts();

/// The keys of such a part, what they mean and what is allowed, from their declarations, and an
/// example. Throws DescriptionError for another name.
std::string key_help(const std::string& part);

}  // namespace maquette::sim
