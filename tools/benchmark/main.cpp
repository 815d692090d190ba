#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/report/run_directory.hpp"
#include "tools/benchmark/rows.hpp"

namespace {

using maquette::benchmark::Paths;
using maquette::benchmark::Row;

/// A measurement that gives some rows.
struct Measurement {
  const char* name;
  std::vector<Row> (*measure)(const Paths& paths);
};

constexpr Measurement k_measurements[] = {{"simulation", maquette::benchmark::measure_simulation},
                                          {"counting", maquette::benchmark::measure_counting},
                                          {"two_threads", maquette::benchmark::measure_two_threads},
                                          {"bus", maquette::benchmark::measure_bus_levels},
                                          {"units", maquette::benchmark::measure_units},
                                          {"processor", maquette::benchmark::measure_processor},
                                          {"sweep", maquette::benchmark::measure_sweep},
                                          {"revolution", maquette::benchmark::measure_revolution},
                                          {"terrain", maquette::benchmark::measure_terrain},
                                          {"unions", maquette::benchmark::measure_unions},
                                          {"povray", maquette::benchmark::measure_povray},
                                          {"patches", maquette::benchmark::measure_patches},
                                          {"viewing", maquette::benchmark::measure_viewing}};

std::vector<std::string> measurement_names() {
  std::vector<std::string> names;
  for (const Measurement& measurement : k_measurements) {
    names.emplace_back(measurement.name);
  }
  return names;
}

std::string row_text(const Row& row) {
  const std::string bound = row.bound ? fmt::format("{:g}", *row.bound) : "";
  return fmt::format("{:<26}{:>8.3f} {:<9}{:>6}  {}\n", row.name, row.value, row.unit, bound,
                     row.meaning);
}

std::string rows_json(const std::vector<Row>& rows) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    json.push_back({{"name", row.name}, {"value", row.value}, {"unit", row.unit}});
    json.back()["bound"] = row.bound ? nlohmann::ordered_json(*row.bound) : nullptr;
  }
  return json.dump(2) + "\n";
}

std::vector<Row> measure(const std::vector<std::string>& wanted, const Paths& paths) {
  std::vector<Row> rows;
  fmt::print("{:<26}{:>8} {:<9}{:>6}\n", "row", "value", "unit", "bound");
  for (const Measurement& measurement : k_measurements) {
    const bool is_wanted =
        wanted.empty() || std::find(wanted.begin(), wanted.end(), measurement.name) != wanted.end();
    if (!is_wanted) {
      continue;
    }
    for (const Row& row : measurement.measure(paths)) {
      fmt::print("{}", row_text(row));
      std::fflush(stdout);
      rows.push_back(row);
    }
  }
  return rows;
}

int run(int argc, char** argv) {
  CLI::App program{"Measures maquette: ratios within one run, photo4, medians."};
  std::vector<std::string> wanted;
  std::string json_file;
  std::string plain_directory;
  program.add_option("ROW", wanted, "groups of rows to measure (default: all)")
      ->check(CLI::IsMember(measurement_names()));
  program.add_option("--json", json_file, "also write the rows to this file");
  program.add_option("--plain", plain_directory, "only render the plain frame into this directory");
  std::string empty_directory;
  program.add_option("--empty", empty_directory, "only write a picture of one pixel into it");
  CLI11_PARSE(program, argc, argv);

  const std::filesystem::path project = MAQUETTE_PROJECT_DIRECTORY;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path scratch =
      std::filesystem::temp_directory_path() / fmt::format("maquette-benchmark-{}", getpid());
  const Paths paths{
      self.parent_path() / "maquette",          self,    project / "scenes" / "photo4.yaml",
      project / "tools" / "benchmark" / "peer", project, scratch};
  if (!plain_directory.empty()) {
    maquette::benchmark::render_plain(paths, plain_directory);
    return 0;
  }
  if (!empty_directory.empty()) {
    maquette::benchmark::render_nothing(empty_directory);
    return 0;
  }
  std::filesystem::create_directories(scratch);
  const std::vector<Row> rows = measure(wanted, paths);
  std::filesystem::remove_all(scratch);
  if (!json_file.empty()) {
    const std::filesystem::path file = json_file;
    maquette::sim::write_files(file.has_parent_path() ? file.parent_path() : ".",
                               {{file.filename().string(), rows_json(rows)}});
  }
  return 0;
}

}  // namespace

// SystemC wants one, though nothing here simulates in this process.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench: {}\n", error.what());
    return 1;
  }
}
