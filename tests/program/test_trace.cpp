#include <algorithm>
#include <numeric>
#include <random>
#include <regex>

#include "sim/report/statistics_json.hpp"
#include "sim/trace/chrome_trace.hpp"
#include "sim/trace/vcd_trace.hpp"
#include "tests/catch.hpp"
#include "tests/program/chrome_reader.hpp"
#include "tests/program/program.hpp"
#include "tests/program/vcd_reader.hpp"

using namespace maquette::tests;
using maquette::sim::BusRecord;
using maquette::sim::expected_chrome_trace_bytes;
using maquette::sim::expected_vcd_trace_bytes;
using maquette::sim::parse_statistics;
using maquette::sim::Statistics;

namespace {

constexpr const char* k_states[] = {"compute", "wait for grant", "transfer", "idle"};

// Machines that differ in how they use the bus. A fast processor makes it busy.
const char* const k_machines[] = {
    "--set processors=3 --set boards.request_level=2 --set allotment.assignment=on_demand "
    "--set bus.arbitration=round_robin",
    "--set processors=5 --set bus.arbitration=round_robin --set board.clock='400 MHz'",
    "--set processors=3 --set board.release=block --set board.pixel_write=line",
    "--set processors=2 --set bus.data_width='32 bits' --set bus.arbitration_clocks=0clocks",
    "--set processors=2 --set bus.clock='1 kHz'",
};

struct Traced {
  Statistics statistics;
  std::string json;
  std::string vcd;
};

Traced trace(const std::string& options) {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const Outcome outcome = run_maquette(
      "run " + scene + " --set frame_memory.width=24pixels --set frame_memory.height=18pixels " +
      "--quiet --outdir " + (scratch / "run").string() + " --trace " +
      (scratch / "t.json").string() + " --trace " + (scratch / "t.vcd").string() + " " + options);
  INFO(options << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return {parse_statistics(content_of(scratch / "run" / "stats.json"), "stats.json"),
          content_of(scratch / "t.json"), content_of(scratch / "t.vcd")};
}

std::vector<Slice> board_slices(const ChromeTraceReader& reader, std::size_t board, int level) {
  return reader.slices("boards",
                       "board" + std::to_string(board) + " (level " + std::to_string(level) + ")");
}

std::int64_t time_in(const std::vector<Slice>& slices, const std::string& name) {
  return std::accumulate(slices.begin(), slices.end(), std::int64_t{0},
                         [&name](std::int64_t sum, const Slice& slice) {
                           return sum + (slice.name == name ? slice.to - slice.from : 0);
                         });
}

void check_tiling(const std::vector<Slice>& slices, std::int64_t from, std::int64_t to) {
  REQUIRE_FALSE(slices.empty());
  REQUIRE(slices.front().from == from);
  REQUIRE(slices.back().to == to);
  for (std::size_t i = 1; i < slices.size(); ++i) {
    REQUIRE(slices[i].from == slices[i - 1].to);
  }
}

// What of slices lies in a window.
std::vector<Slice> clipped(const std::vector<Slice>& slices, std::int64_t from, std::int64_t to) {
  std::vector<Slice> result;
  for (Slice slice : slices) {
    slice.from = std::max(slice.from, from);
    slice.to = std::min(slice.to, to);
    if (slice.from < slice.to) {
      result.push_back(slice);
    }
  }
  return result;
}

double value_at(const std::vector<std::pair<std::int64_t, double>>& values, std::int64_t instant) {
  double value = -1;
  for (const auto& [from, what] : values) {
    value = from <= instant ? what : value;
  }
  return value;
}

// The integral of a counter up to an instant.
double integral(const std::vector<std::pair<std::int64_t, double>>& values, std::int64_t end) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::int64_t to = i + 1 < values.size() ? values[i + 1].first : end;
    sum += values[i].second * static_cast<double>(to - values[i].first);
  }
  return sum;
}

