#pragma once

#include <filesystem>

namespace maquette::sim {

/// Makes sure that a result may take this place: nothing is there, or a regular file, also behind a
/// link. Returns the place itself, without links. Throws DescriptionError.
std::filesystem::path replaceable(const std::filesystem::path& path);

}  // namespace maquette::sim
