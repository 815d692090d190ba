#include <random>

#include "sim/report/statistics_json.hpp"
#include "tests/catch.hpp"
#include "tests/program/program.hpp"
#include "tests/program/vcd_reader.hpp"

namespace {

using namespace maquette::tests;
using maquette::sim::parse_statistics;
using maquette::sim::Statistics;

struct Traced {
  Statistics statistics;
  std::string text;
  std::string lines;  // the value change dumps
  std::string accesses;
};

std::string command(const ScratchDirectory& scratch, const std::string& options) {
  return "run " + scratch.file("small.yaml", k_small_scene) +
         " --set frame_memory.width=24pixels --set frame_memory.height=18pixels --quiet --outdir " +
         (scratch / "run").string() + " " + options;
}

Traced trace(const std::string& options) {
  const ScratchDirectory scratch;
  const Outcome outcome = run_maquette(
      command(scratch, "--bus signal --trace-lines " + (scratch / "lines.vcd").string() +
                           " --trace " + (scratch / "accesses.vcd").string() + " " + options));
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const std::string text = content_of(scratch / "run" / "stats.json");
  return {parse_statistics(text, "stats.json"), text, content_of(scratch / "lines.vcd"),
          content_of(scratch / "accesses.vcd")};
}

const char* const k_machines[] = {
    "--set processors=3 --set boards.request_level=2 --set bus.arbitration=round_robin",
    "--set processors=5 --set board.clock='400 MHz'",
    "--set processors=3 --set board.release=block --set board.pixel_write=line",
    "--set processors=4 --set frame_memory.ports=2 --set bus.data_width='32 bits'",
};

// A line that floats is high.
VcdReader::Values terminated(const VcdReader::Values& values) {
  VcdReader::Values kept;
  for (const auto& [instant, value] : values) {
    const std::string shown = value == "z" ? "1" : value;
    if (kept.empty() || kept.back().second != shown) {
      kept.emplace_back(instant, shown);
    }
  }
  return kept;
}

}  // namespace

TEST_CASE("what the lines of a frame show is what its accesses say") {
  for (const std::string machine : k_machines) {
    INFO(machine);
    const Traced traced = trace(machine);
    const VcdReader lines(traced.lines);
    const VcdReader accesses(traced.accesses);
    CHECK(lines.time_scale == "1 ps");
    CHECK(lines.first == 0);
    CHECK(lines.last == traced.statistics.frame.time.count());
    const bool has_ports = machine.find("ports") != std::string::npos;
    std::int64_t transferred = 0;
    for (const std::string bus : {"versabus", "versabus1"}) {
      if (bus == "versabus1" && !has_ports) {
        continue;
      }
      INFO(bus);
      for (const char* line : {"AS_n", "DS0_n", "DTACK_n"}) {
        const char* const same = line == std::string("DS0_n") ? "DS_n" : line;
        CHECK(lines.time_with(bus + "." + line, "0") == accesses.time_with(bus + "." + same, "0"));
      }
      CHECK(lines.time_with(bus + ".BERR_n", "0") == 0);
      CHECK(lines.time_with(bus + ".BBSY_n", "0") == accesses.time_with(bus + ".BBSY_n", "0"));
      CHECK(lines.time_with(bus + ".AS_n", "0") == lines.time_with(bus + ".DS1_n", "0"));
      CHECK(terminated(lines.signals.at(bus + ".WRITE_n")) ==
            terminated(accesses.signals.at(bus + ".WRITE_n")));
      transferred += lines.time_with(bus + ".AS_n", "0");
    }
    std::int64_t expected = 0;
    for (const auto& board : traced.statistics.boards) {
      expected += board.transfer.count();
    }
    CHECK(transferred == expected);
    CHECK(lines.signals.count("versabus.BGOUT_board0_n") == 1);
    CHECK(lines.signals.count("versabus1.BGOUT_board1_n") == (has_ports ? 1U : 0U));
  }
}

TEST_CASE("a window's lines are the frame's lines in that window") {
  std::mt19937 random(19);
  const std::string machine = k_machines[1];
  const Traced whole = trace(machine);
  const VcdReader all(whole.lines);
  const VcdReader::Values& strobe = all.signals.at("versabus.AS_n");
  for (int one = 0; one < 8; ++one) {
    const std::size_t first = random() % (strobe.size() - 20);
    const std::int64_t from = strobe[first].first + static_cast<std::int64_t>(random() % 2);
    const std::int64_t to = strobe[first + 1 + random() % 18].first + 1;
    INFO(from << ".." << to);
    const VcdReader part(trace(machine + " --trace-window " + std::to_string(from) + "ps.." +
                               std::to_string(to) + "ps")
                             .lines);
    CHECK(part.first == from);
    CHECK(part.last == to);
    REQUIRE(part.signals.size() == all.signals.size());
    for (const auto& [line, values] : part.signals) {
      VcdReader::Values expected{{from, all.value(line, from)}};
      for (const auto& change : all.signals.at(line)) {
        if (change.first > from && change.first < to) {
          expected.push_back(change);
        }
      }
      INFO(line);
      CHECK(values == expected);
    }
  }
}

TEST_CASE("looking at the lines changes no result, and the same run shows the same") {
  const Traced first = trace(k_machines[0]);
  const Traced second = trace(std::string(k_machines[0]) + " --threads 2");
  CHECK(first.lines == second.lines);
  const ScratchDirectory scratch;
  REQUIRE(run_maquette(command(scratch, std::string("--bus signal ") + k_machines[0])).exit_code ==
          0);
  CHECK(content_of(scratch / "run" / "stats.json") == first.text);
}

TEST_CASE("lines that there are not to see are refused before anything runs") {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "lines.vcd").string();
  const struct {
    std::string options;
    std::string expected;
  } cases[] = {
      {"--trace-lines " + file, "bus.level signal is allowed with it"},
      {"--bus ideal --trace-lines " + file, "bus.level signal is allowed with it"},
      {"--bus signal --trace-lines lines.json", "allowed: .vcd"},
      {"--bus signal --trace-lines " + file + " --trace " + file, "given twice"},
      {"--bus signal --trace-lines " + (scratch / "none" / "l.vcd").string(), "cannot be written"},
      {"--bus signal --trace-lines " + file + " --trace-window 2s..1s", "empty window"},
      {"--bus signal --trace-lines " + file + " --trace-boards 1", "--trace FILE"},
      {"--bus signal --trace-window 1s..2s", "--trace-lines FILE"},
  };
  for (const auto& one : cases) {
    const Outcome outcome = run_maquette(command(scratch, one.options));
    INFO(one.options << "\n" << outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.errors, Catch::Matchers::ContainsSubstring(one.expected));
    CHECK_FALSE(std::filesystem::exists(scratch / "run" / "stats.json"));
    CHECK_FALSE(std::filesystem::exists(file));
  }
}

TEST_CASE("a window after the frame shows the lines at its end, and it is said") {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "lines.vcd").string();
  const Outcome outcome = run_maquette(
      command(scratch, "--bus signal --trace-window '1000000 s..' --trace-lines " + file));
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.errors,
             Catch::Matchers::ContainsSubstring("lines.vcd: is empty, the frame ended after"));
  const VcdReader lines(content_of(file));
  CHECK(lines.first == lines.last);
}
