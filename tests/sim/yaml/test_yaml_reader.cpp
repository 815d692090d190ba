#include "sim/yaml/yaml_reader.hpp"

#include <string>

#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;

namespace {

/// The message about a broken text; empty when it is read.
std::string error_of(const std::string& text) {
  try {
    static_cast<void>(parse_yaml(text, "scene.yaml"));
  } catch (const DescriptionError& error) {
    return error.what();
  }
  return {};
}

/// A sequence in sequences.
std::string nested(int levels) {
  const auto count = static_cast<std::size_t>(levels);
  return std::string(count, '[') + std::string(count, ']');
}

}  // namespace

TEST_CASE("nesting is as deep as is allowed and no deeper") {
  CHECK(error_of(nested(k_nesting_limit)).empty());
  CHECK_THAT(error_of(nested(k_nesting_limit + 1)),
             ContainsSubstring("scene.yaml:1:") && ContainsSubstring("nested deeper than 450"));
  CHECK_THAT(error_of("a: " + std::string(100'000, '[')), ContainsSubstring("nested deeper than"));
  std::string maps = "a: ";
  for (int i = 0; i < 1000; ++i) {
    maps += "{a: ";
  }
  CHECK_THAT(error_of(maps), ContainsSubstring("nested deeper than"));
}

TEST_CASE("aliases of aliases count by what they stand for") {
  std::string laughs = "- &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    laughs += "- &a" + std::to_string(i) + " [" + alias;
    for (int j = 1; j < 10; ++j) {
      laughs += ", " + alias;
    }
    laughs += "]\n";
  }
  CHECK_THAT(error_of(laughs),
             ContainsSubstring("scene.yaml:") && ContainsSubstring("once aliases are replaced"));
}

TEST_CASE("aliases of long texts count by their bytes") {
  const auto copies = [](int count) {
    std::string texts = "a: &text " + std::string(100'000, 'x') + "\nb: [*text";
    for (int i = 1; i < count; ++i) {
      texts += ", *text";
    }
    return texts + "]";
  };
  CHECK(error_of(copies(1000)).empty());
  CHECK_THAT(error_of(copies(6000)),
             ContainsSubstring("scene.yaml:2:") && ContainsSubstring("544 MiB of values"));
}

TEST_CASE("a tab that indents is told as one") {
  CHECK_THAT(error_of("a:\n\tb: 1\n"), ContainsSubstring("a tab indents this line"));
  CHECK_THAT(error_of("a:\n  \tb: 1\n"), ContainsSubstring("a tab indents this line"));
  CHECK(error_of("a:\t1\n").empty());
  CHECK_THAT(error_of("a: [1\n"), !ContainsSubstring("tab"));
}

TEST_CASE("a message shows the beginning of a long text") {
  const std::string name = parse_yaml(std::string(100'000, 'x'), "scene.yaml").kind_name();
  CHECK(name.size() < 200);
  CHECK_THAT(name, ContainsSubstring("xxx..."));
  CHECK(parse_yaml("short", "scene.yaml").kind_name() == "`short`");
}
