#include "sim/database/memory_map.hpp"

#include <algorithm>
#include <string>

#include "firmware/arithmetic/maquette_ffp/package.hpp"
#include "sim/database/board_image.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/scene/description_loader.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

using namespace maquette;
using namespace maquette::sim;

namespace {

Description described(const std::string& scene, const std::vector<std::string>& overrides = {}) {
  const std::string directory = data_directory().string();
  return load_description({directory + "/scenes/" + scene, {}, overrides, directory});
}

MemoryMap map_of(const Description& description) {
  const auto packed =
      packed_scene<float>(description.scene, picture_format_of(description.machine));
  return memory_map_of(packed, description.machine);
}

const MemoryUse& use_of(const MemoryMap& map, const std::string& name) {
  const auto use = std::find_if(map.uses.begin(), map.uses.end(),
                                [&name](const MemoryUse& one) { return one.name == name; });
  REQUIRE(use != map.uses.end());
  return *use;
}

BoardImage image_of(const Description& description) {
  const PreparedScene<float> scene(
      packed_scene<float>(description.scene, picture_format_of(description.machine)));
  SynthesisArea<float> area(scene.frame().database);
  return board_image(models::numbers_of(description.machine.parameters.board.arithmetic), scene,
                     area.view(), {}, board_room(description.machine, 0x900000));
}

TEST_CASE("the uses of a board's RAM follow one another up to the stack at its top") {
  for (const std::string scene : {"photo1.yaml", "photo3.yaml", "photo4.yaml", "teapot.yaml"}) {
    INFO(scene);
    const MemoryMap map = map_of(described(scene));
    std::int64_t address = 0;
    for (std::size_t i = 0; i + 1 < map.uses.size(); ++i) {
      CHECK(map.uses[i].address == address);
      address += map.uses[i].bytes;
    }
    CHECK(map.uses.back().name == "stack");
    CHECK(map.uses.back().address + map.uses.back().bytes == map.ram_bytes);
    CHECK(map.used_bytes == address + map.uses.back().bytes);
    CHECK(map.stack_needed_bytes <= map.uses.back().bytes);
  }
}

TEST_CASE("the map is that of the image that a board gets") {
  for (const std::vector<std::string>& overrides :
       {std::vector<std::string>{},
        {"board.database=shared"},
        {"board.pixel_write=line"},
        {"frame_memory.place=boards", "allotment.order=interlaced", "board.ram=1 MiB"},
        {"board.arithmetic=mc68881"},
        {"board.arithmetic=ieee_single"},
        {"host.loads_code=false"}}) {
    const Description description = described("photo4.yaml", overrides);
    const MemoryMap map = map_of(description);
    const BoardImage image = image_of(description);
    const bool is_shared = models::is_shared(description.machine.parameters.board.database);
    const bool loads_code = description.machine.parameters.host.loads_code;
    CHECK(image.program.base == use_of(map, "firmware code").address);
    CHECK(image.program.package == use_of(map, "arithmetic package").address);
    CHECK(image.database == use_of(map, is_shared ? "task" : "database").address);
    CHECK(image.loaded_end == use_of(map, "preprocessed data").address);
    CHECK(map.loaded_bytes ==
          image.loaded_end - (loads_code ? image.program.base : image.database));
  }
}

TEST_CASE("what boards convert has its room behind the task, which only such scenes pay for") {
  const Description description = described("photo3.yaml");
  const PackedScene<float> packed =
      packed_scene<float>(description.scene, picture_format_of(description.machine));
  const MemoryMap map = map_of(description);
  const MemoryUse converted = use_of(map, "converted parameters");
  CHECK(converted.bytes == static_cast<std::int64_t>(4 * packed.parameters.size()));
  CHECK(converted.address == image_of(description).loaded_end);
  CHECK(use_of(map, "task").bytes == use_of(map_of(described("photo4.yaml")), "task").bytes +
                                         firmware::board_bytes<firmware::Conversion<float>>());
  CHECK(packed.given.size() < packed.parameters.size());
  const Description plain = described("photo4.yaml");
  CHECK(packed_scene<float>(plain.scene, picture_format_of(plain.machine)).given.empty());
  for (const MemoryUse& use : map_of(plain).uses) {
    CHECK(use.name != "converted parameters");
  }
  CHECK(address_of(image_of(plain).program, "converting_program") == k_left_out);
  CHECK(address_of(image_of(description).program, "converting_program") ==
        beginning_of(image_of(description).program));
}

TEST_CASE("an arithmetic package has the room that its table tells, or that of the program's") {
  const auto package_bytes = [](const std::string& arithmetic) {
    return use_of(map_of(described("photo4.yaml", {"board.arithmetic=" + arithmetic})),
                  "arithmetic package")
        .bytes;
  };
  const auto own_bytes = static_cast<std::int64_t>(std::size(firmware::maquette_ffp::k_package));
  CHECK(package_bytes("maquette_ffp") == own_bytes);
  CHECK(package_bytes("motorola_ffp") == own_bytes);
  CHECK(package_bytes("mc68881") == own_bytes);
  CHECK(package_bytes("vax_11_750_fpa") == 4096);
  CHECK(package_bytes("ieee_single") == 6144);
}

TEST_CASE("a database is the same bytes in a board's RAM and in shared memory") {
  const Description description = described("photo4.yaml");
  const PackedScene<float> packed =
      packed_scene<float>(description.scene, picture_format_of(description.machine));
  const std::vector<unsigned char> shared = database_image(packed, firmware::NumberFormat::ffp);
  const BoardImage image = image_of(description);
  REQUIRE(static_cast<std::int64_t>(shared.size()) ==
          use_of(map_of(description), "database").bytes);
  CHECK(std::equal(shared.begin(), shared.end(), image.ram.begin() + image.database));
}

TEST_CASE("what does not fit is refused with what to raise") {
  const auto refused = [](const std::string& override) {
    const Description description = described("photo4.yaml", {override});
    try {
      check_memory(map_of(description), description.machine, {});
    } catch (const DescriptionError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using Catch::Matchers::ContainsSubstring;
  CHECK(refused("board.ram=128 KiB").empty());
  CHECK_THAT(refused("board.ram=48 KiB"), ContainsSubstring("raise board.ram"));
  CHECK_THAT(refused("board.stack=1 KiB"), ContainsSubstring("raise board.stack"));
  CHECK_THAT(refused("board.crossings=8"), ContainsSubstring("raise board.crossings"));
  CHECK_THAT(refused("board.waiting_rays=2"), ContainsSubstring("raise board.waiting_rays"));
}

}  // namespace
