#include "sim/command_line/describe_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "sim/command_line/common_options.hpp"
#include "sim/command_line/description_tables.hpp"
#include "sim/command_line/key_help.hpp"
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

/// The paths of a scene's objects; of many the first ones.
std::string object_list(const InputFile& scene, bool all) {
  constexpr std::size_t k_screen = 20;
  const Table table = object_table(parse_yaml(scene));
  const std::size_t shown = all ? table.rows.size() : std::min(k_screen, table.rows.size());
  std::string text = "\nObjects of the scene, as --set and --vary take them\n";
  for (std::size_t i = 0; i < shown; ++i) {
    text += fmt::format("  {}  {}\n", table.rows[i][0], table.rows[i][1]);
  }
  if (shown < table.rows.size()) {
    text += fmt::format("  and {} more with --all\n", table.rows.size() - shown);
  }
  return text;
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
        return scene_report(description.scene, description.machine) +
               object_list(description.input_files.front(), options.all) + "\n" +
               machine_report(description.machine);
      },
      [&] { return parameter_table(description); });
}

std::string description_of(const DescribeOptions& options) {
  if (options.statistics) {
    return in_format(
        options.format, [] { return describe_statistics() + "\n"; }, statistics_table);
  }
  if (!options.keys.empty()) {
    return in_format(
        options.format, [&] { return key_help(options.keys); },
        [&] { return keys_table(options.keys); });
  }
  if (options.maps) {
    return in_format(options.format, describe_maps, maps_table);
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
  verb.add_flag("--all", options->all, "list all objects of the scene, not the first ones alone");
  add_format_option(verb, options->format);
  verb.add_flag("--legs", options->legs,
                "show how the process of the scene's pixels comes apart for machines with function "
                "units instead")
      ->excludes(statistics)
      ->excludes(verb.get_option("--format"));
  verb.get_option("SCENE")->required(false)->type_name("FILE|SCENE|MACHINE|STUDY");
  add_footer(verb, {},
             {"maquette describe photo4", "maquette describe photo4 --legs",
              "maquette describe ccett-1984 --format csv", "maquette describe --statistics",
              "maquette describe --keys revolution"});
  verb.callback([options, statistics, &verb] {
    if (!*statistics && !options->maps && options->keys.empty() && options->common.scene.empty()) {
      throw CLI::RequiredError(verb.get_option("SCENE")->get_name());
    }
    fmt::print("{}", description_of(*options));
  });
}

}  // namespace maquette::sim
