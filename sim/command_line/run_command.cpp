#include "sim/command_line/run_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "firmware/arithmetic/stop_request.hpp"
#include "models/bus/bus_levels.hpp"
#include "models/bus/instant.hpp"
#include "sim/command_line/common_options.hpp"
#include "sim/command_line/film_output.hpp"
#include "sim/command_line/frame_choice.hpp"
#include "sim/command_line/ram_dump.hpp"
#include "sim/command_line/run_options.hpp"
#include "sim/command_line/study_point.hpp"
#include "sim/command_line/warnings.hpp"
#include "sim/fields/quantity.hpp"
#include "sim/fields/time_text.hpp"
#include "sim/maps/map_files.hpp"
#include "sim/page/layers.hpp"
#include "sim/page/run_page.hpp"
#include "sim/picture/image_file.hpp"
#include "sim/report/output_check.hpp"
#include "sim/report/progress.hpp"
#include "sim/report/remark.hpp"
#include "sim/report/result_directory.hpp"
#include "sim/report/seconds.hpp"
#include "sim/report/statistics_json.hpp"
#include "sim/run/execution_check.hpp"
#include "sim/run/frame_recorder.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/record_store.hpp"
#include "sim/run/simulation.hpp"
#include "sim/trace/trace_files.hpp"
#include "sim/trace/trace_request.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

std::vector<models::Duration> instants_of(const std::vector<std::string>& texts,
                                          const std::string& option) {
  std::vector<models::Duration> instants;
  for (const std::string& text : texts) {
    const SourcePosition position{fmt::format("{} {}", option, text), 1, 1};
    try {
      instants.emplace_back(parse_time(text));
    } catch (const std::invalid_argument& error) {
      throw DescriptionError(position, error.what());
    }
    if (instants.back().count() < 0) {
      throw DescriptionError(position, "a time before the frame; allowed: 0 s and later");
    }
    if (instants.back() > models::k_longest_run) {
      throw DescriptionError(position,
                             "no frame takes so long; allowed: up to 8640000 s, 100 days");
    }
    // One instant may be written in several ways.
    if (std::count(instants.begin(), instants.end(), instants.back()) > 1) {
      instants.pop_back();
    }
  }
  return instants;
}

/// The frame to replay, if the run replays one. Whoever keeps a record replays it: the statistics
/// are the same bytes, and the frame is synthesised once.
std::optional<RecordedFrame> record_for(const RunOptions& options, const Description& description,
                                        ResultDirectory& results, int threads) {
  const Scene& scene = description.scene;
  const Machine& machine = description.machine;
  if (options.processor == "recorded") {
    return options.record.empty() ? record_of(scene, machine, results.kept("record"), threads)
                                  : load_record(options.record, record_key_of(scene, machine));
  }
  if (options.record.empty()) {
    return std::nullopt;
  }
  std::optional<RecordedFrame> record = record_frame(scene, picture_format_of(machine), threads,
                                                     FunctionsOfPixels::told, legs_wanted(machine));
  save_record(options.record, *record);
  return record;
}

void add_pictures(const std::string& name, const std::vector<models::Duration>& instants,
                  const std::vector<models::Picture>& pictures, std::vector<NamedContent>& files) {
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    files.push_back(
        {fmt::format("{}-{}s.png", name, format_seconds(instants[i])), encode_png(pictures[i])});
  }
}

/// Refuses a trace at a level of the bus that does not have what it shows; names those that do.
void check_level(const models::BusLevel& level, bool models::BusLevel::*has,
                 const std::string& what) {
  if (level.*has) {
    return;
  }
  std::vector<std::string_view> allowed;
  for (const models::BusLevel& other : models::k_bus_levels) {
    if (other.*has) {
      allowed.push_back(other.name);
    }
  }
  throw DescriptionError(
      fmt::format("{}; bus.level {} is allowed with it", what, fmt::join(allowed, " or ")));
}

