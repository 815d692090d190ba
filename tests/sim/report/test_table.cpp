#include "sim/report/table.hpp"

#include "tests/catch.hpp"

using namespace maquette::sim;

TEST_CASE("a table is written as comma-separated values with units in its headings") {
  const Table table{{{"point", "", ""}, {"board.clock", "MHz", ""}, {"reason", "", ""}},
                    {{"0", "8", ""}, {"1", "10", "a \"b\", c\nd"}}};
  CHECK(table_csv(table) == "point,board.clock [MHz],reason\n0,8,\n1,10,\"a \"\"b\"\", c\nd\"\n");
  CHECK(table.find("board.clock") == std::optional<std::size_t>{1});
  CHECK_FALSE(table.find("clock"));
}

TEST_CASE("cells are numbers as a whole or not at all") {
  CHECK(number_in("-1.5e3") == -1500.0);
  for (const char* cell : {"", "8 MHz", "x", "1,5", " 1"}) {
    CHECK_FALSE(number_in(cell));
  }
}
