#include <nlohmann/json.hpp>

#include "sim/report/manifest.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/scratch_directory.hpp"

using maquette::sim::digest_of;
using maquette::sim::Manifest;
using maquette::sim::manifest_json;

TEST_CASE("inputs are hashed as FIPS 180 says, and named as they were given") {
  CHECK(digest_of({"./abc", "abc"}).path == "./abc");
  CHECK(digest_of({"./abc", "abc"}).sha1 == "a9993e364706816aba3e25717850c26c9cd0d89d");
  CHECK(digest_of({"empty", ""}).sha1 == "da39a3ee5e6b4b0d3255bfef95601890afd80709");
}

TEST_CASE("the manifest holds command, version, inputs and cost") {
  Manifest manifest;
  manifest.command = {"maquette", "run", "a \"b\"\xff"};
  manifest.version = "1.0.0";
  manifest.inputs = {{"s.yaml", "12"}};
  manifest.host_time_s = 1.5;
  measure_process(manifest);
  CHECK(manifest.peak_memory_bytes > 1'000'000);
  CHECK(manifest.processor_time_s > 0);
  const auto json = nlohmann::json::parse(manifest_json(manifest));
  CHECK(json["command"][1] == "run");
  CHECK(json["version"] == "1.0.0");
  CHECK(json["inputs"][0]["path"] == "s.yaml");
  CHECK(json["inputs"][0]["sha1"] == "12");
  CHECK(json["host_time_s"] == 1.5);
  CHECK(json["peak_memory_bytes"] == manifest.peak_memory_bytes);
  CHECK(json["inputs"].is_array());
  CHECK(nlohmann::json::parse(manifest_json({}))["inputs"].is_array());
  CHECK_FALSE(json.contains("points_per_s"));
  manifest.study = {2, 6};
  CHECK(nlohmann::json::parse(manifest_json(manifest))["points_per_s"] == 4);
}
