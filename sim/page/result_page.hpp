#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace maquette::sim {

/// The page of directories of results, whatever they are of: of one run, sweep, measurement of
/// accuracy or of stability; or of several runs, compared with the first. Throws DescriptionError.
[[nodiscard]] std::string result_page(const std::vector<std::filesystem::path>& directories,
                                      const std::string& data_directory);

}  // namespace maquette::sim
