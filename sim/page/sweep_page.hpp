#pragma once

#include <filesystem>
#include <string>

namespace maquette::sim {

/// The page of a sweep, also of one that is not complete: table, plots, and each of its points.
/// Throws DescriptionError.
[[nodiscard]] std::string sweep_page(const std::filesystem::path& directory);

}  // namespace maquette::sim
