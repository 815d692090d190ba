#pragma once

#include <filesystem>
#include <string>

namespace maquette::sim {

/// The name under which this process writes what is to be called `name` when it is complete:
/// hidden, and of this process alone, so that two runs into one directory do not write into each
/// other's.
[[nodiscard]] std::string unfinished_name(const std::string& name);

/// Removes what processes of this host that are no more left unfinished in a directory: of `name`,
/// or of any name where it is empty.
void clear_unfinished(const std::filesystem::path& directory, const std::string& name = {});

}  // namespace maquette::sim
