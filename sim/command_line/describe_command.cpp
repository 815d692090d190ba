#include "sim/command_line/describe_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include "sim/command_line/common_options.hpp"
#include "sim/command_line/cost_table_report.hpp"
#include "sim/command_line/description_tables.hpp"
#include "sim/command_line/key_help.hpp"
#include "sim/command_line/parameter_groups.hpp"
#include "sim/command_line/study_report.hpp"
#include "sim/command_line/table_output.hpp"
#include "sim/database/scene_report.hpp"
#include "sim/maps/map_table.hpp"
#include "sim/report/statistics_description.hpp"
#include "sim/run/leg_report.hpp"
#include "sim/scene/shipped_descriptions.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"

namespace maquette::sim {

namespace {

struct DescribeOptions {
  CommonOptions common;
  bool statistics = false;
  bool maps = false;
  bool legs = false;
  std::string keys;
  bool all = false;
  TableFormat format = TableFormat::text;
};

/// All parameters of a scene, those of its objects, and of its machine.
std::string all_parameters(const Description& description) {
  std::string text = "\n" + scene_parameter_report(description.scene) +
                     "\nObjects of the scene, as --set and --vary take them\n";
  for (const auto& row : object_table(parse_yaml(description.input_files.front())).rows) {
    text += fmt::format("  {}  {}\n", row[0], row[1]);
  }
  return text + "\n" + machine_report(description.machine);
}

/// Of a scene, a machine or a study.
std::string description_text(const DescribeOptions& options) {
  const std::string file =
      description_file(options.common.scene, {"scenes", "machines", "studies"}, data_directory());
  CommonOptions described = options.common;
  described.scene = file;
  DescriptionSources sources = sources_of(described);
  sources.known = {read_input(file)};
  const InputFile& input = sources.known.front();
  if (options.legs && (describes_study(input) || describes_machine(input))) {
    throw DescriptionError(file + ": no scene; allowed with --legs: a scene, whose pixels it is");
  }
  if (describes_study(input)) {
    return in_format(
        options.format, [&] { return study_report(input); }, [&] { return column_table(input); });
  }
  if (describes_machine(input)) {
    sources.machine = file;
    std::vector<InputFile> input_files;
    const Machine machine = load_machine(sources, input_files);
    return in_format(
        options.format, [&] { return machine_report(machine); },
        [&] { return parameter_table(machine); });
  }
  const Description description = load_description(sources);
  if (options.legs) {
    const auto threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return leg_report(description.scene, description.machine, threads);
  }
  return in_format(
      options.format,
      [&] {
        return wrapped(scene_report(description.scene, description.machine)) +
               (options.all ? all_parameters(description) : parameter_groups(description));
      },
      [&] { return parameter_table(description); });
}

std::string explained(const std::string& part, TableFormat format) {
  return in_format(
      format, [&] { return key_help(part); }, [&] { return keys_table(part); });
}

/// The name of a part of descriptions means its keys, unless a file is called so.
bool names_part(const std::string& name) {
  const std::vector<std::string> parts = explained_parts();
  return std::find(parts.begin(), parts.end(), name) != parts.end() &&
         !std::filesystem::exists(name);
}

std::string description_of(const DescribeOptions& options) {
  if (options.statistics) {
    return in_format(
        options.format, [] { return describe_statistics() + "\n"; }, statistics_table);
  }
  if (!options.keys.empty()) {
    return explained(options.keys, options.format);
  }
  if (options.maps) {
    return in_format(options.format, describe_maps, maps_table);
  }
  if (names_part(options.common.scene)) {
    return explained(options.common.scene, options.format);
  }
  if (options.common.machine.empty() && names_cost_table(options.common.scene, data_directory())) {
    DescriptionSources sources;
    sources.data_directory = data_directory();
    sources.overrides = options.common.overrides;
    return in_format(
        options.format, [&] { return cost_table_report(options.common.scene, sources); },
        [&] { return cost_table(options.common.scene, sources); });
  }
  return description_text(options);
}

}  // namespace

void add_describe_command(CLI::App& program) {
  const auto options = std::make_shared<DescribeOptions>();
  CLI::App& verb = *program.add_subcommand("describe",
                                           "what a scene needs, a board's memory map, parameters "
                                           "with their sources; what a study varies");
  add_common_options(verb, options->common);
  CLI::Option* statistics =
      verb.add_flag("--statistics", options->statistics, "explain the keys of stats.json instead");
  verb.add_flag("--maps", options->maps, "list the maps of a run (`run --map`) instead")
      ->excludes(statistics);
  verb.add_option("--keys", options->keys,
                  fmt::format("explain the keys of a part of descriptions instead: {}",
                              fmt::join(explained_parts(), ", ")))
      ->type_name("PART")
      ->excludes(statistics);
  verb.add_flag("--all", options->all,
                "list all parameters, of scene and machine, with unit, range, meaning and source, "
                "not those alone that a scene gives");
  add_format_option(verb, options->format);
  verb.add_flag("--legs", options->legs,
                "show how the process of the scene's pixels comes apart for machines with function "
                "units instead")
      ->excludes(statistics)
      ->excludes(verb.get_option("--format"));
  verb.get_option("SCENE")->required(false)->type_name("FILE|SCENE|MACHINE|STUDY|TABLE|PART");
  add_footer(verb, {},
             {"maquette describe photo4", "maquette describe photo4 --legs",
              "maquette describe ccett-1984 --format csv", "maquette describe --statistics",
              "maquette describe revolution", "maquette describe motorola_ffp"});
  verb.callback([options, statistics, &verb] {
    if (!*statistics && !options->maps && options->keys.empty() && options->common.scene.empty()) {
      throw CLI::RequiredError(verb.get_option("SCENE")->get_name());
    }
    fmt::print("{}", description_of(*options));
  });
}

}  // namespace maquette::sim
