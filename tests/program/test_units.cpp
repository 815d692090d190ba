#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/catch.hpp"
#include "tests/program/chrome_reader.hpp"
#include "tests/program/program.hpp"

/// Whole runs of machines with function units.

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr const char* k_glass = MAQUETTE_PROJECT_DIRECTORY "/scenes/effects/refraction.yaml";
constexpr const char* k_machines[] = {
    "--machine intersection-units", "--machine pipeline",
    "--set units.secondary_rays.number=2 --set units.secondary_rays.choice=by_pixel",
    "--set units.photometry.clock='80 MHz' --set units.combination.number=2 "
    "--set bus.arbitration=round_robin"};

Outcome run_into(const std::filesystem::path& directory, const std::string& options) {
  return run_maquette(std::string("run ") + k_glass + k_small_frame + "--outdir " +
                      directory.string() + " " + options);
}

nlohmann::json statistics_in(const std::filesystem::path& directory) {
  return nlohmann::json::parse(content_of(directory / "stats.json"));
}

void require_good(const Outcome& outcome) {
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
}

}  // namespace

TEST_CASE("Machines with units show the picture of those without, and do the same work") {
  const ScratchDirectory scratch;
  require_good(run_into(scratch / "plain", ""));
  const nlohmann::json plain = statistics_in(scratch / "plain");
  CHECK_FALSE(plain.contains("units"));
  for (const char* machine : k_machines) {
    INFO(machine);
    const Outcome outcome = run_into(scratch / "units", machine);
    require_good(outcome);
    CHECK_THAT(outcome.output, ContainsSubstring("\nbottleneck "));
    CHECK(content_of(scratch / "units" / "frame.png") ==
          content_of(scratch / "plain" / "frame.png"));
    const nlohmann::json units = statistics_in(scratch / "units");
    for (const char* what : {"work", "rays", "roots", "extents", "useful_zone"}) {
      CHECK(units[what] == plain[what]);
    }
    CHECK(units["units"]["units"].size() >= 1);
    CHECK(units["bus"]["masters"].size() ==
          units["boards"].size() + units["units"]["units"].size());
  }
}

TEST_CASE(
    "Machines with units have the same bytes for any number of threads, and at level signal") {
  const ScratchDirectory scratch;
  const std::string tiny = " --set frame_memory.width=32pixels --set frame_memory.height=24pixels";
  for (const std::string machine : k_machines) {
    INFO(machine);
    require_good(run_into(scratch / "one", machine + tiny + " --threads 1"));
    require_good(run_into(scratch / "four", machine + tiny + " --threads 4"));
    CHECK(content_of(scratch / "one" / "stats.json") ==
          content_of(scratch / "four" / "stats.json"));
    require_good(run_into(scratch / "lines", machine + tiny + " --bus signal"));
    CHECK(content_of(scratch / "one" / "stats.json") ==
          content_of(scratch / "lines" / "stats.json"));
  }
}

TEST_CASE("The configuration of a machine with units runs again to the same bytes") {
  const ScratchDirectory scratch;
  require_good(run_into(scratch / "first", k_machines[0]));
  const Outcome again = run_maquette("run " + (scratch / "first" / "config.yaml").string() +
                                     " --outdir " + (scratch / "again").string());
  require_good(again);
  for (const char* name : {"stats.json", "frame.png", "config.yaml"}) {
    CHECK(content_of(scratch / "first" / name) == content_of(scratch / "again" / name));
  }
}

TEST_CASE("A record that was made for a machine with units replays on all, others are refused") {
  const ScratchDirectory scratch;
  const std::string record = (scratch / "legs.exr").string();
  require_good(run_into(scratch / "recording", std::string(k_machines[0]) + " --record " + record));
  for (const char* machine : k_machines) {
    INFO(machine);
    require_good(run_into(scratch / "direct", machine));
    require_good(run_into(scratch / "replayed",
                          std::string(machine) + " --processor recorded --record " + record));
    for (const char* name : {"stats.json", "frame.png", "config.yaml"}) {
      CHECK(content_of(scratch / "direct" / name) == content_of(scratch / "replayed" / name));
    }
  }
  const std::string plain = (scratch / "plain.exr").string();
  require_good(run_into(scratch / "plain", "--record " + plain));
  const Outcome refused = run_into(
      scratch / "refused", std::string(k_machines[0]) + " --processor recorded --record " + plain);
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.errors, ContainsSubstring("made (--record) for a machine with units"));
}

