#include "sim/primitives/primitive_keys.hpp"

#include <set>

#include "sim/primitives/primitive_table.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

using Catch::Matchers::ContainsSubstring;

std::set<std::string> paths_of(const PrimitiveDescription& primitive) {
  std::set<std::string> paths;
  for (const KeyRow& row : keys_of(primitive)) {
    INFO(row.path);
    CHECK_FALSE(row.sentence.empty());
    CHECK(paths.insert(row.path).second);
  }
  return paths;
}

TEST_CASE("Keys of every primitive are told once each, with what they mean") {
  for (const PrimitiveDescription* primitive : primitive_table()) {
    INFO(primitive->name);
    const std::set<std::string> paths = paths_of(*primitive);
    CHECK((!paths.empty() || primitive->name == "half_space"));
  }
}

TEST_CASE("Keys have their range, units, default and whether they are needed") {
  CHECK(paths_of(*find_primitive("sphere")) == std::set<std::string>{"radius", "radii"});
  const std::vector<KeyRow> revolution = keys_of(*find_primitive("revolution"));
  CHECK(revolution.front().path == "points");
  CHECK(revolution.front().required);
  const std::string torus = key_list(keys_of(*find_primitive("torus")));
  CHECK_THAT(torus, ContainsSubstring("allowed: "));
  CHECK_THAT(key_list({}), ContainsSubstring("no keys"));
}

}  // namespace
}  // namespace maquette::sim
