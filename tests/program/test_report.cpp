#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <vector>

#include "sim/maps/map_reading.hpp"
#include "sim/report/seconds.hpp"
#include "sim/report/statistics_json.hpp"
#include "sim/report/summary.hpp"
#include "tests/catch.hpp"
#include "tests/program/page_reader.hpp"
#include "tests/program/program.hpp"
#include "tests/sim/page/well_formed.hpp"

using namespace maquette::tests;
using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Runs the small scene with options and returns its run directory.
std::filesystem::path run_small(const ScratchDirectory& scratch, const std::string& name,
                                const std::string& options = "",
                                const std::string& scene = k_small_scene) {
  const std::string file = scratch.file(name + ".yaml", scene);
  const std::filesystem::path directory = scratch / name;
  const Outcome outcome = run_maquette("run " + file + k_small_frame + "--quiet --outdir " +
                                       directory.string() + " " + options);
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return directory;
}

/// The numbers in a text, as they are written.
std::vector<std::string> numbers_in(const std::string& text) {
  const std::regex number("[0-9]+(\\.[0-9]+)?");
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at) {
    found.push_back(at->str());
  }
  return found;
}

/// The summary without the host's time, and without the sum of the operations that it does not
/// list.
std::string told_figures(const Statistics& statistics) {
  const std::string summary = summarise(statistics, "", "", 0);
  return std::regex_replace(summary.substr(0, summary.find("\nhost ")),
                            std::regex("\nothers .*|; to look at it: .*"), "");
}

nlohmann::json data_of(const std::string& page, const std::string& id) {
  const std::string begin = "<script type=\"application/json\" id=\"" + id + "\">";
  const std::size_t at = page.find(begin);
  REQUIRE(at != std::string::npos);
  const std::size_t end = page.find("</script>", at);
  return nlohmann::json::parse(page.substr(at + begin.size(), end - at - begin.size()));
}

Statistics statistics_of(const std::filesystem::path& directory) {
  return parse_statistics(content_of(directory / "stats.json"), "stats.json");
}

}  // namespace

TEST_CASE("A page is well-formed and says every figure of the summary without scripts") {
  const ScratchDirectory scratch;
  for (const char* options : {"", "--set processors=20 --set allotment.assignment=on_demand",
                              "--processor instruction", "--set bus.level=ideal"}) {
    INFO(options);
    const auto directory = run_small(scratch, "run", options);
    const std::string page = report_of(directory);
    CHECK(ill_formed(page).empty());
    const std::vector<std::string> shown = numbers_in(read_by_people(page));
    for (const std::string& number : numbers_in(told_figures(statistics_of(directory)))) {
      INFO(number);
      CHECK(std::find(shown.begin(), shown.end(), number) != shown.end());
    }
  }
}

TEST_CASE("The bars of each board sum to the frame time, those of functions and rays to the work") {
  const ScratchDirectory scratch;
  const auto directory = run_small(scratch, "run", "--set processors=3");
  const std::string page = report_of(directory);
  const Statistics statistics = statistics_of(directory);
  const nlohmann::json boards = data_of(page, "boards-chart-data");
  for (std::size_t board = 0; board < statistics.boards.size(); ++board) {
    double sum = 0;
    for (const nlohmann::json& state : boards["series"]) {
      sum += state["values"][board].get<double>();
    }
    CHECK(std::abs(sum - in_seconds(statistics.frame.time)) < 1e-9);
  }
  for (const char* chart : {"functions-chart-data", "rays-chart-data"}) {
    double sum = 0;
    const nlohmann::json data = data_of(page, chart);
    for (const nlohmann::json& value : data["series"][0]["values"]) {
      sum += value.get<double>();
    }
    CHECK(std::abs(sum - in_seconds(statistics.functions.time)) < 1e-9);
  }
}

