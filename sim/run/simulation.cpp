#include "sim/run/simulation.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <systemc>

#include <fmt/format.h>

#include "firmware/arithmetic/stop_request.hpp"
#include "firmware/synthesize.hpp"
#include "models/board/work_cost.hpp"
#include "models/bus/kernel_time.hpp"
#include "models/display/shown_picture.hpp"
#include "models/machine/ccett_machine.hpp"
#include "models/machine/unique_names.hpp"
#include "sim/database/memory_map.hpp"
#include "sim/database/symbol_map.hpp"
#include "sim/run/board_programs.hpp"
#include "sim/run/bus_recorder.hpp"
#include "sim/run/fact_synthesis.hpp"
#include "sim/run/frame_pixels.hpp"
#include "sim/run/frame_statistics.hpp"
#include "sim/run/function_times.hpp"
#include "sim/run/line_recorder.hpp"
#include "sim/run/pixel_watch.hpp"
#include "sim/run/time_forecast.hpp"
#include "sim/run/unit_start.hpp"
#include "sim/run/video_recorder.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

/// At least so long between two looks at the host: progress, interruption.
constexpr models::Duration k_slice = std::chrono::seconds(1);

/// Share of the pixels that the boards have taken, 0 to 1.
double fraction_taken(const models::CcettMachine& model, const models::PixelRectangle& zone) {
  return zone.pixels() == 0
             ? 1
             : static_cast<double>(model.pixels_taken()) / static_cast<double>(zone.pixels());
}

/// The kernel turns whatever leaves a process into a report; a pixel that was asked to end is none.
void start_kernel(const sc_core::sc_time& slice) {
  try {
    sc_core::sc_start(slice);
  } catch (const sc_core::sc_report&) {
    if (!firmware::stop_requested.load()) {
      throw;
    }
  }
}

void run_kernel(const models::CcettMachine& model, const models::PixelRectangle& zone,
                const Continue& go_on) {
  sc_core::sc_time slice = models::to_sc_time(k_slice);
  while (!model.finished()) {
    start_kernel(slice);
    if (!go_on(models::kernel_now(), fraction_taken(model, zone))) {
      return;
    }
    if (!model.finished() && !sc_core::sc_pending_activity()) {
      throw std::logic_error("the machine stands still before its boards are done");
    }
    slice = std::max(models::to_sc_time(k_slice), sc_core::sc_time_to_pending_activity());
  }
}

void take_snapshots(const models::CcettMachine& model, const SimulationRequest& request,
                    SimulationResult& result) {
  const models::Duration start = model.statistics().load_time;
  for (const models::Duration time : request.snapshots) {
    result.snapshots.push_back(model.frame_memory().picture_at(start + time));
  }
  for (const models::Duration time : request.shown_snapshots) {
    result.shown_snapshots.push_back(
        models::shown_picture(model.frame_memory(), model.video_timing(), start + time));
  }
}

/// The machine with RAM enough for what its boards are allowed to overflow it with.
Machine with_room(const Machine& machine, const MemoryMap& map) {
  Machine roomy = machine;
  roomy.parameters.board.ram_bytes = std::max(map.ram_bytes, map.used_bytes);
  return roomy;
}

std::string times_from(const Machine& machine, bool executed) {
  if (!executed) {
    return fmt::format("the firmware's counted work, at the costs of the tables {} and {}",
                       machine.tables.arithmetic, machine.tables.program);
  }
  switch (machine.parameters.board.arithmetic.execution) {
    case models::ArithmeticExecution::package:
      return "the boards' program, executed instruction by instruction";
    case models::ArithmeticExecution::exact:
      return "the boards' program, executed but for its arithmetic package, which the host has the "
             "time of for each call";
    case models::ArithmeticExecution::none:
    case models::ArithmeticExecution::costs:
      break;
  }
  return "the boards' program, executed but for its arithmetic, which costs what " +
         machine.tables.arithmetic + " says";
}

std::string times_from(const Calibration& calibration) {
  constexpr double k_percent = 100;
  return fmt::format(
      "the firmware's counted work, at the costs of {} pixels whose program was executed\n"
      "                (their sum {:+.2f} %, one pixel typically {:.1f} %)",
      calibration.pixels, k_percent * calibration.sum_error, k_percent * calibration.typical_error);
}

/// What the counted work of a run costs; nothing where the machine's tables say it.
std::optional<Calibration> calibration_of(const Scene& scene, const Machine& machine,
                                          const SimulationRequest& request) {
  if (request.executed || !is_calibrated(machine)) {
    return std::nullopt;
  }
  if (request.calibration != nullptr) {
    return *request.calibration;
  }
  return firmware::unless_stopped(
      [&] { return std::optional<Calibration>(calibrate(scene, machine)); },
      std::optional<Calibration>());
}

