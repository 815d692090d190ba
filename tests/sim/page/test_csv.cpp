#include "sim/page/csv.hpp"

#include <random>

#include "sim/report/table.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("What is written as comma-separated values is read as it was") {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    Table table;
    table.columns.resize(1 + random() % 4);
    table.rows.resize(random() % 5);
    for (auto& row : table.rows) {
      for (std::size_t i = 0; i < table.columns.size(); ++i) {
        row.emplace_back();
        for (auto length = 1 + random() % 5; length > 0; --length) {
          row.back() += ",\"\nab"[random() % 5];
        }
      }
    }
    for (TableColumn& column : table.columns) {
      column.name = "name, \"quoted\"";
    }
    const auto lines = parse_csv(table_csv(table), "table.csv");
    REQUIRE(lines.size() == table.rows.size() + 1);
    CHECK(lines.front() == std::vector<std::string>(table.columns.size(), "name, \"quoted\""));
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      CHECK(lines[row + 1] == table.rows[row]);
    }
  }
}

TEST_CASE("Empty cells and a line without end are read") {
  CHECK(parse_csv("a,b\n,\n1,2", "t").back() == std::vector<std::string>{"1", "2"});
  CHECK(parse_csv("a,b\n,\n", "t").back() == std::vector<std::string>{"", ""});
  CHECK(parse_csv("", "t").empty());
}

TEST_CASE("What is no table is refused with its line") {
  for (const char* wrong : {"a,b\n1\n", "a,b\n1,2,3\n", "a,b\n\"1,2\n", "a,b\n\"1\"2,3\n"}) {
    INFO(wrong);
    CHECK_THROWS_WITH(parse_csv(wrong, "table.csv"), ContainsSubstring("table.csv:2:1:"));
  }
}
