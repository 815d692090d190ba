#pragma once

#include <filesystem>
#include <string>

/// Pages of what measures the program: tables that can be sorted, filtered and plotted, and the
/// plots that are there.
namespace maquette::sim {

/// The ladder of errors and what every level costs. Throws DescriptionError, as does the other.
[[nodiscard]] std::string accuracy_page(const std::filesystem::path& directory);

/// The bounds, those first that are broken or nearest to it.
[[nodiscard]] std::string stability_page(const std::filesystem::path& directory);

}  // namespace maquette::sim