// Instants at which cutting a trace is hard: edges and middles of the slices of the bus's owner and
// of two boards' waits.
std::vector<std::int64_t> cuts_of(const ChromeTraceReader& reader, int level) {
  std::vector<Slice> slices = reader.slices("versabus", "owner");
  for (std::size_t board = 0; board < 2; ++board) {
    for (const Slice& slice : board_slices(reader, board, level)) {
      if (slice.name == k_states[1]) {
        slices.push_back(slice);
      }
    }
  }
  std::vector<std::int64_t> cuts;
  for (const Slice& slice : slices) {
    cuts.insert(cuts.end(), {slice.from, slice.from + (slice.to - slice.from) / 2, slice.to});
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

int level_of(const std::string& machine) {
  return machine.find("request_level=2") != std::string::npos ? 2 : 0;
}

}  // namespace

TEST_CASE("the Chrome trace of a frame tiles it with the states that its statistics sum up") {
  for (const std::string machine : k_machines) {
    INFO(machine);
    const Traced traced = trace(machine);
    const ChromeTraceReader reader(traced.json);
    const std::int64_t end = traced.statistics.frame.time.count();
    REQUIRE(reader.threads() == traced.statistics.boards.size() + 1);
    const auto owner = reader.slices("versabus", "owner");
    std::int64_t waited = 0;
    std::int64_t transferred = 0;
    for (std::size_t i = 0; i < traced.statistics.boards.size(); ++i) {
      const auto& board = traced.statistics.boards[i];
      const auto slices = board_slices(reader, i, level_of(machine));
      check_tiling(slices, 0, end);
      CHECK(time_in(slices, k_states[0]) == board.compute.count());
      CHECK(time_in(slices, k_states[1]) == board.wait_grant.count());
      CHECK(time_in(slices, k_states[2]) == board.transfer.count());
      CHECK(time_in(slices, k_states[3]) == board.idle.count());
      CHECK(time_in(owner, board.name) == board.transfer.count());
      waited += board.wait_grant.count();
      transferred += board.transfer.count();
    }
    CHECK(transferred == traced.statistics.bus.busy.count());
    const auto& queue = reader.counters.at({"versabus", "queue length"});
    CHECK(integral(queue, end) == static_cast<double>(waited));
    const auto longest = std::max_element(queue.begin(), queue.end(),
                                          [](auto& a, auto& b) { return a.second < b.second; });
    CHECK(longest->second == traced.statistics.bus.queue.longest);
    const auto& busy = reader.counters.at({"versabus", "utilisation over 1 ms"});
    CHECK(integral(busy, end) == Approx(static_cast<double>(transferred)).epsilon(1e-9));
  }
}

TEST_CASE("each wait has an arrow from its request to the grant of the same board") {
  for (const std::string machine : k_machines) {
    INFO(machine);
    const Traced traced = trace(machine);
    const ChromeTraceReader reader(traced.json);
    std::size_t waits = 0;
    for (std::size_t i = 0; i < traced.statistics.boards.size(); ++i) {
      const auto slices = board_slices(reader, i, level_of(machine));
      waits += static_cast<std::size_t>(
          std::count_if(slices.begin(), slices.end(),
                        [](const Slice& slice) { return slice.name == k_states[1]; }));
    }
    REQUIRE(reader.arrows.size() == waits);
    for (const Arrow& arrow : reader.arrows) {
      const Slice& wait = *reader.slice_at(arrow.from_track, arrow.from);
      const Slice& transfer = *reader.slice_at(arrow.to_track, arrow.to);
      REQUIRE(wait.name == k_states[1]);
      REQUIRE(wait.from == arrow.from);
      REQUIRE(wait.to == arrow.to);
      REQUIRE(transfer.from == arrow.to);
      REQUIRE(reader.thread_name(arrow.from_track).rfind(transfer.name + " ", 0) == 0);
    }
  }
}

TEST_CASE("the VCD of a frame has the states that its statistics sum up, and lines that agree") {
  for (const std::string machine : k_machines) {
    INFO(machine);
    const Traced traced = trace(machine);
    const VcdReader reader(traced.vcd);
    CHECK(reader.time_scale == "1 ps");
    CHECK(reader.first == 0);
    CHECK(reader.last == traced.statistics.frame.time.count());
    std::int64_t transferred = 0;
    for (const auto& board : traced.statistics.boards) {
      CHECK(reader.time_with(board.name + "." + board.name + "_state", "0") ==
            board.compute.count());
      CHECK(reader.time_with(board.name + "." + board.name + "_state", "1") ==
            board.wait_grant.count());
      CHECK(reader.time_with(board.name + "." + board.name + "_BR_n", "0") ==
            board.wait_grant.count());
      CHECK(reader.time_with(board.name + "." + board.name + "_state", "10") ==
            board.transfer.count());
      CHECK(reader.time_with(board.name + "." + board.name + "_state", "11") == board.idle.count());
      transferred += board.transfer.count();
    }
    CHECK(reader.time_with("versabus.AS_n", "0") == transferred);
    CHECK(reader.signals.at("versabus.DS_n") == reader.signals.at("versabus.AS_n"));
    CHECK(reader.time_with("versabus.BBSY_n", "0") >= transferred);
    CHECK(reader.time_with("versabus.BERR_n", "0") == 0);
    CHECK(reader.time_with("versabus.WRITE_n", "z") ==
          traced.statistics.frame.time.count() - transferred);
    // Of the lines, at each instant of a change: who transfers is the owner, on a bus that is busy.
    for (std::size_t i = 0; i < traced.statistics.boards.size(); ++i) {
      const std::string name = traced.statistics.boards[i].name;
      const auto& states = reader.signals.at(name + "." + name + "_state");
      for (std::size_t change = 0; change < states.size(); change += 1 + states.size() / 200) {
        const auto& [instant, state] = states[change];
        if (state == "10") {
          REQUIRE(std::stoull(reader.value("versabus.owner", instant), nullptr, 2) == i);
          REQUIRE(reader.value("versabus.BBSY_n", instant) == "0");
          REQUIRE(reader.value("versabus.AS_n", instant) == "0");
        }
        if (state == "1") {
          REQUIRE(reader.value("versabus.BR" + std::to_string(level_of(machine)) + "_n", instant) ==
                  "0");
        }
      }
    }
  }
}

TEST_CASE("the expected length of a trace is near the real one") {
  for (const std::string machine : k_machines) {
    INFO(machine);
    const Traced traced = trace(machine);
    const std::size_t waits = ChromeTraceReader(traced.json).arrows.size();
    BusRecord record;
    record.buses.resize(1);
    record.buses[0].accesses.resize(static_cast<std::size_t>(traced.statistics.bus.transfers));
    for (std::size_t i = 0; i < waits; ++i) {
      record.buses[0].accesses[i].grant = maquette::models::Instant(1);
    }
    CHECK(static_cast<double>(expected_chrome_trace_bytes(record)) ==
          Approx(static_cast<double>(traced.json.size())).epsilon(0.25));
    CHECK(static_cast<double>(expected_vcd_trace_bytes(record)) ==
          Approx(static_cast<double>(traced.vcd.size())).epsilon(0.25));
  }
}

TEST_CASE("a block that keeps the bus is one tenure of its board, seen on both traces") {
  const Traced traced = trace(k_machines[2]);
  const auto owner = ChromeTraceReader(traced.json).slices("versabus", "owner");
  std::int64_t kept = 0;
  for (std::size_t i = 1; i < owner.size(); ++i) {
    if (owner[i].name.rfind("kept by ", 0) == 0) {
      REQUIRE(owner[i].name == "kept by " + owner[i - 1].name);
      REQUIRE(owner[i].from == owner[i - 1].to);
      kept += owner[i].to - owner[i].from;
    }
  }
  CHECK(kept > 0);
  CHECK(VcdReader(traced.vcd).time_with("versabus.BBSY_n", "0") ==
        traced.statistics.bus.busy.count() + kept);
}

TEST_CASE("a window's trace is the frame's trace in that window, on every track") {
  std::mt19937 random(17);
  for (const std::string machine : k_machines) {
    const Traced whole = trace(machine);
    const ChromeTraceReader all(whole.json);
    const VcdReader all_lines(whole.vcd);
    const std::vector<std::int64_t> cuts = cuts_of(all, level_of(machine));
    for (int i = 0; i < 6; ++i) {
      const std::size_t first = random() % (cuts.size() - 1);
      const std::size_t step = 1 + random() % (i < 3 ? 10 : cuts.size() - first);
      const std::int64_t from = cuts[first];
      const std::int64_t to = cuts[std::min(first + step, cuts.size() - 1)];
      const std::string window = std::to_string(from) + "ps.." + std::to_string(to) + "ps";
      INFO(machine << " " << window);
      const Traced part = trace(machine + " --trace-window " + window + " --trace-boards 0..1");
      const ChromeTraceReader some(part.json);
      REQUIRE(some.threads() == 3);
      for (std::size_t board = 0; board < 2; ++board) {
        const auto slices = board_slices(some, board, level_of(machine));
        check_tiling(slices, from, to);
        REQUIRE(slices == clipped(board_slices(all, board, level_of(machine)), from, to));
      }
      REQUIRE(some.slices("versabus", "owner") ==
              clipped(all.slices("versabus", "owner"), from, to));
      const auto& queue = some.counters.at({"versabus", "queue length"});
      REQUIRE(queue.front().first == from);
      for (const auto& [instant, value] : queue) {
        REQUIRE(value == value_at(all.counters.at({"versabus", "queue length"}), instant));
      }
      std::size_t arrows = 0;
      for (const Arrow& arrow : all.arrows) {
        arrows += arrow.from >= from && arrow.to < to && arrow.from_track.second <= 2 ? 1 : 0;
      }
      REQUIRE(some.arrows.size() == arrows);

      const VcdReader lines(part.vcd);
      REQUIRE(lines.first == from);
      REQUIRE(lines.last == to);
      for (const auto& [signal, values] : lines.signals) {
        VcdReader::Values expected{{from, all_lines.value(signal, from)}};
        for (const auto& change : all_lines.signals.at(signal)) {
          if (change.first > from && change.first < to) {
            expected.push_back(change);
          }
        }
        INFO(signal);
        REQUIRE(values == expected);
      }
    }
  }
}

TEST_CASE("tracing changes no result, and the same run gives the same trace") {
  const Traced first = trace(k_machines[0]);
  const Traced second = trace(std::string(k_machines[0]) + " --threads 2");
  CHECK(first.json == second.json);
  CHECK(first.vcd == second.vcd);
  CHECK(statistics_json(first.statistics) == statistics_json(second.statistics));
}

TEST_CASE("the VCD is read by GTKWave's converter, where it is installed") {
  if (std::system("command -v vcd2fst >/dev/null 2>&1") != 0) {
    WARN("vcd2fst is not installed");
    return;
  }
  const ScratchDirectory scratch;
  const std::string vcd = scratch.file("t.vcd", trace(k_machines[1]).vcd);
  const std::string fst = (scratch / "t.fst").string();
  CHECK(std::system(("vcd2fst " + vcd + " " + fst + " >/dev/null 2>&1").c_str()) == 0);
  CHECK(std::filesystem::file_size(fst) > 1000);
}

TEST_CASE("the save file beside a VCD names all of its signals, each in the group of its scope") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const Outcome outcome = run_maquette("run " + scene + k_small_frame + "--quiet --outdir " +
                                       (scratch / "run").string() + " --trace bus.vcd");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const std::string view = content_of(scratch / "run" / "bus.gtkw");
  CHECK(view.find("\n[dumpfile] \"bus.vcd\"\n") != std::string::npos);
  CHECK(view.find("-board3\n@24\nboard3.board3_state[1:0]\n@28\nboard3.board3_BR_n\n") !=
        std::string::npos);
  for (const auto& [name, values] : VcdReader(content_of(scratch / "run" / "bus.vcd")).signals) {
    INFO(name);
    CHECK((view.find("\n" + name + "\n") != std::string::npos ||
           view.find("\n" + name + "[") != std::string::npos));
  }
  CHECK(content_of(scratch / "run" / "manifest.json").find("\"bus.gtkw\"") != std::string::npos);
}

