#include "sim/report/flat_json.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

using maquette::sim::DescriptionError;
using maquette::sim::flatten_json;
using maquette::sim::FlatValues;

TEST_CASE("every value has its path, and numbers keep their digits") {
  const auto values = flatten_json(
      R"({"a": {"b": [1, -2, {"c": 9223372.036854775807}], "d": [[true], [], {}]},
          "e": null, "f": "x\"y", "g": 1.50})",
      "f");
  CHECK(values == FlatValues{{"a.b[0]", "1"},
                             {"a.b[1]", "-2"},
                             {"a.b[2].c", "9223372.036854775807"},
                             {"a.d[0][0]", "true"},
                             {"e", "null"},
                             {"f", "x\"y"},
                             {"g", "1.50"}});
}

TEST_CASE("what is not JSON is refused with its place") {
  CHECK_THROWS_WITH(flatten_json("{\n \"a\": 1,\n \"b\" 2}", "s.json"),
                    Catch::Matchers::StartsWith("s.json:3:6: "));
  CHECK_THROWS_WITH(flatten_json("", "s.json"), Catch::Matchers::StartsWith("s.json:1:1: "));
  for (const char* text : {"{", "[1,]", "{\"a\": nan}", "{} {}", "\xff"}) {
    INFO(text);
    CHECK_THROWS_AS(flatten_json(text, "s.json"), DescriptionError);
  }
}
