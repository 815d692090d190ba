#include "sim/page/provenance.hpp"

#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("What a manifest says of its origin is read as it was written") {
  Manifest manifest;
  manifest.command = {"maquette", "run", "a \"b\".yaml"};
  manifest.version = "1.2.3";
  manifest.revision = "abc";
  manifest.inputs = {{"/elsewhere/a.yaml", "0123456789012345678901234567890123456789"}};
  manifest.files = {"frame.png"};
  const Provenance provenance = parse_provenance(manifest_json(manifest), "manifest.json");
  CHECK(provenance.command == manifest.command);
  CHECK(provenance.version == "1.2.3");
  CHECK(provenance.revision == "abc");
  REQUIRE(provenance.inputs.size() == 1);
  CHECK(provenance.inputs[0].path == "a.yaml");
  CHECK(provenance.inputs[0].sha1 == manifest.inputs[0].sha1);
  CHECK(provenance.files == manifest.files);
}

TEST_CASE("What is no manifest is refused with its place") {
  for (const char* wrong :
       {"{", "[]", "{}", "{\"command\": 3}",
        R"({"command": ["a"], "version": "1", "revision": "b", "files": [1]})"}) {
    INFO(wrong);
    try {
      (void)parse_provenance(wrong, "dir/manifest.json");
      FAIL("it was read");
    } catch (const DescriptionError& error) {
      CHECK_THAT(error.what(), ContainsSubstring("dir/manifest.json:1:"));
    }
  }
}

TEST_CASE("The command can be pasted, and names no place of the machine") {
  const auto line = [](std::vector<std::string> command) {
    return command_line({std::move(command), "", "", {}, {}});
  };
  CHECK(line({"maquette", "run", "photo4", "--set", "bus.level=ideal"}) ==
        "maquette run photo4 --set bus.level=ideal");
  CHECK(line({"/elsewhere/maquette", "run", "/elsewhere/my scene.yaml",
              "--outdir=/elsewhere/a/"}) == "maquette run 'my scene.yaml' --outdir=a");
  CHECK(line({"it's", ""}) == "'it'\\''s' ''");
}
