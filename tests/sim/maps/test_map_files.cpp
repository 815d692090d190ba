#include "sim/maps/map_files.hpp"

#include <cmath>
#include <cstring>
#include <random>

#include "sim/maps/map_picture.hpp"
#include "sim/maps/map_reading.hpp"
#include "sim/picture/picture_module.hpp"
#include "sim/picture_module/exr_codec.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

PixelFacts random_facts(std::mt19937& random) {
  PixelFacts facts;
  facts.width = 40;
  facts.height = 30;
  facts.zone = {7, 9, 11, 5};
  facts.boards = {"board0", "board1"};
  for (std::int64_t i = 0; i < facts.zone.pixels(); ++i) {
    models::PixelTime time;
    time.board = static_cast<int>(random() % 2);
    time.spent = {models::Duration(random()), models::Duration(random()),
                  models::Duration(random())};
    facts.times.push_back(time);
    facts.written.push_back(i == 3 ? models::k_never : models::Duration(random()));
    models::SynthesizedPixel pixel{};
    pixel.rays = {1, 2, static_cast<std::uint32_t>(random()), 4};
    facts.pixels.push_back(pixel);
  }
  return facts;
}

float real_of(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

TEST_CASE("Reading a file of maps gives each of them with its zone and its names") {
  std::mt19937 random(12);
  const PixelFacts facts = random_facts(random);
  const std::vector<Map> maps = maps_named({"board", "rays.refracted", "time"});
  const ReadMaps read = decode_maps(encode_maps(maps, facts), "maps.exr");
  CHECK(read.zone.column0 == facts.zone.column0);
  CHECK(read.zone.row0 == facts.zone.row0);
  CHECK(read.zone.width == facts.zone.width);
  CHECK(read.zone.height == facts.zone.height);
  REQUIRE(read.maps.size() == maps.size());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    CHECK(read.maps[i].map->name == maps[i].name);
    const std::vector<double> told = told_values(maps[i], facts);
    REQUIRE(read.maps[i].values.size() == told.size());
    for (std::size_t pixel = 0; pixel < told.size(); ++pixel) {
      const double kept = maps[i].kind == MapKind::count
                              ? told[pixel]
                              : static_cast<double>(static_cast<float>(told[pixel]));
      CHECK((std::isnan(kept) ? std::isnan(read.maps[i].values[pixel])
                              : read.maps[i].values[pixel] == kept));
    }
    CHECK(read.maps[i].names == (maps[i].name == "board" ? "board0, board1" : ""));
  }
  CHECK_THROWS_AS(decode_maps("no maps", "maps.exr"), DescriptionError);
}

TEST_CASE("Maps read again are the values that were told, with units and titles") {
  std::mt19937 random(11);
  const PixelFacts facts = random_facts(random);
  const std::vector<Map> maps = maps_named({"time", "wait", "board", "rays.refracted"});
  const ExrCodec& codec =
      *reinterpret_cast<const ExrCodec* (*)()>(picture_module_function(k_exr_codec_function))();
  ExrImage image;
  for (const Map& map : maps) {
    image.channels.push_back(
        {map.name, map.kind == MapKind::count ? ExrStorage::count : ExrStorage::real, {}});
    image.attributes["unit." + map.name];
    image.attributes["title." + map.name];
  }
  image.attributes["names.board"];
  REQUIRE(codec.decode(encode_maps(maps, facts), image).empty());
  CHECK(image.width == facts.width);
  CHECK(image.data_column == facts.zone.column0);
  CHECK(image.data_height == facts.zone.height);
  CHECK(image.attributes["unit.time"] == "s");
  CHECK(image.attributes["unit.rays.refracted"] == "rays");
  CHECK(image.attributes["names.board"] == "board0, board1");
  for (std::size_t map = 0; map < maps.size(); ++map) {
    const ExrChannel& channel = image.channels[map];
    for (std::size_t pixel = 0; pixel < facts.times.size(); ++pixel) {
      const double told = maps[map].value(facts, pixel);
      if (channel.storage == ExrStorage::count) {
        CHECK(channel.values[pixel] == told);
      } else if (std::isnan(told)) {
        CHECK(pixel == 3);
        CHECK(std::isnan(real_of(channel.values[pixel])));
      } else {
        CHECK(real_of(channel.values[pixel]) ==
              static_cast<float>(maps[map].kind == MapKind::time ? told / 1e12 : told));
      }
    }
  }
}

TEST_CASE("Files of maps are named for them; without maps or pixels there are none") {
  std::mt19937 random(12);
  PixelFacts facts = random_facts(random);
  const std::vector<Map> maps = maps_named({"time", "rays.refracted"});
  const std::vector<NamedContent> files = map_files(maps, maps, facts, "scene");
  REQUIRE(files.size() == 3);
  CHECK(files[0].name == "maps.exr");
  CHECK(files[1].name == "map-time.png");
  CHECK(files[2].name == "map-rays.refracted.png");
  CHECK(map_files({}, {}, facts, "scene").empty());
  facts.zone = {};
  CHECK(map_files(maps, maps, facts, "scene").empty());
}

}  // namespace
}  // namespace maquette::sim