CostStatistics cost_statistics(const Machine& machine, bool executed,
                               const std::optional<Calibration>& calibration) {
  CostStatistics costs;
  costs.from = executed ? "execution" : "tables";
  if (calibration) {
    costs.from = "calibration";
    costs.pixels = calibration->pixels;
    costs.sum_error = calibration->sum_error;
    costs.typical_error = calibration->typical_error;
  }
  constexpr double k_milli = 1e3;
  const models::WorkCost cost(machine.parameters.board);
  for (std::size_t i = 0; i < costs.clocks.size(); ++i) {
    const auto operation = static_cast<firmware::Operation>(i);
    costs.clocks[i] = static_cast<double>(cost.milliclocks(operation)) / k_milli;
  }
  return costs;
}

/// Where the time went, as far as it is known.
void add_functions(const models::CcettMachine& model, const Machine& machine,
                   const SimulationRequest& request, const FrameSource& source,
                   Statistics& statistics) {
  if (!model.finished()) {
    statistics.functions.from = "absent: the run was interrupted";
    return;
  }
  const FrameWork work = source.work_by_function();
  statistics.extents = extent_statistics(work);
  statistics.roots.intersections = intersection_roots(work);
  if (request.executed) {
    statistics.functions.from = "absent: boards execute their program";
    return;
  }
  if (models::has_units(machine.parameters.units)) {
    statistics.functions.from = "absent: units do a part of the work at prices of their own";
    return;
  }
  statistics.functions = function_statistics(model.statistics(), machine, work);
}

void start_facts(const Machine& machine, const models::PixelRectangle& zone, PixelFacts& facts) {
  facts.width = machine.parameters.frame_memory.width;
  facts.height = machine.parameters.frame_memory.height;
  facts.zone = zone;
  for (std::size_t board = 0; board < machine.parameters.boards.size(); ++board) {
    facts.boards.push_back(fmt::format("board{}", board));
  }
}

/// What the facts of pixels take besides the run; none of a frame that was interrupted.
void complete_facts(const Scene& scene, const Machine& machine, const SimulationRequest& request,
                    SimulationResult& result) {
  const WantedFacts& wanted = request.facts;
  if (result.statistics.partial) {
    result.facts = {};
    return;
  }
  const bool is_priced = wanted.functions || wanted.counted;
  const Machine priced = request.executed && is_priced && is_calibrated(machine)
                             ? with_costs(machine, calibrate(scene, machine))
                             : machine;
  synthesise_facts(scene, priced, request.record, wanted, request.threads, result.facts);
}

SimulationResult simulate_prepared(const Machine& machine, const SimulationRequest& request,
                                   FrameSource& source, const models::FrameSetup& setup,
                                   const Continue& go_on) {
  models::require_unique_names();
  models::CcettMachine model("machine", machine.parameters, source, setup);
  SimulationResult result;
  if (request.trace) {
    start_record(model, *request.trace, result.trace);
  }
  if (request.lines != nullptr) {
    record_lines(model, *request.lines);
  }
  if (request.video) {
    watch_video(model, *request.video, request.lines, result.trace);
  }
  if (request.facts.any()) {
    start_facts(machine, setup.useful_zone, result.facts);
  }
  if (request.facts.times) {
    watch_pixels(model, result.facts);
  }
  run_kernel(model, setup.useful_zone, go_on);
  if (model.finished()) {
    model.verify_frame();
  }
  if (request.trace) {
    finish_record(model, result.trace);
    if (request.video) {
      finish_video_record(model, result.trace);
    }
  }
  result.statistics =
      frame_statistics(model.statistics(), machine, setup.useful_zone, source.preprocessing());
  add_functions(model, machine, request, source, result.statistics);
  if (request.picture) {
    result.picture = model.frame_memory().picture();
    if (picture_format_of(machine).has_depth) {
      result.depths = model.frame_memory().depths();
    }
  }
  take_snapshots(model, request, result);
  if (request.film) {
    result.film = film_of(model);
  }
  if (request.facts.times && model.finished()) {
    tell_instants(model, result.facts);
  }
  for (const int board : request.dumped_boards) {
    result.rams.push_back(model.board(static_cast<std::size_t>(board)).ram());
  }
  return result;
}

