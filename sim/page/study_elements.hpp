#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/page/html.hpp"
#include "sim/page/section.hpp"

/// What pages of many runs have in common.
namespace maquette::sim {

/// What a directory of results is called: the last step of its path.
[[nodiscard]] std::string study_name(const std::filesystem::path& directory);

/// The table of a CSV file, with plots of its columns where scripts run; a column of numbers is one
/// in which no cell is another text. Throws DescriptionError.
[[nodiscard]] Html csv_element(const std::string& caption, const std::filesystem::path& file,
                               bool is_parallel = false);

/// The sections with one more, of the PNG files in folders; without it where there are none.
[[nodiscard]] std::vector<Section> with_plots(std::vector<Section> sections,
                                              const std::vector<std::filesystem::path>& folders);

}  // namespace maquette::sim
