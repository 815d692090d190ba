#include <fmt/format.h>

#include <iostream>
#include <string>

#include "firmware/arithmetic/maquette_ffp/package.hpp"
#include "tools/arithmetic_costs/measured_cost.hpp"

namespace maquette::costs {
namespace {

constexpr const char* k_usage =
    "usage: arithmetic_costs            prints what each routine of the package takes\n"
    "       arithmetic_costs --table    prints the table of models/arithmetic/ that comes of it\n";

void print_costs() {
  std::cout << fmt::format("{:<18}{:>9}{:>11}{:>7}{:>7}{:>8}{:>8}\n", "operation", "clocks",
                           "deviation", "min", "max", "reads", "writes");
  for (const CostRow& row : measured_rows()) {
    const MeasuredCost& cost = row.cost;
    std::cout << fmt::format("{:<18}{:>9.1f}{:>11.1f}{:>7}{:>7}{:>8.1f}{:>8.2f}\n", row.operation,
                             cost.mean, cost.deviation, cost.least, cost.most, cost.reads,
                             cost.writes);
  }
  std::cout << "\nsource            bytes\n";
  for (const auto& part : firmware::maquette_ffp::k_package_parts) {
    std::cout << fmt::format("{:<18}{:>5}\n", part.name, part.bytes);
  }
}

std::string table_head() {
  return fmt::format(
      "# The project's own arithmetic package in Motorola's Fast Floating Point format,\n"
      "# firmware/arithmetic/maquette_ffp: 68000 clocks without wait states, from entry to RTS, "
      "measured\n"
      "# by tools/ffp_costs, which makes this table, on the MC68000 of models/board/mc68000. Each "
      "source\n"
      "# names the operands. Every call pays board.call_overhead besides.\n"
      "# Marks: R read in the source named, M measured, W widely stated, I inferred from other "
      "figures.\n"
      "name: maquette_ffp\n"
      "# Without the elementary functions, which are the firmware's.\n"
      "code: {} B\n"
      "execution: package\n\n",
      sizeof firmware::maquette_ffp::k_package);
}

void print_table() {
  std::cout << table_head();
  for (const CostRow& row : measured_rows()) {
    const std::string head = row.operation + ": {";
    std::cout << fmt::format(
                     "{}clocks: {:.1f}, reads: {:.1f}, writes: {:.1f}, called: {}, mark: {},\n",
                     head, row.cost.mean, row.cost.reads, row.cost.writes, row.called, row.mark)
              << fmt::format("{:{}}source: \"{}\"}}\n", "", head.size(), row.source);
  }
}

}  // namespace
}  // namespace maquette::costs

int main(int count, char** arguments) {
  using namespace maquette::costs;
  if (count == 1) {
    print_costs();
    return 0;
  }
  if (count != 2 || std::string(arguments[1]) != "--table") {
    std::cerr << k_usage;
    return 2;
  }
  print_table();
  return 0;
}
