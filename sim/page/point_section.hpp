#pragma once

#include <filesystem>

#include "sim/page/html.hpp"

namespace maquette::sim {

/// How a point of a sweep runs again as a run of its own, what is kept of such runs in the folders
/// point-N of the sweep's directory, and what was swept around. Throws DescriptionError for a run
/// that is damaged.
[[nodiscard]] Html point_section(const std::filesystem::path& directory);

}  // namespace maquette::sim