TEST_CASE(
    "The page of a machine with function units tells their states, queues and the bottleneck") {
  const ScratchDirectory scratch;
  for (const char* machine : {"intersection-units", "pipeline"}) {
    INFO(machine);
    const auto directory = run_small(scratch, "run", std::string("--machine ") + machine);
    const std::string page = report_of(directory);
    CHECK(ill_formed(page).empty());
    const Statistics statistics = statistics_of(directory);
    REQUIRE(statistics.units);
    const auto check_sums = [&](const char* chart, std::size_t rows) {
      const nlohmann::json data = data_of(page, chart);
      REQUIRE(data["labels"].size() == rows);
      for (std::size_t row = 0; row < rows; ++row) {
        double sum = 0;
        for (const nlohmann::json& state : data["series"]) {
          sum += state["values"][row].get<double>();
        }
        CHECK(std::abs(sum - in_seconds(statistics.frame.time)) < 1e-9);
      }
    };
    check_sums("units-chart-data", statistics.units->units.size());
    check_sums("boards-chart-data", statistics.boards.size());
    const std::string shown = read_by_people(page);
    CHECK_THAT(shown, ContainsSubstring("The bottleneck: " + statistics.units->bottleneck));
    for (const FunctionUnitStatistics& unit : statistics.units->units) {
      CHECK_THAT(shown, ContainsSubstring(std::to_string(unit.errands) + " errands, busy"));
    }
  }
  CHECK(report_of(run_small(scratch, "plain")).find("Function units") == std::string::npos);
}

TEST_CASE("A run writes the same page as a later report, and again the same bytes") {
  const ScratchDirectory scratch;
  const auto directory = run_small(scratch, "run", "--report --snapshot 1s");
  const std::string page = content_of(directory / "report.html");
  CHECK_THAT(page, ContainsSubstring("snapshot-1s"));
  CHECK(report_of(directory) == page);
  CHECK(report_of(directory) == page);
  CHECK_THAT(content_of(directory / "manifest.json"), ContainsSubstring("\"report.html\""));
  CHECK(page.size() < 2'000'000);
}

TEST_CASE("A page names no place of the machine and fetches nothing") {
  const ScratchDirectory scratch;
  const std::string page = report_of(run_small(scratch, "run"));
  CHECK_THAT(page, !ContainsSubstring(scratch.path().string()));
  CHECK_THAT(page, !ContainsSubstring(MAQUETTE_PROJECT_DIRECTORY));
  const std::regex attribute("(src|href)=\"([^\"]{0,20})");
  for (std::sregex_iterator at(page.begin(), page.end(), attribute), end; at != end; ++at) {
    INFO(at->str());
    CHECK((at->str(2).rfind("data:", 0) == 0 || at->str(2).rfind('#', 0) == 0));
  }
  CHECK_THAT(page, ContainsSubstring("default-src 'none'"));
}

TEST_CASE("A hostile name is text") {
  const ScratchDirectory scratch;
  std::string scene = k_small_scene;
  scene.replace(
      0, scene.find('\n'),
      "name: small\npaper_time: {value: 1 s, source: \"</dd><script>alert(1)</script>&\"}");
  const std::string page = report_of(run_small(scratch, "run", "", scene));
  CHECK(ill_formed(page).empty());
  CHECK_THAT(page, ContainsSubstring("&lt;script&gt;alert(1)"));
  CHECK_THAT(page, !ContainsSubstring("<script>alert"));
}

TEST_CASE("What differs from the prototype is told") {
  const ScratchDirectory scratch;
  const std::string page =
      read_by_people(report_of(run_small(scratch, "run", "--set board.clock=16MHz")));
  CHECK_THAT(page, ContainsSubstring("What differs from the prototype"));
  CHECK(std::regex_search(page, std::regex("board\\.clock\\s+8 MHz\\s+16 MHz")));
}

TEST_CASE("Maps of the pixels are layers of the picture, with the values of the file of maps") {
  const ScratchDirectory scratch;
  const auto directory = run_small(scratch, "run", "--report --set processors=2");
  const auto read = decode_maps(content_of(directory / "maps.exr"), "maps.exr");
  const nlohmann::json data = data_of(content_of(directory / "report.html"), "probe-data");
  std::vector<std::string> layers;
  for (const nlohmann::json& layer : data["layers"]) {
    layers.push_back(layer["name"]);
    const auto map =
        std::find_if(read.maps.begin(), read.maps.end(),
                     [&layer](const ReadMap& held) { return held.map->name == layer["name"]; });
    REQUIRE(map != read.maps.end());
    double high = 0;
    for (const double value : map->values) {
      high = std::isnan(value) ? high : std::max(high, value);
    }
    CHECK(layer["high"].get<double>() == high);
  }
  for (const char* name : {"time", "wait", "written", "board", "rays", "surface", "distance"}) {
    INFO(name);
    CHECK(std::find(layers.begin(), layers.end(), name) != layers.end());
  }
  CHECK(data["zone"]["width"] == read.zone.width);
}