TEST_CASE("a user's own save file is never replaced, one of the program's is") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const std::string command = "run " + scene + k_small_frame + "--quiet --outdir " +
                              (scratch / "run").string() + " --trace " +
                              (scratch / "bus.vcd").string();
  CHECK(run_maquette(command).exit_code == 0);
  const std::string written = content_of(scratch / "bus.gtkw");
  CHECK(run_maquette(command).exit_code == 0);
  CHECK(content_of(scratch / "bus.gtkw") == written);
  for (const std::string& own :
       {std::string("[dumpfile] \"bus.vcd\"\n"), std::string(), "\n" + written}) {
    static_cast<void>(scratch.file("bus.gtkw", own));
    const Outcome outcome = run_maquette(command);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.errors.find("bus.gtkw: is no file that this program wrote") != std::string::npos);
    CHECK(content_of(scratch / "bus.gtkw") == own);
  }
}

TEST_CASE("a chart of a window shows each board's states by their widths, and who has the bus") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const Outcome outcome =
      run_maquette("run " + scene + k_small_frame + "--quiet --outdir " +
                   (scratch / "run").string() + " --trace bus.svg " + k_machines[1]);
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const Statistics statistics =
      parse_statistics(content_of(scratch / "run" / "stats.json"), "stats.json");
  const std::string chart = content_of(scratch / "run" / "bus.svg");
  const auto area = [&chart](const std::string& kind) {
    const std::regex box("<rect class=\"" + kind +
                         "\"[^>]* width=\"([0-9.]+)\" height=\"([0-9.]+)\"");
    double sum = -18 * 18;  // of the legend
    for (std::sregex_iterator found(chart.begin(), chart.end(), box), end; found != end; ++found) {
      sum += std::stod((*found)[1]) * std::stod((*found)[2]);
    }
    return sum;
  };
  double compute = 0;
  double idle = 0;
  for (const auto& board : statistics.boards) {
    compute += static_cast<double>(board.compute.count());
    idle += static_cast<double>(board.idle.count());
  }
  CHECK(area("idle") / area("compute") == Approx(idle / compute).epsilon(0.02));
  CHECK(area("wait") > 0);
  CHECK(area("even") > 0);
  CHECK(area("odd") > 0);
  for (const char* text : {">board0<", ">board4<", ">versabus<", ">queue<", "waits for the bus"}) {
    INFO(text);
    CHECK(chart.find(text) != std::string::npos);
  }
}

