#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "tools/event_costs/scene_samples.hpp"

namespace maquette::costs {
namespace {

using models::OperationCost;
using sim::OperationCosts;

/// A processor whose table is made of the MC68000's, by the ratio of what a frame's loads, stores,
/// branches, loops and calls take on both.
struct Processor {
  const char* name;
  const char* mark;
  double clocks;
  double reads;
  double writes;
  double bus_cycle_clocks;
  OperationCost load;  ///< of a word of the database, at least
  const char* source;  ///< a pattern for the numbers of pixels
};

constexpr Processor k_processors[] = {
    {"mc68000",
     "M",
     1,
     1,
     1,
     4,
     {8, 2, 0},
     "tools/program_costs: least squares over {} pixels of all scenes, executed on an "
     "instruction-level MC68000"},
    {"mc68020",
     "I",
     0.45,
     0.17,
     0.5,
     3,
     {3, 1, 0},
     "as mc68000, of {} pixels, times 0.45 clocks, 0.17 reads, 0.5 writes: a bus cycle of 3 "
     "clocks, "
     "2 clocks per simple instruction from the cache"},
    {"vax_11_750",
     "I",
     0.4,
     0,
     0,
     0,
     {},
     "as mc68000, of {} pixels, times 0.4 clocks of 320 ns: instructions of 1.6 us in the mean"},
    {"microprogrammed",
     "I",
     0.1,
     0,
     0,
     0,
     {1, 0, 0},
     "as mc68000, of {} pixels, a microinstruction in place of 10 of its clocks (assumed, 5 to "
     "20), "
     "operands in registers and a memory of the microcycle"}};

OperationCosts least_costs(const Processor& processor) {
  OperationCosts costs{};
  costs[static_cast<std::size_t>(firmware::Operation::load)] = processor.load;
  return costs;
}

OperationCost scaled(const OperationCost& cost, const Processor& processor,
                     const OperationCost& least) {
  return {std::max(cost.clocks * processor.clocks, least.clocks),
          std::max(cost.reads * processor.reads, least.reads),
          std::max(cost.writes * processor.writes, least.writes)};
}

double rounded(double value) {
  constexpr double k_steps = 100;
  return std::round(value * k_steps) / k_steps;
}

/// As it is written clocks have room for the bus cycles.
std::string cost_text(const OperationCost& cost, double bus_cycle_clocks) {
  const double reads = rounded(cost.reads);
  const double writes = rounded(cost.writes);
  const double clocks = std::max(rounded(cost.clocks), bus_cycle_clocks * (reads + writes));
  return fmt::format("clocks: {:.2f}, reads: {:.2f}, writes: {:.2f}", clocks, reads, writes);
}

std::string table_text(const OperationCosts& costs, const Processor& processor,
                       std::size_t pixels) {
  std::string text = fmt::format(
      "# What a board's program takes for each event of the process, besides calls of the "
      "arithmetic\n"
      "# package: clocks without wait states and the 16-bit bus cycles among them. Made by\n"
      "# tools/program_costs, which each source line tells more of.\n"
      "# Marks: R read in the source named, M measured, W widely stated, I inferred from other "
      "figures.\n"
      "name: {}\n\n",
      processor.name);
  const OperationCosts least = least_costs(processor);
  const std::string source = fmt::format(fmt::runtime(processor.source), pixels);
  for (std::size_t i = firmware::k_arithmetic_count; i < costs.size(); ++i) {
    const std::string head = fmt::format("{}: {{", firmware::k_operation_names[i]);
    const OperationCost cost = scaled(costs[i], processor, least[i]);
    text += fmt::format("{}{}, mark: {},\n{:{}}source: \"{}\"}}\n", head,
                        cost_text(cost, processor.bus_cycle_clocks), processor.mark, "",
                        head.size(), source);
  }
  return text;
}

int print(const std::string& data_directory, const std::string& wanted) {
  const std::vector<sim::CostSample> samples = samples_of_all_scenes(data_directory);
  const OperationCosts costs = sim::fitted_costs(samples, {}, least_costs(k_processors[0]));
  if (wanted == "call") {
    fmt::print("{}\n", cost_text(costs[static_cast<std::size_t>(k_call)],
                                 k_processors[0].bus_cycle_clocks));
    return 0;
  }
  for (const Processor& processor : k_processors) {
    if (wanted == processor.name) {
      fmt::print("{}", table_text(costs, processor, samples.size()));
      return 0;
    }
  }
  return 2;
}

}  // namespace
}  // namespace maquette::costs

/// SystemC's library, in which the models are, wants it.
extern "C" int sc_main(int /*argc*/, char** /*argv*/) { return 0; }

int main(int count, char** arguments) {
  const int status = count == 3 ? maquette::costs::print(arguments[1], arguments[2]) : 2;
  if (status != 0) {
    std::cerr << "usage: event_costs DIRECTORY call|mc68000|mc68020|vax_11_750|microprogrammed\n"
                 "DIRECTORY holds models/ and scenes/.\n";
  }
  return status;
}
