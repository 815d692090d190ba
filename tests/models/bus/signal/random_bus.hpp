#pragma once

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "models/bus/arbitration_policies.hpp"
#include "models/bus/memory_cells.hpp"
#include "models/bus/versabus.hpp"
#include "tests/models/bus/traffic.hpp"

/// Random buses with random traffic, made twice or more of the same description at several levels.
namespace maquette::models::traffic {

inline constexpr Duration k_eighth{125'000};  // a clock of 8 MHz

/// A memory whose access time is of one of several laws.
struct RandomSlave {
  std::uint64_t base;
  int law;
  Duration time;

  [[nodiscard]] Duration access_time(Instant strobe) const {
    constexpr int k_uneven = 1;
    constexpr int k_seldom_late = 2;
    switch (law) {
      case k_uneven:
        return Duration{strobe.count() / 1'000 % 1'200'000};
      case k_seldom_late:
        return strobe.count() / 1'000 % 7 == 0 ? 40 * time : time;
      default:
        return time;
    }
  }
};

struct RandomMaster {
  BusMasterPlace place;
  AccessLaw access;
  Style style;
  std::vector<Step> steps;
};

struct RandomBus {
  VersaBusParameters parameters;
  std::vector<RandomSlave> slaves;
  std::vector<RandomMaster> masters;
};

inline constexpr std::uint64_t k_slave_bytes = 64;
inline constexpr std::uint64_t k_slave_distance = 72;  // a few bytes are nobody's

/// Mostly whole clocks, so that much falls together; sometimes any tick, sometimes nothing.
inline Duration random_span(std::mt19937& random, int clocks) {
  switch (below(random, 6)) {
    case 0:
      return Duration{below(random, 1'000'000)};
    case 1:
      return Duration::zero();
    default:
      return k_eighth * below(random, clocks);
  }
}

inline Step random_step(std::mt19937& random, unsigned word_bytes, int slaves) {
  Step step;
  step.compute = random_span(random, 60);
  const int words = static_cast<int>(k_slave_distance / word_bytes) * slaves;
  step.address = static_cast<std::uint64_t>(below(random, words)) * word_bytes;
  step.accesses = 1 + below(random, 5);
  step.gap = random_span(random, 8);
  step.block = below(random, 2) == 0;
  step.command = below(random, 2) == 0 ? tlm::TLM_READ_COMMAND : tlm::TLM_WRITE_COMMAND;
  step.test_and_set = step.command == tlm::TLM_READ_COMMAND && below(random, 3) == 0;
  step.modify = random_span(random, 4);
  return step;
}

inline VersaBusParameters random_parameters(std::mt19937& random) {
  VersaBusParameters parameters;
  constexpr double k_clocks_hz[] = {8e6, 16e6, 10e6, 7.159e6};
  constexpr Duration k_timeouts[] = {Duration{0}, Duration{2'000'000}, Duration{64'000'000}};
  parameters.data_width_bits = below(random, 2) == 0 ? 16 : 32;
  parameters.clock_hz = k_clocks_hz[below(random, 4)];
  parameters.arbitration_clocks = below(random, 5);
  parameters.handover_clocks = below(random, 3);
  parameters.arbitration = k_arbitration_policies[static_cast<std::size_t>(
      below(random, static_cast<int>(std::size(k_arbitration_policies))))];
  parameters.timeout = k_timeouts[below(random, 3)];
  return parameters;
}

inline RandomMaster random_master(std::mt19937& random, int index, unsigned word_bytes,
                                  int slaves) {
  constexpr double k_clocks_hz[] = {8e6, 8e6, 12.5e6, 7.159e6, 71.5e6, 512e6};
  const double clock_hz = k_clocks_hz[below(random, 6)];
  RandomMaster master{
      {below(random, 5), below(random, 2) == 0 ? index : 100 - index},
      {Period::of_frequency(clock_hz), 4 + below(random, 3), Duration{70'000 * below(random, 2)}},
      static_cast<Style>(below(random, 4)),
      {}};
  const int steps = 1 + below(random, 40);
  for (int step = 0; step < steps; ++step) {
    master.steps.push_back(random_step(random, word_bytes, slaves));
  }
  return master;
}

inline RandomBus random_bus(std::mt19937& random) {
  RandomBus bus;
  bus.parameters = random_parameters(random);
  const auto word_bytes = static_cast<unsigned>(bus.parameters.data_width_bits / 8);
  const int slaves = 1 + below(random, 3);
  for (int slave = 0; slave < slaves; ++slave) {
    bus.slaves.push_back({static_cast<std::uint64_t>(slave) * k_slave_distance, below(random, 4),
                          random_span(random, 6) + Duration{70'000 * below(random, 2)}});
  }
  const int masters = 1 + below(random, 6);
  for (int master = 0; master < masters; ++master) {
    bus.masters.push_back(random_master(random, master, word_bytes, slaves));
  }
  return bus;
}

/// A memory with the access time of a RandomSlave.
class Memory : public sc_core::sc_module {
 public:
  Memory(const sc_core::sc_module_name& name, const RandomSlave& what)
      : sc_module(name), socket("socket"), cells(k_slave_bytes), what_(what) {
    socket.register_b_transport(this, &Memory::b_transport);
  }

  tlm_utils::simple_target_socket<Memory> socket;
  std::vector<unsigned char> cells;

 private:
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    access_cells(cells, payload);
    delay += to_sc_time(what_.access_time(payload.get_extension<BusStrobe>()->instant));
  }

  RandomSlave what_;
};

/// A RandomBus at a level, which logs every access.
struct RandomBench {
  RandomBench(const std::string& name, const RandomBus& what, const BusLevel& level)
      : bus((name + "_bus").c_str(), with(what.parameters, level)) {
    for (const RandomSlave& slave : what.slaves) {
      const std::string slave_name = name + "_slave" + std::to_string(slaves.size());
      slaves.push_back(std::make_unique<Memory>(slave_name.c_str(), slave));
      bus.attach_slave(slaves.back()->socket, {slave_name, slave.base, k_slave_bytes});
    }
    for (const RandomMaster& master : what.masters) {
      masters.push_back(std::make_unique<Master>(
          (name + "_master" + std::to_string(masters.size())).c_str(), bus, master.place,
          master.access, master.style, script(master.steps)));
    }
    bus.observe([this](const BusAccess& access) { log.push_back(access); });
  }

  static VersaBusParameters with(VersaBusParameters parameters, const BusLevel& level) {
    parameters.level = level;
    return parameters;
  }

  VersaBus bus;
  std::vector<std::unique_ptr<Memory>> slaves;
  std::vector<std::unique_ptr<Master>> masters;
  std::vector<BusAccess> log;
};

}  // namespace maquette::models::traffic
