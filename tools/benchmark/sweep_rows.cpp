#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "sim/report/run_directory.hpp"
#include "tools/benchmark/child_process.hpp"
#include "tools/benchmark/rows.hpp"

namespace maquette::benchmark {

namespace {

constexpr int k_points = 200;
constexpr int k_fewest_points = 2;  // fewer would share no record

/// Simulates machines that differ in their arbitration.
ProcessUsage sweep(const Paths& paths, int points, const std::string& directory) {
  return run_process({paths.program, "sweep", paths.scene, "--quiet", "--vary",
                      "bus.arbitration_clocks=1.." + std::to_string(points) + " clocks", "--outdir",
                      directory});
}

double manifest_value(const std::string& directory, const std::string& key) {
  const std::string file = (std::filesystem::path(directory) / "manifest.json").string();
  return nlohmann::json::parse(sim::read_file(file)).at(key).get<double>();
}

}  // namespace

std::vector<Row> measure_sweep(const Paths& paths) {
  const std::string few = paths.scratch + "/few_points";
  const std::string many = paths.scratch + "/many_points";
  const ProcessUsage start = sweep(paths, k_fewest_points, few);
  const ProcessUsage whole = sweep(paths, k_points, many);
  constexpr double k_mebibyte = 1024 * 1024;
  constexpr double k_milliseconds_per_s = 1e3;
  constexpr double k_thousand = 1e3;
  const double jobs = manifest_value(many, "jobs");
  const double point_memory = manifest_value(many, "peak_point_memory_bytes");
  const double own_memory = manifest_value(many, "peak_memory_bytes");
  const double point_s =
      (whole.processor_time_s - start.processor_time_s) / (k_points - k_fewest_points);
  return {{"sweep_rate", k_points / whole.wall_time_s, "points/s", std::nullopt,
           "machines simulated with one recorded frame, a process per processor, wall time"},
          {"sweep_point", point_s * k_milliseconds_per_s, "ms", std::nullopt,
           "processor time of one more point"},
          {"sweep_thousand", k_thousand * whole.wall_time_s / k_points, "s", 30,
           "wall time of a thousand points at that rate; the bound is for two processors"},
          {"sweep_point_memory", point_memory / k_mebibyte, "MiB", std::nullopt,
           "peak of the largest point, the shared frame included"},
          {"sweep_memory", (own_memory + jobs * point_memory) / k_mebibyte, "MiB", std::nullopt,
           "at most, of all processes; what they share is counted in each"}};
}

}  // namespace maquette::benchmark
