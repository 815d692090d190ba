#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sim/description/description_loader.hpp"

namespace maquette::sim {

/// Options that several verbs share.
struct CommonOptions {
  std::string scene;
  std::string machine;
  std::vector<std::string> overrides;
};

/// Adds SCENE, --machine and --set to a verb.
void add_common_options(CLI::App& verb, CommonOptions& options);

/// Where the descriptions that these options name come from.
DescriptionSources sources_of(const CommonOptions& options);

/// The path as a result may name it: relative to the project for the shipped descriptions, as given
/// otherwise.
std::string path_for_results(const std::string& path);

}  // namespace maquette::sim