Description loaded(const RunOptions& options) {
  DescriptionSources sources = sources_of(options.common);
  for (const std::string& override_text : overrides_of(options.bus)) {
    sources.overrides.push_back(override_text);
  }
  return load_description(sources);
}

/// What is to be run; a point of a study names the run directory as well.
Description described(RunOptions& options) {
  if (options.common.scene.empty() && options.study.empty()) {
    throw CLI::RequiredError("SCENE");
  }
  Description description;
  if (options.study.empty()) {
    description = loaded(options);
  } else {
    StudyPoint point = point_of_study(options.study, options.point);
    description = std::move(point.description);
    if (options.outdir.empty()) {
      options.outdir = (std::filesystem::path("runs") / point.name).string();
    }
  }
  const models::BusLevel& level = description.machine.parameters.bus.level;
  if (!options.trace.files.empty()) {
    check_level(level, &models::BusLevel::is_exclusive,
                "--trace shows one master of the bus at a time");
  }
  if (!options.trace.lines.empty()) {
    check_level(level, &models::BusLevel::has_lines,
                "--trace-lines shows the lines of the backplane");
  }
  return description;
}

std::string paper_time_of(const Scene& scene) {
  return scene.paper_time
             ? fmt::format("{}; {}",
                           format_quantity(scene.paper_time->value.count(), WholeDimension::time),
                           scene.paper_time->source)
             : "";
}

std::vector<RequestedOutput> outputs_of(const RunOptions& options,
                                        const std::filesystem::path& directory) {
  std::vector<RequestedOutput> outputs;
  if (!options.record.empty() && options.processor != "recorded") {
    outputs.push_back({"--record", options.record});
  }
  if (const FilmRequest film = film_request(options.film); film.is_one_file()) {
    outputs.push_back({"--film", place_of_result(film.place, directory)});
  }
  for (const std::string& file : options.trace.files) {
    outputs.push_back({"--trace", place_of_result(file, directory)});
    if (const std::string view = view_of(file); !view.empty()) {
      outputs.push_back({"--trace", place_of_result(view, directory)});
    }
  }
  if (!options.trace.lines.empty()) {
    outputs.push_back({"--trace-lines", place_of_result(options.trace.lines, directory)});
  }
  if (options.report) {
    outputs.push_back({"--report", directory / k_page_name});
  }
  return outputs;
}

/// The maps that are asked for, and those that a page shows.
std::vector<Map> maps_of(const RunOptions& options) {
  std::vector<std::string> names = options.maps;
  if (options.report) {
    names.insert(names.end(), page_maps().begin(), page_maps().end());
  }
  return maps_named(names);
}

/// The run directory, and the files that were asked for by a path.
std::string written_line(const RunOptions& options, const std::filesystem::path& directory) {
  std::string line = "written: " + directory.string();
  for (const RequestedOutput& output : outputs_of(options, directory)) {
    line += ", " + output.path.string();
  }
  return line;
}

void check_facts(const SimulationRequest& request) {
  if (request.facts.counted && !request.executed) {
    throw DescriptionError(
        "--map count_error holds counted pixels against executed ones; --processor instruction is "
        "allowed with it");
  }
}

/// Boards, and units of functions behind them.
std::size_t bus_masters(const models::MachineParameters& parameters) {
  std::size_t masters = parameters.boards.size();
  for (const models::FunctionUnitParameters& kind : parameters.units.kinds) {
    masters += static_cast<std::size_t>(kind.number);
  }
  return masters;
}

