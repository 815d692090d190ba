#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace maquette::sim {

/// A file of a run directory that is known and not yet written.
struct NamedContent {
  std::string name;     ///< without directory
  std::string content;  ///< bytes
};

/// Makes a run directory with its parents, and makes sure that files can be written into it, so
/// that a run does not find out at its end. An existing directory stays as it is. Throws
/// DescriptionError.
void create_run_directory(const std::filesystem::path& directory);

/// Writes a set of files into an existing directory. Each is written beside its name and renamed
/// when all of the set are complete, so nobody ever finds half a file, and a failure (full disk,
/// vanished directory) leaves the directory as it was. Throws DescriptionError.
void write_files(const std::filesystem::path& directory, const std::vector<NamedContent>& files);

/// Where a result that is asked for by a path goes: a name alone is one of the run's own, in the
/// folder of these.
[[nodiscard]] std::filesystem::path place_of_result(const std::filesystem::path& place,
                                                    const std::filesystem::path& folder);

/// The bytes of a file. Throws DescriptionError when it cannot be read.
std::string read_file(const std::filesystem::path& file);

}  // namespace maquette::sim
