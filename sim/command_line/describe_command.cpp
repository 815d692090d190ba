#include "sim/command_line/describe_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "sim/command_line/common_options.hpp"
#include "sim/command_line/key_help.hpp"
#include "sim/database/scene_report.hpp"
#include "sim/maps/map_table.hpp"
#include "sim/report/statistics_description.hpp"
#include "sim/run/leg_report.hpp"
#include "sim/scene/shipped_descriptions.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

struct DescribeOptions {
  CommonOptions common;
  bool statistics = false;
  bool maps = false;
  bool legs = false;
  std::string keys;
};

void describe(const DescribeOptions& options) {
  if (options.statistics) {
    fmt::print("{}\n", describe_statistics());
    return;
  }
  if (!options.keys.empty()) {
    fmt::print("{}", key_help(options.keys));
    return;
  }
  if (options.maps) {
    fmt::print("{}", describe_maps());
    return;
  }
  const std::string file =
      description_file(options.common.scene, {"scenes", "machines"}, data_directory());
  CommonOptions described = options.common;
  described.scene = file;
  DescriptionSources sources = sources_of(described);
  sources.known = {read_input(file)};
  const bool is_machine = describes_machine(sources.known.front());
  if (options.legs) {
    if (is_machine) {
      throw DescriptionError(file +
                             ": a machine; allowed with --legs: a scene, whose pixels it is");
    }
    const Description description = load_description(sources);
    const auto threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    fmt::print("{}", leg_report(description.scene, description.machine, threads));
    return;
  }
  if (is_machine) {
    sources.machine = file;
    std::vector<InputFile> input_files;
    fmt::print("{}", machine_report(load_machine(sources, input_files)));
    return;
  }
  const Description description = load_description(sources);
  fmt::print("{}\n{}", scene_report(description.scene, description.machine),
             machine_report(description.machine));
}

}  // namespace

void add_describe_command(CLI::App& program) {
  const auto options = std::make_shared<DescribeOptions>();
  CLI::App& verb = *program.add_subcommand(
      "describe", "what a scene needs, a board's memory map, parameters with their sources");
  add_common_options(verb, options->common);
  CLI::Option* statistics =
      verb.add_flag("--statistics", options->statistics, "explain the keys of stats.json instead");
  verb.add_flag("--maps", options->maps, "list the maps of a run (`run --map`) instead")
      ->excludes(statistics);
  verb.add_flag("--legs", options->legs,
                "show how the process of the scene's pixels comes apart for machines with function "
                "units instead")
      ->excludes(statistics);
  verb.add_option("--keys", options->keys,
                  fmt::format("explain the keys of a part of descriptions instead: {}",
                              fmt::join(explained_parts(), ", ")))
      ->type_name("PART")
      ->excludes(statistics);
  verb.get_option("SCENE")->required(false)->type_name("FILE|SCENE|MACHINE");
  add_footer(verb, {},
             {"maquette describe photo4", "maquette describe photo4 --legs",
              "maquette describe ccett-1984", "maquette describe --statistics",
              "maquette describe --keys revolution"});
  verb.callback([options, statistics, &verb] {
    if (!*statistics && !options->maps && options->keys.empty() && options->common.scene.empty()) {
      throw CLI::RequiredError(verb.get_option("SCENE")->get_name());
    }
    describe(*options);
  });
}

}  // namespace maquette::sim
