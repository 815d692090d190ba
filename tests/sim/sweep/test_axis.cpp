#include "sim/sweep/axis.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;

namespace {

std::string error_of_axis(const std::string& text) {
  try {
    static_cast<void>(parse_axis(text));
  } catch (const DescriptionError& error) {
    return error.what();
  }
  return {};
}

std::string written(const std::string& text) { return write_flow(write_axis(parse_axis(text))); }

}  // namespace

TEST_CASE("values are separated by commas outside of brackets and quotes") {
  const Axis axis = parse_axis("lights.key.position=[1, 2, 3],[4,5,6]");
  REQUIRE(axis.pieces.size() == 2);
  CHECK(std::get<AxisValue>(axis.pieces[0]).text == "[1, 2, 3]");
  CHECK(std::get<AxisValue>(axis.pieces[1]).node.items.size() == 3);
  CHECK(axis.steps.size() == 3);
  CHECK(parse_axis("a=\"x,y\",z").pieces.size() == 2);
  CHECK(parse_axis("a=1..4, 8 ,16").pieces.size() == 3);
}

TEST_CASE("an axis is read back as it was written") {
  for (const char* text : {"a=1..4", "a=1..4:2,9", "a=log 1..1000 us of 7", "a=x,y", "a=8 MHz",
                           "a=0.2..0.5 us of 7", "a=[1, 2],[3, 4]", "a={b: 1},{b: 2}"}) {
    INFO(text);
    const YamlNode node = write_axis(parse_axis(text));
    const Axis again = read_axis("a", {}, parse_yaml(write_yaml(node), "study.yaml"));
    CHECK(write_flow(write_axis(again)) == write_flow(node));
    CHECK(again.pieces.size() == parse_axis(text).pieces.size());
  }
  CHECK(written("a=1..4:2,9") == "[\"1..4:2\", 9]");
}

TEST_CASE("a study file gives an axis as a text, a list, or named values") {
  const auto pieces = [](const std::string& yaml) {
    return read_axis("a", {}, parse_yaml(yaml, "study.yaml")).pieces;
  };
  CHECK(pieces("1..4, 9").size() == 2);
  CHECK(pieces("[1..4, 9, [1, 2]]").size() == 3);
  const auto named = pieces("{slow: {clock: 8 MHz}, fast: {clock: 10 MHz}}");
  REQUIRE(named.size() == 2);
  CHECK(std::get<AxisValue>(named[1]).text == "fast");
  CHECK(std::get<AxisValue>(named[1]).node.find("clock")->text == "10 MHz");
  CHECK_THROWS_AS(pieces("[]"), DescriptionError);
}

TEST_CASE("mistakes are reported where they stand") {
  CHECK(error_of_axis("processors").find("--vary processors:1:11: `=`") == 0);
  CHECK(error_of_axis("bus..clock=1").find("--vary bus..clock=1:1:5: a name is missing") == 0);
  CHECK(error_of_axis("a=1,,2").find("--vary a=1,,2:1:5: a value is missing") == 0);
  CHECK(error_of_axis("a=1, 5..2").find("--vary a=1, 5..2:1:6: ") == 0);
  CHECK(error_of_axis("a=4, 1-8").find("did you mean `1..8`?") != std::string::npos);
  CHECK(error_of_axis("a=-8").empty());
  CHECK(error_of_axis("a=m-8,1985-a,8-").empty());
  CHECK(error_of_axis("a=[1").find("--vary a=[1:1:") == 0);
}
