#include "sim/report/flat_yaml.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

using maquette::sim::flatten_yaml;
using maquette::sim::FlatValues;

TEST_CASE("every scalar has its path and its own writing") {
  const auto values = flatten_yaml(
      "bus:\n  clock: 8 MHz\n  levels: [4, 3]\nboards:\n  - {name: a}\n  - name: b\nempty:\n", "f");
  CHECK(values == FlatValues{{"bus.clock", "8 MHz"},
                             {"bus.levels[0]", "4"},
                             {"bus.levels[1]", "3"},
                             {"boards[0].name", "a"},
                             {"boards[1].name", "b"},
                             {"empty", "null"}});
}

TEST_CASE("what is not YAML is refused with its place") {
  CHECK_THROWS_WITH(flatten_yaml("a: 1\nb: [1, 2\nc: }", "config.yaml"),
                    Catch::Matchers::StartsWith("config.yaml:3:"));
  CHECK_THROWS_AS(flatten_yaml("[a, b]: c\n", "config.yaml"), maquette::sim::DescriptionError);
}