TEST_CASE("Use and waits over the frame sum to those of the pixels' boards") {
  const ScratchDirectory scratch;
  const auto directory = run_small(scratch, "run", "--report --set processors=6");
  const Statistics statistics = statistics_of(directory);
  const nlohmann::json chart =
      data_of(content_of(directory / "report.html"), "bus-time-chart-data");
  std::vector<double> sums;
  for (const nlohmann::json& series : chart["series"]) {
    const auto& points = series["points"];
    sums.push_back(0);
    for (const nlohmann::json& point : points) {
      sums.back() += point["y"].get<double>() * in_seconds(statistics.frame.time) /
                     static_cast<double>(points.size());
    }
  }
  double transfer = 0;
  double wait = 0;
  for (const BoardStatistics& board : statistics.boards) {
    transfer += in_seconds(board.transfer);
    wait += in_seconds(board.wait_grant);
  }
  CHECK(std::abs(sums.at(0) - transfer) < 1e-3 * transfer);
  CHECK(std::abs(sums.at(1) - wait) < 1e-3 * wait);
}

TEST_CASE("Several runs stand side by side with what differs") {
  const ScratchDirectory scratch;
  const auto first = run_small(scratch, "first");
  const auto second = run_small(scratch, "second", "--set processors=2");
  const auto third = run_small(scratch, "third", "--set frame_memory.red=4bits");
  const std::string output = (scratch / "page.html").string();
  const Outcome outcome = run_maquette("report --output " + output + " " + first.string() + " " +
                                       second.string() + " " + third.string());
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const std::string page = content_of(output);
  CHECK(ill_formed(page).empty());
  const std::string shown = read_by_people(page);
  CHECK(std::regex_search(shown, std::regex("processors\\s+4\\s+2 \\(-50 %\\)\\s+4\\s")));
  CHECK_THAT(shown, ContainsSubstring("second against first: the pictures are equal."));
  CHECK(std::regex_search(shown, std::regex("third against first: [0-9]+ pixels differ")));
  CHECK(run_maquette("report " + first.string() + " " + scratch.path().string()).exit_code == 2);
}

TEST_CASE("What is no whole run directory is refused, and nothing is written") {
  const ScratchDirectory scratch;
  const auto refused = [](const std::string& arguments, const std::string& reason) {
    INFO(arguments);
    const Outcome outcome = run_maquette("report " + arguments);
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.errors, ContainsSubstring(reason));
    CHECK(outcome.output.empty());
  };
  refused("", "DIR");
  refused(scratch.path().string(), "holds no manifest.json; allowed");
  refused((scratch / "nothing").string(), "holds no manifest.json; allowed");
  const auto directory = run_small(scratch, "run");
  refused(directory.string() + " --output " + (directory / "stats.json").string(),
          "the command reads this file");
  refused(directory.string() + " --output " + (scratch / "no/where.html").string(),
          "no/where.html");
  for (const char* name : {"stats.json", "config.yaml", "frame.png", "manifest.json"}) {
    const std::string whole = content_of(directory / name);
    std::ofstream(directory / name, std::ios::binary) << whole.substr(0, whole.size() / 2);
    refused(directory.string(), name);
    std::filesystem::remove(directory / name);
    refused(directory.string(), name);
    std::ofstream(directory / name, std::ios::binary) << whole;
  }
  CHECK_FALSE(std::filesystem::exists(directory / "report.html"));
}

TEST_CASE("No other output of a run takes the page's place") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const std::string directory = (scratch / "run").string();
  const Outcome outcome = run_maquette("run " + scene + " --report --outdir " + directory +
                                       " --record " + directory + "/report.html");
  CHECK(outcome.exit_code == 2);
  CHECK_THAT(outcome.errors, ContainsSubstring("this file is written twice"));
}
