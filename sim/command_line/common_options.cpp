#include "sim/command_line/common_options.hpp"

#include <fmt/format.h>

#include <string_view>

#include "models/bus/bus_levels.hpp"
#include "sim/command_line/version.hpp"
#include "sim/picture/program_tree.hpp"
#include "sim/scene/shipped_descriptions.hpp"
#include "sim/yaml/name_check.hpp"

namespace maquette::sim {

void add_common_options(CLI::App& verb, CommonOptions& options) {
  verb.add_option("SCENE", options.scene,
                  "scene: its file, the name of a shipped one, or a run's config.yaml")
      ->required()
      ->type_name("FILE|SCENE");
  verb.add_option("--machine", options.machine,
                  "machine: its file, or the name of a shipped one (default: what the scene names, "
                  "else ccett-1984)")
      ->type_name("FILE|MACHINE");
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

void add_footer(CLI::App& verb, const std::string& remarks,
                const std::vector<std::string>& examples) {
  std::string text = remarks + (remarks.empty() ? "" : "\n\n") + "Examples:";
  for (const std::string& example : examples) {
    text += "\n  " + example;
  }
  verb.footer(text);
}

DescriptionSources sources_of(const CommonOptions& options) {
  DescriptionSources sources;
  sources.data_directory = data_directory();
  sources.scene_file = description_file(options.scene, {"scenes"}, sources.data_directory);
  if (!options.machine.empty()) {
    sources.machine = options.machine;
  }
  sources.overrides = options.overrides;
  return sources;
}

std::string data_directory() { return program_tree() / "share" / "maquette"; }

std::string path_for_results(const std::string& path) {
  const std::string prefix = data_directory() + "/";
  return path.compare(0, prefix.size(), prefix) == 0 ? path.substr(prefix.size()) : path;
}

std::filesystem::path default_directory(const CommonOptions& options, const Scene& scene,
                                        const std::string& suffix) {
  const std::string stem = std::filesystem::path(options.scene).stem().string();
  const std::string of_file = is_file_name(stem) ? stem : "scene";
  return std::filesystem::path("runs") / ((scene.name.empty() ? of_file : scene.name) + suffix);
}

Manifest manifest_of(const std::vector<std::string>& command,
                     const std::vector<InputFile>& input_files, double host_time_s) {
  Manifest manifest;
  manifest.command = command;
  manifest.version = version();
  manifest.revision = revision();
  for (const InputFile& file : input_files) {
    manifest.inputs.push_back(digest_of(file));
    manifest.inputs.back().path = path_for_results(file.path);
  }
  manifest.host_time_s = host_time_s;
  measure_process(manifest);
  return manifest;
}

}  // namespace maquette::sim
