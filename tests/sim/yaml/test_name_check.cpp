#include "sim/yaml/name_check.hpp"

#include <filesystem>
#include <string>

#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("the name of a file leads to no other place") {
  for (const std::string& name :
       {std::string(), std::string("../x"), std::string("/x"), std::string("a/b"),
        std::string(".hidden"), std::string("."), std::string("-x"), std::string("a\0b", 3),
        std::string("a\nb"), std::string("a:b"), std::string("~"), std::string("a\x7f"),
        std::string("a*"), std::string(201, 'x')}) {
    INFO(name);
    CHECK_FALSE(is_file_name(name));
    CHECK_THROWS_WITH(check_file_name(name, {}, "name"),
                      ContainsSubstring("name: `") && ContainsSubstring("no name of a file"));
  }
  for (const std::string& name : {std::string("photo 4 (a+b), c=d.1"), std::string("château"),
                                  std::string("_"), std::string("4"), std::string(200, 'x')}) {
    INFO(name);
    CHECK(is_file_name(name));
    CHECK_NOTHROW(check_file_name(name, {}, "name"));
    CHECK((std::filesystem::path("runs") / name).lexically_normal().parent_path() == "runs");
  }
}

TEST_CASE("names that stand in paths of options have letters, digits, _ and - alone") {
  for (const std::string name : {"red", "a_b-2", "é"}) {
    CHECK_NOTHROW(check_name(name, {}, "surface"));
  }
  for (const std::string name : {"", "a b", "a.b", "a[0]", "a=b"}) {
    INFO(name);
    CHECK_THROWS_WITH(check_name(name, {}, "surface"), ContainsSubstring("surface: `"));
  }
}

TEST_CASE("a message shows no control characters of a name") {
  CHECK_THROWS_WITH(check_file_name(std::string("a\0b\x1b", 4), {}, "name"),
                    ContainsSubstring("`a?b?`"));
}