TEST_CASE("a trace that cannot be is refused before anything runs") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const std::string file = (scratch / "t.json").string();
  const struct {
    std::string options;
    std::string expected;
  } cases[] = {
      {"--trace t.txt", "allowed: .json, .vcd, .svg"},
      {"--trace " + file + " --trace " + file, "given twice"},
      {"--trace " + (scratch / "none" / "t.json").string(), "cannot be written"},
      {"--trace " + file + " --trace-window 2s..1s", "empty window"},
      {"--trace " + file + " --trace-window 1s..1s", "empty window"},
      {"--trace " + file + " --trace-window 1s", "T0..T1"},
      {"--trace " + file + " --trace-window 1..2", "has no unit"},
      {"--trace " + file + " --trace-window ' -1s..2s'", "before the frame"},
      {"--trace " + file + " --trace-boards 4", "allowed: 0..3"},
      {"--trace " + file + " --trace-boards 3..1", "empty range"},
      {"--trace " + file + " --trace-boards 0,", "allowed: 0..3"},
      {"--trace " + file + " --trace-boards 1..", "allowed: 0..3"},
      {"--trace-window 1s..2s", "--trace FILE"},
      {"--trace-boards 1", "--trace FILE"},
  };
  for (const auto& one : cases) {
    const Outcome outcome = run_maquette("run " + scene + k_small_frame + one.options +
                                         " --outdir " + (scratch / "run").string());
    INFO(one.options << "\n" << outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.errors.find(one.expected) != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(scratch / "run" / "stats.json"));
    CHECK_FALSE(std::filesystem::exists(file));
  }
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) {
    CHECK(entry.path().filename().string().find("unfinished") == std::string::npos);
  }
}

