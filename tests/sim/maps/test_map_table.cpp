#include "sim/maps/map_table.hpp"

#include <set>

#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

using Catch::Matchers::ContainsSubstring;

TEST_CASE("Every map has a name of its own, a title, and a fact that it is taken from") {
  std::set<std::string> names;
  for (const Map& map : all_maps()) {
    INFO(map.name);
    CHECK(names.insert(map.name).second);
    CHECK_FALSE(map.title.empty());
    CHECK(facts_of({map}).any());
    CHECK_THAT(describe_maps(), ContainsSubstring("  " + map.name + " "));
  }
}

TEST_CASE("Maps are told by their names, each once, and wrong names with those allowed") {
  const std::vector<Map> maps = maps_named({"rays", "time", "rays"});
  REQUIRE(maps.size() == 2);
  CHECK(maps[0].name == "time");
  CHECK(maps[1].name == "rays");
  CHECK(maps_named({}).empty());
  CHECK_FALSE(facts_of({}).any());
  CHECK_THROWS_WITH(maps_named({"tme"}), ContainsSubstring("--map tme") &&
                                             ContainsSubstring("did you mean `time`?") &&
                                             ContainsSubstring("rays.shadow"));
}

TEST_CASE("A part of the time needs the time") {
  CHECK(facts_of(maps_named({"function.photometry"})).times);
  CHECK(facts_of(maps_named({"count_error"})).times);
  CHECK_FALSE(facts_of(maps_named({"rays"})).times);
}

}  // namespace
}  // namespace maquette::sim
