#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "sim/report/run_directory.hpp"
#include "tools/benchmark/calibration_loop.hpp"
#include "tools/benchmark/child_process.hpp"
#include "tools/benchmark/rows.hpp"

namespace maquette::benchmark {

namespace {

/// Host times of the levels of the ladder `processor`, medians of five.
nlohmann::json host_times(const Paths& paths, const std::string& arithmetic) {
  const std::string directory = paths.scratch + "/processor_" + arithmetic;
  run_process({paths.program, "accuracy", paths.scene, "--quiet", "--ladder", "processor",
               "--repeats", "5", "--set", "board.arithmetic=" + arithmetic, "--outdir", directory});
  const std::string file = (std::filesystem::path(directory) / "host_times.json").string();
  return nlohmann::json::parse(sim::read_file(file)).at("levels");
}

double value_of(const nlohmann::json& levels, const std::string& name, const char* key) {
  for (const nlohmann::json& level : levels) {
    if (level.at("level") == name) {
      return level.at(key).get<double>();
    }
  }
  throw std::runtime_error("accuracy knows no level " + name);
}

}  // namespace

std::vector<Row> measure_processor(const Paths& paths) {
  constexpr double k_giga = 1e9;
  constexpr double k_milliseconds_per_s = 1e3;
  const auto seconds = [](const nlohmann::json& levels, const std::string& name) {
    return value_of(levels, name, "host_time_s");
  };
  const nlohmann::json priced = host_times(paths, "motorola_ffp");
  const nlohmann::json executed = host_times(paths, "maquette_ffp");
  const double instruction_s = seconds(executed, "instruction");
  const double rate = value_of(executed, "instruction", "cycles_per_host_second");
  const double steps_per_s = k_calibration_steps / calibration_loop_s();
  return {{"instruction_rate", rate / k_giga, "Gcycles/s", std::nullopt,
           "clocks of the executed program and package in a second of processor time"},
          {"calibration_loop", steps_per_s / k_giga, "Gsteps/s", std::nullopt,
           "steps of a fixed loop of plain C++ in the same run"},
          {"instruction_over_loop", rate / steps_per_s, "1", std::nullopt,
           "executed clocks for a step of that loop: the rate whatever the machine"},
          {"exact_instruction_rate",
           value_of(executed, "arithmetic by the host", "cycles_per_host_second") / k_giga,
           "Gcycles/s", std::nullopt, "the same with arithmetic by the host at its exact cost"},
          {"priced_instruction_rate",
           value_of(priced, "instruction", "cycles_per_host_second") / k_giga, "Gcycles/s",
           std::nullopt, "the same with arithmetic by the host, which costs what its table says"},
          {"instruction_over_counted", instruction_s / seconds(executed, "counted"), "1",
           std::nullopt, "processor time of a frame, executed over counted, calibration included"},
          {"instruction_over_tables", instruction_s / seconds(executed, "counted by tables"), "1",
           std::nullopt, "the same over counted at the costs of tables"},
          {"calibration",
           k_milliseconds_per_s *
               (seconds(executed, "counted") - seconds(executed, "counted by tables")),
           "ms", std::nullopt, "processor time of the pixels that tell the costs of a frame"}};
}

}  // namespace maquette::benchmark