/// The memory map of a board, checked.
MemoryMap checked_map(const Scene& scene, const Machine& machine,
                      const PackedScene<float>& packed) {
  MemoryMap map = memory_map_of(packed, machine);
  check_memory(map, machine, scene.object.position_in_file);
  return map;
}

}  // namespace

void check_fit(const Scene& scene, const Machine& machine) {
  checked_map(scene, machine, packed_scene<float>(scene, picture_format_of(machine)));
}

namespace {

/// The program of boards compares rays with all extents.
void check_extents(const Scene& scene, const SimulationRequest& request) {
  if (request.executed && scene.extents.value_or(Extents::all) != Extents::all) {
    throw DescriptionError(
        "extents: boards that execute their program compare rays with all; allowed: all, or a "
        "processor whose work is counted");
  }
}

/// Units are handed legs of pixels, which only counted ones have.
void check_units(const Machine& machine, const SimulationRequest& request) {
  if (request.executed && models::has_units(machine.parameters.units)) {
    throw DescriptionError(
        "units: the program that boards execute makes each pixel whole, and has no call that hands "
        "out errands; allowed: --processor counted or recorded, which know the parts of a pixel, "
        "or "
        "a machine without units");
  }
  if (request.record != nullptr && legs_wanted(machine) == LegsOfPixels::told &&
      !request.record->has_legs()) {
    throw DescriptionError(
        "units: the record does not tell how its pixels were made; allowed: one that was made "
        "(--record) for a machine with units, pixels that are counted, or a machine without units");
  }
}

void warn_of_picture(const Scene& scene, const Machine& machine, const SimulationRequest& request,
                     std::uint32_t background, const SimulationResult& result) {
  if (!request.warn || !request.picture || result.statistics.partial) {
    return;
  }
  if (const std::optional<SceneWarning> warning =
          picture_warning(scene, picture_format_of(machine), background, result.picture)) {
    request.warn(*warning);
  }
}

SimulationResult simulate_checked(const Scene& scene, const Machine& machine,
                                  const SimulationRequest& request, const Continue& go_on) {
  check_extents(scene, request);
  check_units(machine, request);
  const auto packed = packed_scene<float>(scene, picture_format_of(machine));
  const MemoryMap map = checked_map(scene, machine, packed);
  const Machine roomy = with_room(machine, map);
  const std::optional<Calibration> calibration = calibration_of(scene, roomy, request);
  Machine priced = calibration ? with_costs(roomy, *calibration) : roomy;
  const FramePixels pixels = frame_pixels(scene, priced, request.record, request.executed,
                                          request.threads, legs_wanted(machine), request.warn);
  models::FrameSetup setup;
  setup.legs = pixels.legs;
  setup.useful_zone = pixels.zone;
  setup.background = firmware::rgb_of(packed.header.background);
  if (request.executed) {
    set_programs(packed, roomy, request.threads, setup);
  } else {
    set_images(packed, roomy, setup);
  }
  set_units(scene, packed, map, priced, setup);
  if (request.held != nullptr) {
    models::FrameSetup before;
    before.useful_zone = setup.useful_zone;
    const auto held = packed_scene<float>(*request.held, picture_format_of(machine));
    set_images(held, roomy, before);
    Machine of_held = priced;
    set_units(*request.held, held, map, of_held, before);
    load_changes(before, roomy, setup);
  }
  setup.keep_log = !request.snapshots.empty() || !request.shown_snapshots.empty() ||
                   request.facts.times || request.film;
  require_transfer_time(priced, setup);
  SimulationResult result = simulate_prepared(priced, request, *pixels.source, setup, go_on);
  if (request.facts.any()) {
    complete_facts(scene, priced, request, result);
  }
  result.statistics.costs = cost_statistics(priced, request.executed, calibration);
  result.times_from =
      calibration ? times_from(*calibration) : times_from(machine, request.executed);
  warn_of_picture(scene, machine, request, setup.background, result);
  if (!request.dumped_boards.empty()) {
    result.symbols = symbol_map(packed, machine);
  }
  return result;
}

}  // namespace

SimulationResult simulate(const Scene& scene, const Machine& machine,
                          const SimulationRequest& request, const Continue& go_on) {
  try {
    return simulate_checked(scene, machine, request, go_on);
  } catch (const std::invalid_argument& error) {
    throw DescriptionError(std::string("these parameters make no machine: ") + error.what());
  } catch (const std::overflow_error& error) {
    throw DescriptionError(error.what());
  } catch (const sc_core::sc_report& report) {
    throw DescriptionError(std::string("the machine does not work: ") + report.get_msg());
  }
}

}  // namespace maquette::sim