int run(RunOptions options, const std::vector<std::string>& command) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto host_time_s = [start] {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  Description description = described(options);
  if (!description.frames.empty() && options.frame < 0) {
    return run_frames(options, command, description, host_time_s);
  }
  SimulationRequest request;
  request.held = take_frame(options, description);
  const int processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  request.threads = options.threads > 0 ? options.threads : processors;
  request.snapshots = instants_of(options.snapshots, "--snapshot");
  request.shown_snapshots = instants_of(options.shown_snapshots, "--snapshot-shown");
  TraceRequest trace = trace_request(options.trace, bus_masters(description.machine.parameters));
  if (!trace.files.empty()) {
    request.trace = trace.window;
  }
  if (trace.video) {
    request.video = trace.window;
  }
  request.executed = options.processor == "instruction";
  if (request.executed) {
    require_execution(description.machine);
  }
  const std::vector<Map> maps = maps_of(options);
  request.facts = facts_of(maps);
  check_facts(request);
  const FilmRequest film = film_request(options.film);
  request.film = film.is_wanted();
  Warnings warnings(description);
  request.warn = [&warnings](const SceneWarning& warning) { warnings.tell(warning); };
  request.dumped_boards =
      checked_boards(options.dumped_boards, request.executed, description.machine);
  check_fit(description.scene, description.machine);
  const std::filesystem::path directory = run_directory_of(options, description);
  check_outputs(outputs_of(options, directory), description.input_files, directory);
  ResultDirectory results(directory);
  trace.folder = results.workplace();
  TraceFiles trace_files(std::move(trace));
  request.lines = trace_files.lines();

  const Interruption interruption;
  const std::optional<RecordedFrame> record = firmware::unless_stopped(
      [&] { return record_for(options, description, results, request.threads); },
      std::optional<RecordedFrame>());
  request.record = record ? &*record : nullptr;
  SimulationResult result;
  {
    Progress progress(!options.quiet);
    result = simulate(description.scene, description.machine, request,
                      [&progress](models::Duration simulated, double fraction) {
                        progress.show(simulated, fraction);
                        return !Interruption::is_requested();
                      });
  }

  std::vector<NamedContent> files = {
      {"frame.png", encode_png(result.picture)},
      {"stats.json", statistics_json(result.statistics)},
      {"config.yaml", effective_configuration(description.scene, description.machine)}};
  if (result.depths) {
    files.push_back({"depth.png", encode_depths(*result.depths)});
  }
  add_pictures("snapshot", request.snapshots, result.snapshots, files);
  add_pictures("snapshot-shown", request.shown_snapshots, result.shown_snapshots, files);
  for (NamedContent& file :
       map_files(maps, maps_named(options.maps), result.facts, description.scene.name)) {
    files.push_back(std::move(file));
  }
  add_ram_files(request.dumped_boards, result, files);
  const auto manifest = [&] {
    Manifest made = manifest_of(command, description.input_files, host_time_s());
    made.warnings = warnings.told();
    return made;
  };
  const models::Instant frame_end = result.statistics.frame.time;
  remark(trace_files.remarks(result.trace, frame_end));
  trace_files.write(result.trace, frame_end);
  if (options.report) {
    files.push_back(
        {k_page_name, run_page(shown_files(directory.string(), files, manifest_json(manifest())),
                               data_directory())});
  }
  if (result.film) {
    write_film(film, results.workplace(), *result.film);
  }
  write_files(results.workplace(), files);
  results.publish(manifest());
  if (!options.quiet) {
    fmt::print("{}\n{}\n",
               summarise(result.statistics, result.times_from, paper_time_of(description.scene),
                         host_time_s()),
               written_line(options, directory));
  }
  return result.statistics.partial ? k_exit_interrupted : 0;
}

}  // namespace

void add_run_command(CLI::App& program, const std::vector<std::string>& command, int& exit_code) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App& verb = *program.add_subcommand(
      "run", "simulate a scene on a machine: picture, frame time, where it went");
  add_run_options(verb, *options);
  add_footer(
      verb, {},
      {"maquette run photo4", "maquette run photo4 --set processors=8 --outdir runs/eight",
       "maquette run photo4 --machine m68020 --snapshot \"60 s\"",
       "maquette run photo4 --bus signal --trace-lines lines.vcd --trace-window \"1 s..1.01 s\""});
  verb.callback([options, &command, &exit_code] { exit_code = run(*options, command); });
}

}  // namespace maquette::sim
