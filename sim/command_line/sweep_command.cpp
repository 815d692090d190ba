#include "sim/command_line/sweep_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "sim/command_line/common_options.hpp"
#include "sim/command_line/plot_options.hpp"
#include "sim/command_line/table_output.hpp"
#include "sim/report/progress.hpp"
#include "sim/report/remark.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/run/interruption.hpp"
#include "sim/scene/shipped_descriptions.hpp"
#include "sim/sweep/point_selection.hpp"
#include "sim/sweep/study_defaults.hpp"
#include "sim/sweep/study_description.hpp"
#include "sim/sweep/study_results.hpp"
#include "sim/sweep/study_run.hpp"
#include "sim/sweep/study_table.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/name_check.hpp"

namespace maquette::sim {

namespace {

struct SweepOptions {
  CommonOptions common;
  std::vector<std::string> axes;
  bool zip = false;
  std::string study_file;
  std::string name;
  std::string outdir;
  PlotOptions plots;
  int jobs = 0;
  std::string point;
  std::string points;
  std::optional<int> task;
  std::optional<int> tasks;
  bool from_environment = false;
  bool quiet = false;
  TableFormat format = TableFormat::text;
};

void add_study_options(CLI::App& verb, SweepOptions& options) {
  add_common_options(verb, options.common);
  verb.get_option("SCENE")->required(false);
  verb.add_option("--vary", options.axes,
                  "values of a parameter: a,b,c; 1..64; 1..64:8; 0.2..0.5 us of 7; "
                  "log 1..1000 of 12; machine=ccett-1984,m68020 (repeatable: all combinations, the "
                  "first varies slowest)")
      ->type_name("PATH=VALUES")
      ->expected(1)
      ->take_all();
  verb.add_flag("--zip", options.zip, "pair the values of several --vary instead");
  verb.add_option("--sweep", options.study_file,
                  "study: the same, and plots; its file, or the name of a shipped one")
      ->type_name("FILE|STUDY");
  add_plot_options(verb, options.plots);
  verb.add_option("--name", options.name, "name of the study")->type_name("NAME");
  verb.add_option("--outdir", options.outdir, "study directory (default: runs/NAME)")
      ->type_name("DIR");
}

void add_selection_options(CLI::App& verb, SweepOptions& options) {
  verb.add_option("--jobs", options.jobs, "points simulated at a time (default: one per processor)")
      ->check(CLI::Range(1, 4096));
  CLI::Option* point = verb.add_option("--point", options.point, "simulate this point alone");
  CLI::Option* points =
      verb.add_option("--points", options.points, "simulate these points")->type_name("A..B");
  CLI::Option* task =
      verb.add_option("--task", options.task, "simulate the points of one of several tasks")
          ->check(CLI::Range(0, 1'000'000));
  CLI::Option* tasks = verb.add_option("--tasks", options.tasks,
                                       "number of tasks; task I takes points I, I + N, I + 2N, ...")
                           ->check(CLI::Range(1, 1'000'000));
  CLI::Option* environment =
      verb.add_flag("--from-environment", options.from_environment,
                    "take task and number of tasks from a Slurm array or MPI rank");
  point->excludes(points)->excludes(task)->excludes(environment);
  points->excludes(task)->excludes(environment);
  task->needs(tasks)->excludes(environment);
  tasks->needs(task);
  verb.add_flag("--quiet", options.quiet, "neither progress nor summary");
  add_format_option(verb, options.format);
}

/// A name on the command line as a node; relative names are relative to where the program runs.
YamlNode node_of_option(const std::string& option, const std::string& text) {
  YamlNode node = yaml_scalar(text);
  node.place.file = std::make_shared<const std::string>(option + " " + text);
  return node;
}

/// The scene that a study without one starts from: the first of those that it varies.
YamlNode first_scene(const Study& study) {
  for (const Axis& axis : study.axes) {
    if (const auto* value = std::get_if<AxisValue>(&axis.pieces.front());
        axis.path == "scene" && value != nullptr) {
      return value->node;
    }
  }
  throw DescriptionError(
      "SCENE is missing; a scene file, --sweep FILE or --vary scene=... is "
      "allowed");
}

Study study_of(const SweepOptions& options) {
  Study study;
  if (!options.study_file.empty()) {
    study = read_study(description_file(options.study_file, {"studies"}, data_directory()));
  }
  for (const std::string& axis : options.axes) {
    study.axes.push_back(parse_axis(axis));
  }
  if (study.axes.empty()) {
    throw DescriptionError("nothing is varied; --vary PATH=VALUES or --sweep FILE is allowed");
  }
  if (options.zip) {
    study.design = StudyDesign::zip;
  }
  if (!options.common.scene.empty()) {
    study.scene = node_of_option("--scene", options.common.scene);
  } else if (study.scene.kind == YamlKind::null) {
    study.scene = first_scene(study);
  }
  if (!options.common.machine.empty()) {
    study.machine = node_of_option("--machine", options.common.machine);
  }
  for (const std::string& text : options.common.overrides) {
    study.changes.push_back(parse_override(text));
  }
  for (Plot& plot : plots_of(options.plots)) {
    study.plots.push_back(std::move(plot));
  }
  if (!options.name.empty()) {
    check_file_name(options.name, node_of_option("--name", options.name).place, "name");
    study.name = options.name;
  }
  return study;
}

std::vector<int> selected_points(const SweepOptions& options, int count) {
  if (!options.point.empty()) {
    return parse_points(options.point, "--point", count);
  }
  if (!options.points.empty()) {
    return parse_points(options.points, "--points", count);
  }
  if (options.from_environment) {
    return points_of(share_of_environment([](const char* name) { return std::getenv(name); }),
                     count);
  }
  if (options.task && *options.task >= *options.tasks) {
    throw DescriptionError("--task: tasks are numbered from 0 to " +
                           std::to_string(*options.tasks - 1));
  }
  return points_of({options.task.value_or(0), options.tasks.value_or(1)}, count);
}

bool selects_all(const SweepOptions& options) {
  return options.point.empty() && options.points.empty() && !options.task &&
         !options.from_environment;
}

std::vector<int> unfinished(const StudyDirectory& directory, const std::vector<int>& numbers) {
  std::vector<int> points;
  for (const int point : numbers) {
    if (!directory.is_finished(point)) {
      points.push_back(point);
    }
  }
  return points;
}

int exit_code_of(const StudyOutcome& outcome) {
  return outcome.failed + outcome.missing > 0 ? 1 : 0;
}

/// Gathers everything and says so.
int gather_and_report(const StudyPoints& points, const StudyDirectory& directory, bool quiet,
                      TableFormat format) {
  const StudyOutcome outcome = gather(points, directory);
  if (!quiet) {
    fmt::print("{}", in_format(
                         format,
                         [&] {
                           return fmt::format("{}\nwritten: {}\n", outcome_report(outcome),
                                              directory.path().string());
                         },
                         [&] { return outcome.table; }));
  }
  return exit_code_of(outcome);
}

int sweep(const SweepOptions& options, const std::vector<std::string>& command) {
  const auto start = std::chrono::steady_clock::now();
  Study study = study_of(options);
  std::vector<InputFile> input_files;
  inline_files(study, data_directory(), input_files);
  complete(study);
  const StudyPoints points(std::move(study), data_directory());
  const std::vector<int> selected = selected_points(options, points.size());
  check_columns(points);
  const std::vector<std::string> records = check_points(points);
  const StudyDirectory directory(points, options.outdir.empty()
                                             ? std::filesystem::path("runs") / points.study().name
                                             : std::filesystem::path(options.outdir));
  const std::vector<int> numbers = unfinished(directory, selected);
  const int jobs = options.jobs > 0
                       ? options.jobs
                       : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const Interruption interruption;
  StudyProgress progress;
  {
    Progress line(!options.quiet);
    progress = run_points(
        points, directory, records, numbers, jobs,
        [&line](const StudyProgress& now) { line.show_points(now.done, now.failed, now.planned); });
  }
  if (Interruption::is_requested()) {
    remark(fmt::format("interrupted after {} of {} points; the same command goes on\n",
                       progress.done, progress.planned));
    return k_exit_interrupted;
  }
  if (!selects_all(options)) {
    return progress.failed > 0 ? 1 : 0;
  }
  const int exit_code = gather_and_report(points, directory, options.quiet, options.format);
  const std::chrono::duration<double> host_time = std::chrono::steady_clock::now() - start;
  Manifest manifest = manifest_of(command, input_files, host_time.count());
  manifest.study = {jobs, progress.done};
  write_files(directory.path(), {{"manifest.json", manifest_json(manifest)}});
  return exit_code;
}

int merge(const std::string& path, const PlotOptions& plots, bool quiet, TableFormat format) {
  Study study = read_study((std::filesystem::path(path) / k_study_file).string());
  for (Plot& plot : plots_of(plots)) {
    study.plots.push_back(std::move(plot));
  }
  std::vector<InputFile> input_files;
  inline_files(study, data_directory(), input_files);
  const StudyPoints points(std::move(study), data_directory());
  check_columns(points);
  const StudyDirectory directory(points, path);
  return gather_and_report(points, directory, quiet, format);
}

}  // namespace

void add_sweep_commands(CLI::App& program, const std::vector<std::string>& command,
                        int& exit_code) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App& sweep_verb = *program.add_subcommand(
      "sweep", "simulate a scene at many values of its parameters: table and plots");
  add_footer(
      sweep_verb,
      "Every finished point is kept: the same command goes on where it ended. With --point, "
      "--points,\n--task or --from-environment the points are gathered by `maquette merge DIR`.",
      {"maquette sweep photo4 --vary processors=1,2,4,8 --plot processors,frame.time_s",
       "maquette sweep --sweep boards"});
  add_study_options(sweep_verb, *options);
  add_selection_options(sweep_verb, *options);
  sweep_verb.callback([options, &command, &exit_code] { exit_code = sweep(*options, command); });

  struct MergeOptions {
    std::string directory;
    PlotOptions plots;
    bool quiet = false;
    TableFormat format = TableFormat::text;
  };
  const auto merging = std::make_shared<MergeOptions>();
  CLI::App& merge_verb =
      *program.add_subcommand("merge", "gather the points of a sweep that was run in parts");
  merge_verb.add_option("DIR", merging->directory, "study directory")->required()->type_name("DIR");
  add_plot_options(merge_verb, merging->plots);
  merge_verb.add_flag("--quiet", merging->quiet, "no summary");
  add_format_option(merge_verb, merging->format);
  add_footer(merge_verb, {}, {"maquette merge runs/boards"});
  merge_verb.callback([merging, &exit_code] {
    exit_code = merge(merging->directory, merging->plots, merging->quiet, merging->format);
  });
}

}  // namespace maquette::sim
