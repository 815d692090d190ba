#include "sim/sweep/derivation.hpp"

#include "tests/catch.hpp"

using namespace maquette::sim;

namespace {

/// Two series of boards: a bus with and one without loss.
Table table_of_boards() {
  return {
      {{"processors", "", ""}, {"bus.arbitration", "", ""}, {"frame.time_s", "s", ""}},
      {{"2", "x", "100"}, {"2", "y", "80"}, {"4", "x", "50"}, {"4", "y", "64"}, {"8", "x", ""}}};
}

std::vector<std::string> derived(Derivation derivation, const std::string& over) {
  Table table = table_of_boards();
  add_derived_column(table, {"new", "u", "", derivation, "frame.time_s", over, {}},
                     {parse_axis("processors=2,4,8"), parse_axis("bus.arbitration=x,y")});
  CHECK(heading_of(table.columns.back()) == "new [u]");
  std::vector<std::string> cells;
  for (const auto& row : table.rows) {
    cells.push_back(row.back());
  }
  return cells;
}

}  // namespace

TEST_CASE("speed-up is against the first row of the same series") {
  CHECK(derived(Derivation::speed_up, "processors") ==
        std::vector<std::string>{"1", "1", "2", "1.25", ""});
}

TEST_CASE("efficiency is speed-up over the ratio of the boards") {
  CHECK(derived(Derivation::efficiency, "processors") ==
        std::vector<std::string>{"1", "1", "1", "0.625", ""});
}

TEST_CASE("a ratio is over a column or a number") {
  CHECK(derived(Derivation::ratio, "10") == std::vector<std::string>{"10", "8", "5", "6.4", ""});
  CHECK(derived(Derivation::ratio, "processors") ==
        std::vector<std::string>{"50", "40", "12.5", "16", ""});
}
