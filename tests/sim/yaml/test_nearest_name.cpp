#include "sim/yaml/nearest_name.hpp"

#include "tests/catch.hpp"

namespace maquette::sim {

TEST_CASE("edit distances of known pairs") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("clock", "clock") == 0);
  CHECK(edit_distance("clock", "clok") == 1);
  CHECK(edit_distance("clock", "colck") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ca", "abc") == 3);
}

TEST_CASE("the nearest name is suggested only when it may be meant") {
  CHECK(allowed_names("clok", {"ram", "clock"}) == "allowed: ram, clock; did you mean `clock`?");
  CHECK(allowed_names("wheel", {"ram", "clock"}) == "allowed: ram, clock");
  CHECK(allowed_names("x", {}) == "none is allowed here");
  CHECK(allowed_names(std::string(100'000, 'x'), {"ram"}) == "allowed: ram");
}

TEST_CASE("long lists are cut with the number of the rest") {
  const std::vector<std::string_view> names(50, "name");
  const std::string message = allowed_names("other", names);
  CHECK(message.substr(message.size() - 11) == "and 10 more");
}

}  // namespace maquette::sim
