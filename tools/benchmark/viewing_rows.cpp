#include <filesystem>
#include <string>
#include <vector>

#include "sim/maps/map_table.hpp"
#include "tools/benchmark/median.hpp"
#include "tools/benchmark/rows.hpp"
#include "tools/benchmark/simulation_process.hpp"

namespace maquette::benchmark {

namespace {

constexpr int k_repetitions = 5;
constexpr int k_pictures = 50;
constexpr int k_fewest_pictures = 1;
constexpr int k_gif_pictures = 10;

using Arguments = std::vector<std::string>;

ProcessUsage run(const Paths& paths, const Arguments& arguments) {
  return run_simulation(paths, "viewed", arguments);
}

Arguments with(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// A page with every map that a run of counted work has.
double page_bytes(const Paths& paths) {
  Arguments arguments{"--report"};
  for (const sim::Map& map : sim::all_maps()) {
    if (map.name != "count_error") {
      arguments = with(arguments, {"--map", map.name});
    }
  }
  run(paths, arguments);
  return static_cast<double>(std::filesystem::file_size(paths.scratch + "/viewed/report.html"));
}

Arguments film(const std::string& place, int pictures) {
  return {"--film", place, "--film-frames", std::to_string(pictures)};
}

}  // namespace

std::vector<Row> measure_viewing(const Paths& paths) {
  const Arguments maps{"--map", "time", "--map", "rays", "--map", "wait", "--map", "surface"};
  const std::string record = paths.scratch + "/viewed.exr";
  run(paths, {"--record", record});
  const Arguments recorded{"--processor", "recorded", "--record", record};
  std::vector<double> report_s;
  std::vector<double> report_ratio;
  std::vector<double> maps_s;
  std::vector<double> film_s;
  std::vector<double> gif_s;
  for (int i = 0; i < k_repetitions; ++i) {
    const double plain = run(paths, {}).processor_time_s;
    const double reported = run(paths, {"--report"}).processor_time_s;
    report_s.push_back(reported - plain);
    report_ratio.push_back(reported / plain);
    maps_s.push_back(run(paths, with(recorded, maps)).processor_time_s);
    film_s.push_back(run(paths, with(recorded, film("film", k_pictures))).processor_time_s);
    const double many =
        run(paths, with(recorded, film("film.gif", k_gif_pictures))).processor_time_s;
    const double one =
        run(paths, with(recorded, film("film.gif", k_fewest_pictures))).processor_time_s;
    gif_s.push_back((many - one) / (k_gif_pictures - k_fewest_pictures));
  }
  constexpr double k_milliseconds_per_s = 1e3;
  constexpr double k_megabyte = 1e6;
  return {{"report_beyond_run", median(report_s), "s", 0.5,
           "processor time of a run with its page, less that of the run"},
          {"report_over_run", median(report_ratio), "1", std::nullopt, "the same as a ratio"},
          {"maps_from_record", median(maps_s), "s", 1,
           "four maps of a recorded frame, whole process, processor time"},
          {"film_from_record", median(film_s), "s", 1,
           "fifty pictures of a recorded frame in a folder, whole process, processor time"},
          {"film_gif_picture", median(gif_s) * k_milliseconds_per_s, "ms", std::nullopt,
           "of one more picture in an animated GIF, whose palette OpenImageIO makes"},
          {"page_size", page_bytes(paths) / k_megabyte, "MB", 6, "a page with all maps as layers"}};
}

}  // namespace maquette::benchmark
