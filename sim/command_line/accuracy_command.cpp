#include "sim/command_line/accuracy_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>

#include "sim/accuracy/accuracy_json.hpp"
#include "sim/accuracy/accuracy_plot.hpp"
#include "sim/accuracy/accuracy_report.hpp"
#include "sim/accuracy/accuracy_tables.hpp"
#include "sim/accuracy/ladders.hpp"
#include "sim/accuracy/level_run.hpp"
#include "sim/accuracy/tile_map.hpp"
#include "sim/command_line/common_options.hpp"
#include "sim/command_line/table_output.hpp"
#include "sim/picture/image_file.hpp"
#include "sim/plot/gnuplot.hpp"
#include "sim/report/progress.hpp"
#include "sim/report/remark.hpp"
#include "sim/report/result_directory.hpp"
#include "sim/run/execution_check.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/simulation.hpp"

namespace maquette::sim {

namespace {

struct AccuracyOptions {
  CommonOptions common;
  std::string outdir;
  std::vector<std::string> ladders;
  std::vector<std::string> quanta = default_quanta();
  int repeats = 3;
  int sample = 1;
  bool quiet = false;
  TableFormat format = TableFormat::text;
};

void add_options(CLI::App& verb, AccuracyOptions& options) {
  add_common_options(verb, options.common);
  verb.add_option("--outdir", options.outdir,
                  "directory of the results (default: runs/NAME-OF-SCENE-accuracy)")
      ->type_name("DIR");
  verb.add_option("--ladder", options.ladders, "only this ladder (repeatable; default: all)")
      ->check(CLI::IsMember(ladder_names()))
      ->expected(1)
      ->take_all();
  verb.add_option("--quantum", options.quanta,
                  "a quantum of the decoupled bus (repeatable; default: 1 us to 100 ms by tens)")
      ->type_name("TIME")
      ->expected(1)
      ->take_all();
  verb.add_option("--repeats", options.repeats, "how often each level is run for its host time")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb.add_option(
          "--sample", options.sample,
          "execute the instructions of about one in N pixels and extrapolate; 1: the whole frame")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  verb.add_flag("--quiet", options.quiet, "neither progress nor table");
  add_format_option(verb, options.format);
  add_footer(
      verb,
      "accuracy.csv and accuracy.json hold what the input determines. Processor times of the host, "
      "which no\ntwo runs share, are in host_times.csv, host_times.json, manifest.json and the "
      "plots over host time alone.\ntile_error.png is the screen by tiles: white where the "
      "time of the level with the worst tile is that of\nthe instructions, red where it is longer, "
      "blue "
      "where shorter, full colour for tile_error_worst of\naccuracy.csv, light grey where not "
      "executed.",
      {"maquette accuracy photo4 --ladder bus"});
}

std::vector<Ladder> wanted_ladders(const AccuracyOptions& options, const Description& description) {
  std::vector<Ladder> ladders =
      ladders_of(description.scene, description.machine, {options.quanta, options.sample});
  if (!options.ladders.empty()) {
    ladders.erase(std::remove_if(ladders.begin(), ladders.end(),
                                 [&options](const Ladder& ladder) {
                                   return std::find(options.ladders.begin(), options.ladders.end(),
                                                    ladder.name) == options.ladders.end();
                                 }),
                  ladders.end());
  }
  return ladders;
}

/// Tells why a ladder is missing that was asked for, by its name or with all others.
void explain_missing(const AccuracyOptions& options, const Machine& machine) {
  const std::string name = k_processor_ladder;
  const std::vector<std::string>& wanted = options.ladders;
  const bool is_wanted =
      wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  const std::optional<std::string> obstacle = obstacle_to_execution(machine);
  if (is_wanted && obstacle) {
    remark(
        fmt::format("the ladder {} is left out, since boards can not execute their program: {}\n",
                    name, *obstacle));
  }
}

/// The levels of all ladders, one after another, each checked.
std::vector<LevelTask> tasks_of(const std::vector<Ladder>& ladders,
                                const DescriptionSources& sources) {
  std::vector<LevelTask> tasks;
  for (const Ladder& ladder : ladders) {
    for (const Level& level : ladder.levels) {
      DescriptionSources own = sources;
      own.overrides.insert(own.overrides.end(), level.overrides.begin(), level.overrides.end());
      Description description = load_description(own);
      check_fit(description.scene, description.machine);
      tasks.push_back({ladder.name + ", " + level.name, level, std::move(description.scene),
                       std::move(description.machine)});
    }
  }
  return tasks;
}

std::vector<LadderResult> results_of(const std::vector<Ladder>& ladders,
                                     const std::vector<std::vector<LevelOutcome>>& outcomes) {
  std::vector<LadderResult> results;
  auto first = outcomes.begin();
  for (const Ladder& ladder : ladders) {
    const auto last = first + static_cast<std::ptrdiff_t>(ladder.levels.size());
    results.push_back(result_of(ladder, {first, last}));
    first = last;
  }
  return results;
}

/// All but the manifest.
std::vector<NamedContent> files_of(const std::vector<LadderResult>& results,
                                   const Description& description) {
  std::vector<NamedContent> files = {{"accuracy.csv", table_csv(error_table(results))},
                                     {"accuracy.json", error_json(description.scene.name, results)},
                                     {"host_times.csv", table_csv(host_time_table(results))},
                                     {"host_times.json", host_time_json(results)}};
  if (const std::optional<TileError> error = mapped_error(results)) {
    const models::FrameMemoryParameters& frame = description.machine.parameters.frame_memory;
    files.push_back({"tile_error.png", encode_png(tile_map(*error, frame.width, frame.height))});
  }
  return files;
}

/// Draws what can be drawn: a lack of gnuplot must not cost the results.
std::exception_ptr draw_plots(const std::vector<LadderResult>& results,
                              const std::filesystem::path& directory) {
  try {
    for (const AccuracyPlot& plot : accuracy_plots(results)) {
      draw(directory, plot.name, plot.script);
    }
  } catch (const std::exception&) {
    return std::current_exception();
  }
  return nullptr;
}

int accuracy(const AccuracyOptions& options, const std::vector<std::string>& command) {
  const auto start = std::chrono::steady_clock::now();
  const DescriptionSources sources = sources_of(options.common);
  const Description description = load_description(sources);
  const std::vector<Ladder> ladders = wanted_ladders(options, description);
  const std::vector<LevelTask> tasks = tasks_of(ladders, sources);
  const std::filesystem::path directory =
      options.outdir.empty() ? default_directory(options.common, description.scene, "-accuracy")
                             : std::filesystem::path(options.outdir);
  ResultDirectory published(directory);
  explain_missing(options, description.machine);

  const Interruption interruption;
  std::vector<std::vector<LevelOutcome>> outcomes;
  {
    Progress progress(!options.quiet);
    const int planned = static_cast<int>(tasks.size()) * options.repeats;
    outcomes = run_levels(tasks, options.repeats, [&progress, planned](int done) {
      progress.show_points(done, 0, planned);
    });
  }
  if (Interruption::is_requested()) {
    return k_exit_interrupted;
  }

  const std::vector<LadderResult> results = results_of(ladders, outcomes);
  const std::chrono::duration<double> host_time = std::chrono::steady_clock::now() - start;
  write_files(published.workplace(), files_of(results, description));
  const std::exception_ptr failure = draw_plots(results, published.workplace() / "plots");
  published.publish(manifest_of(command, description.input_files, host_time.count()));
  if (failure) {
    std::rethrow_exception(failure);
  }
  if (!options.quiet) {
    fmt::print("{}", in_format(
                         options.format,
                         [&] {
                           return fmt::format("{}written: {}\n", accuracy_report(results),
                                              directory.string());
                         },
                         [&] { return error_table(results); }));
  }
  return 0;
}

}  // namespace

void add_accuracy_command(CLI::App& program, const std::vector<std::string>& command,
                          int& exit_code) {
  const auto options = std::make_shared<AccuracyOptions>();
  CLI::App& verb = *program.add_subcommand(
      "accuracy", "a scene at several levels: error against run time, each with its reference");
  add_options(verb, *options);
  verb.callback([options, &command, &exit_code] { exit_code = accuracy(*options, command); });
}

}  // namespace maquette::sim
