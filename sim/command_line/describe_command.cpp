#include "sim/command_line/describe_command.hpp"

#include <fmt/format.h>

#include <memory>

#include "sim/command_line/common_options.hpp"
#include "sim/database/scene_report.hpp"
#include "sim/maps/map_table.hpp"
#include "sim/report/statistics_description.hpp"
#include "sim/scene/shipped_descriptions.hpp"

namespace maquette::sim {

namespace {

struct DescribeOptions {
  CommonOptions common;
  bool statistics = false;
  bool maps = false;
};

void describe(const DescribeOptions& options) {
  if (options.statistics) {
    fmt::print("{}\n", describe_statistics());
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
  if (describes_machine(sources.known.front())) {
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
  verb.get_option("SCENE")->required(false)->type_name("FILE|SCENE|MACHINE");
  add_footer(verb, {},
             {"maquette describe photo4", "maquette describe ccett-1984",
              "maquette describe --statistics"});
  verb.callback([options, statistics, &verb] {
    if (!*statistics && !options->maps && options->common.scene.empty()) {
      throw CLI::RequiredError(verb.get_option("SCENE")->get_name());
    }
    describe(*options);
  });
}

}  // namespace maquette::sim
