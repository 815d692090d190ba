#pragma once

#include <filesystem>
#include <string>

/// Pages of many runs: tables that can be sorted, filtered and plotted, and the plots that are
/// there.
namespace maquette::sim {

/// Of a sweep, also of one that is not complete. Throws DescriptionError, as do the others.
[[nodiscard]] std::string sweep_page(const std::filesystem::path& directory);

[[nodiscard]] std::string accuracy_page(const std::filesystem::path& directory);

/// The bounds, those first that are broken or nearest to it.
[[nodiscard]] std::string stability_page(const std::filesystem::path& directory);

}  // namespace maquette::sim
