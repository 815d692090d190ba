#include <set>

#include "sim/picture/image_file.hpp"
#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr const char* k_sphere = MAQUETTE_PROJECT_DIRECTORY "/scenes/primitives/sphere.yaml";
constexpr const char* k_glass = MAQUETTE_PROJECT_DIRECTORY "/scenes/effects/refraction.yaml";
Outcome run_into(const std::filesystem::path& directory, const std::string& scene,
                 const std::string& options) {
  return run_maquette("run " + scene + k_small_frame + "--quiet --outdir " + directory.string() +
                      " " + options);
}

void require_good(const Outcome& outcome) {
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
}

}  // namespace

TEST_CASE("A replayed record gives the bytes of the direct run, on any machine") {
  const ScratchDirectory scratch;
  const std::string record = (scratch / "glass.exr").string();
  require_good(run_into(scratch / "recording", k_glass, "--record " + record));
  const char* const machines[] = {
      "", "--set processors=7 --set allotment.order=tiles", "--set bus.arbitration=round_robin",
      "--set board.arithmetic=ieee_single --set bus.data_width='32 bits'",
      "--set board.release=block --set board.pixel_write=line --set allotment.order=bands"};
  for (const char* machine : machines) {
    INFO(machine);
    require_good(run_into(scratch / "direct", k_glass, machine));
    require_good(run_into(scratch / "replayed", k_glass,
                          std::string("--processor recorded --record ") + record + " " + machine));
    for (const char* name : {"stats.json", "frame.png", "config.yaml"}) {
      INFO(name);
      CHECK(content_of(scratch / "direct" / name) == content_of(scratch / "replayed" / name));
    }
  }
  require_good(run_into(scratch / "direct", k_glass, ""));
  CHECK(content_of(scratch / "direct" / "stats.json") ==
        content_of(scratch / "recording" / "stats.json"));
}

TEST_CASE("A run directory keeps a record of its own, which is not made again") {
  const ScratchDirectory scratch;
  require_good(run_into(scratch / "run", k_sphere, "--processor recorded"));
  const auto records = std::filesystem::directory_iterator(scratch / "run" / "record");
  const std::filesystem::path kept = begin(records)->path();
  const std::string first = content_of(kept);
  // A mark that only a replay of this very file can bring back.
  const std::filesystem::path other = scratch / "other.exr";
  require_good(run_into(scratch / "other", k_glass, "--record " + other.string()));
  std::filesystem::copy_file(other, kept, std::filesystem::copy_options::overwrite_existing);
  const Outcome refused = run_into(scratch / "run", k_sphere, "--processor recorded");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.errors, ContainsSubstring("a record of another scene"));
  std::filesystem::remove(kept);
  require_good(run_into(scratch / "run", k_sphere, "--processor recorded"));
  CHECK(content_of(kept) == first);
}

TEST_CASE("Records that do not belong to a run are refused and nothing is written") {
  const ScratchDirectory scratch;
  const std::string record = (scratch / "sphere.exr").string();
  require_good(run_into(scratch / "run", k_sphere, "--record " + record));
  const std::string text = scratch.file("text.exr", "not a picture");
  const std::string replay = "--processor recorded --record ";
  const struct {
    std::string scene;
    std::string options;
    const char* message;
  } cases[] = {
      {k_glass, replay + record, "a record of another scene"},
      {k_sphere, replay + record + " --set frame_memory.width='97 pixels'", "a record of "},
      {k_sphere, replay + text, "text.exr: is not an OpenEXR file"},
      {k_sphere, replay + (scratch / "none.exr").string(), "none.exr"},
      {k_sphere, "--record /proc/none/there.exr", "/proc/none"}};
  for (const auto& one : cases) {
    const Outcome outcome = run_into(scratch / "refused", one.scene, one.options);
    INFO(one.options);
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.errors, ContainsSubstring(one.message));
    CHECK_FALSE(std::filesystem::exists(scratch / "refused" / "stats.json"));
  }
}

TEST_CASE("The paper's second machine keeps a depth with each pixel") {
  const ScratchDirectory scratch;
  require_good(run_into(scratch / "run", k_sphere, "--machine vax-11-750"));
  const auto depths =
      maquette::sim::decode_depths(content_of(scratch / "run" / "depth.png"), "depth.png");
  const auto picture =
      maquette::sim::decode_png(content_of(scratch / "run" / "frame.png"), "frame.png");
  REQUIRE(depths.values.size() == picture.pixels.size());
  constexpr std::uint16_t k_farthest = 0xFFFF;
  std::size_t nearer = 0;
  std::set<int> low_bytes;
  for (std::size_t i = 0; i < depths.values.size(); ++i) {
    if (depths.values[i] != k_farthest) {
      ++nearer;
      low_bytes.insert(depths.values[i] % 256);
    } else {
      REQUIRE(picture.pixels[i] == picture.pixels.front());  // the background
    }
  }
  CHECK(nearer > depths.values.size() / 20);
  CHECK(low_bytes.size() > 200);  // all sixteen bits are there
  require_good(run_into(scratch / "compared", k_sphere,
                        "--machine vax-11-750 --set frame_memory.depth_compare=true"));
  for (const char* file : {"frame.png", "depth.png"}) {
    CHECK(content_of(scratch / "compared" / file) == content_of(scratch / "run" / file));
  }
  require_good(run_into(scratch / "prototype", k_sphere, ""));
  CHECK_FALSE(std::filesystem::exists(scratch / "prototype" / "depth.png"));
}
