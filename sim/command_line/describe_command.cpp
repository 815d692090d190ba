#include "sim/command_line/describe_command.hpp"

#include <fmt/format.h>

#include <memory>

#include "sim/command_line/common_options.hpp"
#include "sim/database/scene_report.hpp"
#include "sim/report/statistics_description.hpp"

namespace maquette::sim {

namespace {

struct DescribeOptions {
  CommonOptions common;
  bool statistics = false;
};

void describe(const DescribeOptions& options) {
  if (options.statistics) {
    fmt::print("{}\n", describe_statistics());
    return;
  }
  const DescriptionSources sources = sources_of(options.common);
  if (describes_machine(sources.scene_file)) {
    DescriptionSources machine_sources = sources;
    machine_sources.machine = sources.scene_file;
    std::vector<std::string> input_files;
    fmt::print("{}", machine_report(load_machine(machine_sources, input_files)));
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
  verb.get_option("SCENE")->required(false);
  verb.callback([options, statistics, &verb] {
    if (!*statistics && options->common.scene.empty()) {
      throw CLI::RequiredError(verb.get_option("SCENE")->get_name());
    }
    describe(*options);
  });
}

}  // namespace maquette::sim
