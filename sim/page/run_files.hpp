#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/report/run_directory.hpp"

namespace maquette::sim {

/// The results of one run as files, whether they are in a directory already or not.
struct RunFiles {
  std::string directory;            ///< as messages name it
  std::vector<NamedContent> files;  ///< results, and manifest.json

  /// Null where there is no such file.
  [[nodiscard]] const NamedContent* find(std::string_view name) const;

  /// Throws DescriptionError where there is none.
  [[nodiscard]] const std::string& content(std::string_view name) const;
};

/// What a page shows of results that are not published yet, as read_run_files would find it.
[[nodiscard]] RunFiles shown_files(const std::string& directory,
                                   const std::vector<NamedContent>& results,
                                   const std::string& manifest);

/// Reads what a page shows of a run directory: of the files that its manifest names. Throws
/// DescriptionError for what is no run directory, or a damaged one.
[[nodiscard]] RunFiles read_run_files(const std::filesystem::path& directory);

}  // namespace maquette::sim
