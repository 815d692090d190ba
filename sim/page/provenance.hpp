#pragma once

#include <string>
#include <vector>

#include "sim/report/manifest.hpp"

namespace maquette::sim {

/// What a page says of where results come from: what the manifest holds without the host's times.
/// Absolute paths stand by their last part: pages name no place of the machine they were made on.
struct Provenance {
  std::vector<std::string> command;  ///< as it was given
  std::string version;
  std::string revision;
  std::vector<InputDigest> inputs;
  std::vector<std::string> files;
};

/// Reads a manifest.json. `name` is that of the file, for error messages. Throws DescriptionError
/// for what is not one.
[[nodiscard]] Provenance parse_provenance(const std::string& json, const std::string& name);

/// The command as a line of a shell, with absolute paths by their last part.
[[nodiscard]] std::string command_line(const Provenance& provenance);

}  // namespace maquette::sim
