#include "models/bus/signal/bus_lines.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "models/bus/signal_level.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/signal/random_bus.hpp"
#include "tests/program/vcd_reader.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;
using maquette::tests::VcdReader;

// What a trace file of the kernel shows of a random bus that does everything.
VcdReader traced(RandomBench& bench) {
  const std::filesystem::path stem =
      std::filesystem::temp_directory_path() / ("lines" + std::to_string(std::random_device{}()));
  sc_core::sc_trace_file* file = sc_core::sc_create_vcd_trace_file(stem.c_str());
  file->set_time_unit(1, sc_core::SC_PS);
  bench.bus.trace_lines(file);
  sc_core::sc_start();
  sc_core::sc_start(1, sc_core::SC_US);  // shows the last changes
  sc_core::sc_close_vcd_trace_file(file);
  const std::filesystem::path path = stem.string() + ".vcd";
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  return VcdReader(text.str());
}

RandomBus busy_bus() {
  std::mt19937 random(29);
  RandomBus bus = random_bus(random);
  bus.parameters.data_width_bits = 32;
  bus.parameters.arbitration = k_priority;
  bus.parameters.arbitration_clocks = 3;
  bus.parameters.timeout = Duration{2'000'000};
  bus.slaves = {{0, 1, {}}, {k_slave_distance, 0, Duration{250'000}}};
  bus.masters.clear();
  for (int master = 0; master < 5; ++master) {
    bus.masters.push_back(random_master(random, master, 4, 2));
  }
  return bus;
}

struct Trace {
  const VcdReader& vcd;

  [[nodiscard]] bool is_low(const std::string& line, Instant instant) const {
    return vcd.value("engine." + line, instant.count()) == "0";
  }
  void check_low(const std::string& line, Instant from, Instant to) const {
    CHECK(is_low(line, from));
    CHECK(is_low(line, to - k_tick));
  }
  [[nodiscard]] Duration low(const std::string& line) const {
    return Duration{vcd.time_with("engine." + line, "0")};
  }
};

}  // namespace

TEST_CASE("in a trace of the lines every handshake stands where its access was") {
  RandomBench bench("traced", busy_bus(), k_signal_level);
  const VcdReader vcd = traced(bench);
  const Trace trace{vcd};
  REQUIRE(bench.log.size() > 100);
  Duration strobed{};
  for (const BusAccess& access : bench.log) {
    const std::string level = std::to_string(bench.bus.master_place(access.master).level);
    INFO("request " << access.request.count() << ", grant " << access.grant.count());
    if (access.decision < access.grant) {
      trace.check_low("BR_n_" + level, access.request, access.grant);
      trace.check_low("BG_n_" + level, access.decision, access.grant);
    }
    CHECK_FALSE(trace.is_low("BG_n_" + level, access.grant));
    trace.check_low("BBSY_n", access.grant, access.end);
    trace.check_low("AS_n", access.grant, access.end);
    trace.check_low("DS0_n", access.grant, access.grant + access.slave_time);
    trace.check_low("DS1_n", access.grant, access.grant + access.slave_time);
    CHECK(trace.is_low("WRITE_n", access.grant) == access.write);
    strobed += access.end - access.grant;
    if (!access.test_and_set) {
      const Instant answer = access.grant + access.slave_time;
      CHECK(trace.is_low("DTACK_n", answer) == (access.answered || answer == access.end));
      if (access.slave_time > Duration::zero()) {
        CHECK_FALSE(trace.is_low("DTACK_n", answer - k_tick));
      }
    }
  }
  CHECK(trace.low("AS_n") == strobed);
  CHECK(trace.low("DS0_n") < strobed);
  CHECK(vcd.time_scale == "1 ps");
}
