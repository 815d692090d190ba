#include "sim/command_line/common_options.hpp"

#include <fmt/format.h>

#include <string_view>

#include "models/bus/bus_levels.hpp"

namespace maquette::sim {

namespace {

/// The project's root, which holds models/; known when the program is built.
constexpr const char* k_project_directory = MAQUETTE_PROJECT_DIRECTORY;

}  // namespace

void add_common_options(CLI::App& verb, CommonOptions& options) {
  verb.add_option("SCENE", options.scene, "scene description, or a run's config.yaml")
      ->required()
      ->type_name("FILE");
  verb.add_option("--machine", options.machine,
                  "machine description (default: what the scene names, else ccett-1984)")
      ->type_name("FILE");
  verb.add_option("--set", options.overrides,
                  "give a parameter another value, e.g. processors=8 (repeatable)")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->take_all();
}

void add_bus_options(CLI::App& verb, BusOptions& options) {
  std::vector<std::string> names;
  std::vector<std::string_view> sentences;
  for (const models::BusLevel& level : models::k_bus_levels) {
    names.emplace_back(level.name);
    sentences.push_back(level.sentence);
  }
  verb.add_option("--bus", options.level,
                  "how exactly the bus is simulated (default: bus.level of the machine): " +
                      fmt::format("{}", fmt::join(sentences, "; ")))
      ->check(CLI::IsMember(names));
  verb.add_option("--quantum", options.quantum,
                  "how long boards run ahead of one another with --bus decoupled (default: "
                  "bus.quantum of the machine)")
      ->type_name("TIME");
}

std::vector<std::string> overrides_of(const BusOptions& options) {
  std::vector<std::string> overrides;
  if (!options.level.empty()) {
    overrides.push_back("bus.level=" + options.level);
  }
  if (!options.quantum.empty()) {
    overrides.push_back("bus.quantum=" + options.quantum);
  }
  return overrides;
}

DescriptionSources sources_of(const CommonOptions& options) {
  DescriptionSources sources;
  sources.scene_file = options.scene;
  if (!options.machine.empty()) {
    sources.machine = options.machine;
  }
  sources.overrides = options.overrides;
  sources.models_directory = project_path("models");
  return sources;
}

std::string project_path(const std::string& name) {
  return std::string(k_project_directory) + "/" + name;
}

std::string path_for_results(const std::string& path) {
  const std::string prefix = project_path("");
  return path.compare(0, prefix.size(), prefix) == 0 ? path.substr(prefix.size()) : path;
}

Manifest manifest_of(const std::vector<std::string>& command,
                     const std::vector<std::string>& input_files, double host_time_s) {
  Manifest manifest;
  manifest.command = command;
  manifest.version = MAQUETTE_VERSION;
  for (const std::string& file : input_files) {
    InputFile input = hash_input(file);
    input.path = path_for_results(file);
    manifest.inputs.push_back(input);
  }
  manifest.host_time_s = host_time_s;
  measure_process(manifest);
  return manifest;
}

}  // namespace maquette::sim
