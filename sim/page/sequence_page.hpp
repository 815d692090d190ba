#pragma once

#include <filesystem>
#include <string>

namespace maquette::sim {

/// The page of a sequence whose results are in this folder: a film strip, the times of each frame
/// and what it had loaded anew. `name` is what the sequence is called; the page is the same before
/// and after the folder gets its place. Throws DescriptionError.
[[nodiscard]] std::string sequence_page(const std::filesystem::path& folder,
                                        const std::string& name, const std::string& data_directory);

}  // namespace maquette::sim
