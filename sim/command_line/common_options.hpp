#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sim/report/manifest.hpp"
#include "sim/scene/description_loader.hpp"

namespace maquette::sim {

/// Exit code of an interrupted command: 128 + SIGINT, as shells have it.
inline constexpr int k_exit_interrupted = 130;

/// Options that several verbs share.
struct CommonOptions {
  std::string scene;
  std::string machine;
  std::vector<std::string> overrides;
};

/// Adds SCENE, --machine and --set to a verb.
void add_common_options(CLI::App& verb, CommonOptions& options);

/// What --bus and --quantum ask for; empty: as the machine says.
struct BusOptions {
  std::string level;
  std::string quantum;
};

/// Adds --bus and --quantum to a verb.
void add_bus_options(CLI::App& verb, BusOptions& options);

/// The overrides that these options stand for.
std::vector<std::string> overrides_of(const BusOptions& options);

/// Ends the help of a verb, and its part of the manual page, with remarks and examples.
void add_footer(CLI::App& verb, const std::string& remarks,
                const std::vector<std::string>& examples);

/// Where the descriptions that these options name come from.
DescriptionSources sources_of(const CommonOptions& options);

/// The folder of what is shipped as data: models/, scenes/, stability/.
std::string data_directory();

/// The path as a result may name it: relative to the folder of data for what is shipped, wherever
/// that is; as given otherwise.
std::string path_for_results(const std::string& path);

/// Where results of a description go when nothing else is asked for: a folder in runs/ that is
/// called by the scene's name or, where it has none, by its file, with `suffix` behind.
std::filesystem::path default_directory(const CommonOptions& options, const Scene& scene,
                                        const std::string& suffix);

/// The manifest of a command that has read these files and taken this long.
Manifest manifest_of(const std::vector<std::string>& command,
                     const std::vector<InputFile>& input_files, double host_time_s);

}  // namespace maquette::sim