TEST_CASE("Traces have a track for each unit") {
  const ScratchDirectory scratch;
  require_good(run_into(scratch / "traced", std::string(k_machines[0]) +
                                                " --trace bus.json --trace-window '0 s..2 s'"));
  const std::string trace = content_of(scratch / "traced" / "bus.json");
  for (const char* unit : {"board3", "intersection0", "intersection3"}) {
    CHECK_THAT(trace, ContainsSubstring(std::string(unit) + " (level "));
  }
}

TEST_CASE("Traces have an arrow for all that is handed over, from its request to its arrival") {
  const ScratchDirectory scratch;
  require_good(run_into(scratch / "traced", std::string(k_machines[1]) +
                                                " --trace bus.json --trace bus.svg"
                                                " --trace-window '100 ms..250 ms'"));
  const ChromeTraceReader trace(content_of(scratch / "traced" / "bus.json"));
  std::map<std::pair<std::string, std::string>, int> arrows;  // by the tracks' names
  for (const Arrow& arrow : trace.arrows) {
    const std::string to = trace.thread_name(arrow.to_track);
    if (to == "owner") {
      continue;  // a grant
    }
    const std::string from = trace.thread_name(arrow.from_track);
    ++arrows[{from.substr(0, from.find(' ')), to.substr(0, to.find(' '))}];
    const std::vector<Slice> slices = trace.slices("boards", from);
    CHECK(std::any_of(slices.begin(), slices.end(), [&arrow](const Slice& slice) {
      return slice.name == "transfer" && slice.to == arrow.to;
    }));
  }
  const auto between = [&arrows](const char* from, const char* to) { return arrows[{from, to}]; };
  CHECK(between("board0", "extents0") > 0);
  CHECK(between("extents0", "intersection0") > 0);
  CHECK(between("intersection0", "extents0") > 0);
  CHECK(between("photometry0", "board0") > 0);
  CHECK(between("board0", "board0") == 0);
  CHECK_THAT(content_of(scratch / "traced" / "bus.svg"), ContainsSubstring("class=\"errand\""));
}

TEST_CASE("A program that boards execute hands out no errands") {
  const ScratchDirectory scratch;
  const Outcome refused =
      run_into(scratch / "executed", std::string(k_machines[0]) + " --processor instruction");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.errors, ContainsSubstring("hands out errands; allowed: --processor counted"));
}

TEST_CASE("A scene that does not fit a unit says so") {
  const ScratchDirectory scratch;
  const std::string run = "run " MAQUETTE_PROJECT_DIRECTORY "/scenes/photo4.yaml --outdir " +
                          (scratch / "small").string() +
                          " --set units.intersection.number=1 --set 'units.intersection.ram=1 KiB'";
  const Outcome refused = run_maquette(run);
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.errors, ContainsSubstring("photo4.yaml:") &&
                                 ContainsSubstring("raise units.intersection.ram"));
}

TEST_CASE("Pixels in flight that could fill two kinds of units are refused with their place") {
  const ScratchDirectory scratch;
  const std::filesystem::path machine = scratch / "machine.yaml";
  const auto in_flight = [&](int pixels) {
    std::ofstream(machine)
        << "name: two\nprocessors: 1\nboard: {ram: 512 KiB}\nunits:\n  in_flight: " << pixels
        << "\n  extents: {queue: 2}\n  photometry: {queue: 3}\n";
    return run_into(scratch / "run", "--machine " + machine.string());
  };
  require_good(in_flight(6));
  const Outcome refused = in_flight(7);
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.errors, ContainsSubstring("machine.yaml:5:") &&
                                 ContainsSubstring("up to 6 or a longer queue"));
}