TEST_CASE("a window after the frame gives an empty trace and says so") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const Outcome outcome =
      run_maquette("run " + scene + k_small_frame + "--quiet --outdir " +
                   (scratch / "run").string() + " --trace " + (scratch / "t.json").string() +
                   " --trace " + (scratch / "t.vcd").string() + " --trace-window '1000000 s..'");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.errors.find("is empty, the frame ended after") != std::string::npos);
  CHECK(ChromeTraceReader(content_of(scratch / "t.json")).arrows.empty());
  CHECK(VcdReader(content_of(scratch / "t.vcd")).first >= 0);
}

TEST_CASE("Traces that are given by a name alone are among the run's results, others told of") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const std::string elsewhere = (scratch / "elsewhere.vcd").string();
  const Outcome outcome = run_maquette(
      "run " + scene + " --set frame_memory.width=24pixels --set frame_memory.height=18pixels " +
      "--outdir " + (scratch / "run").string() +
      " --trace bus.json --bus signal --trace-lines lines.vcd --trace " + elsewhere);
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const std::string manifest = content_of(scratch / "run" / "manifest.json");
  for (const char* name : {"bus.json", "lines.vcd"}) {
    INFO(name);
    CHECK(std::filesystem::exists(scratch / "run" / name));
    CHECK(manifest.find("\"" + std::string(name) + "\"") != std::string::npos);
    CHECK(outcome.output.find((scratch / "run" / name).string()) != std::string::npos);
  }
  CHECK(std::filesystem::exists(elsewhere));
  CHECK(outcome.output.find(elsewhere) != std::string::npos);
}
