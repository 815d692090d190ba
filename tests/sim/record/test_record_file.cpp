#include "sim/record/record_file.hpp"

#include <cstring>
#include <optional>
#include <random>
#include <string>

#include "sim/record/record_image.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/record/random_legs.hpp"

namespace {

using Catch::Matchers::ContainsSubstring;
using maquette::firmware::k_operation_count;
using maquette::models::SynthesizedPixel;
using maquette::sim::check_record;
using maquette::sim::decode_record;
using maquette::sim::encode_record;
using maquette::sim::RecordedFrame;

constexpr std::uint32_t k_white = 0xFFFFFF;

// Every bit pattern of a count, and small ones, which are the usual ones.
std::uint32_t random_count(std::mt19937& random) {
  return static_cast<std::uint32_t>(random()) >> (random() % 32);
}

SynthesizedPixel random_pixel(std::mt19937& random) {
  SynthesizedPixel pixel{};
  pixel.depth = static_cast<std::uint16_t>(random_count(random));
  pixel.rgb = static_cast<std::uint32_t>(random()) & k_white;
  for (std::uint32_t* count :
       {&pixel.rays.primary, &pixel.rays.reflected, &pixel.rays.refracted, &pixel.rays.shadow}) {
    *count = random_count(random);
  }
  for (std::uint32_t& count : pixel.work.counts) {
    count = random_count(random);
  }
  return pixel;
}

void randomise(std::mt19937& random, maquette::sim::FunctionWork& work) {
  work.reach(1 + random() % maquette::firmware::k_ray_kind_count);
  for (int i = 0; i < 50; ++i) {
    auto& cell = work.cells[random() % work.cells.size()];
    cell[random() % cell.size()] = std::uint64_t{random_count(random)} << (random() % 32);
  }
  for (auto& counts : work.extents) {
    counts = {random_count(random), random_count(random), random_count(random)};
  }
  work.intersection_roots[random() % work.intersection_roots.size()] = random_count(random);
}

RecordedFrame random_frame(std::mt19937& random) {
  RecordedFrame frame;
  const auto number = [&random](int end) { return static_cast<int>(random() % unsigned(end)); };
  frame.key = {std::string(40, 'a'), std::string(40, 'b'), {1 + number(60), 1 + number(40)}};
  frame.key.format.has_depth = random() % 2 == 0;
  auto& zone = frame.useful_zone;
  zone.width = number(frame.key.format.width + 1);
  zone.height = zone.width == 0 ? 0 : 1 + number(frame.key.format.height);
  zone.column0 = zone.width == 0 ? 0 : number(frame.key.format.width - zone.width + 1);
  zone.row0 = zone.width == 0 ? 0 : number(frame.key.format.height - zone.height + 1);
  for (std::uint32_t& count : frame.preprocessing.counts) {
    count = random_count(random);
  }
  randomise(random, frame.by_function.preprocessing);
  randomise(random, frame.by_function.pixels);
  for (int row = 0; row < zone.height; ++row) {
    for (int column = 0; column < zone.width; ++column) {
      frame.pixels.push_back(random_pixel(random));
      frame.pixels.back().column = static_cast<std::uint16_t>(zone.column0 + column);
      frame.pixels.back().row = static_cast<std::uint16_t>(zone.row0 + row);
    }
  }
  return frame;
}

bool are_equal(const SynthesizedPixel& a, const SynthesizedPixel& b) {
  return a.column == b.column && a.row == b.row && a.depth == b.depth && a.rgb == b.rgb &&
         std::memcmp(&a.rays, &b.rays, sizeof a.rays) == 0 &&
         std::memcmp(&a.work, &b.work, sizeof a.work) == 0;
}

bool are_equal(const maquette::sim::FunctionWork& a, const maquette::sim::FunctionWork& b) {
  return numbers_of(a) == numbers_of(b);
}

bool are_equal(const RecordedFrame& a, const RecordedFrame& b) {
  bool equal = a.key.name() == b.key.name() && a.pixels.size() == b.pixels.size() &&
               std::memcmp(&a.useful_zone, &b.useful_zone, sizeof a.useful_zone) == 0 &&
               std::memcmp(&a.preprocessing, &b.preprocessing, sizeof a.preprocessing) == 0 &&
               are_equal(a.by_function.preprocessing, b.by_function.preprocessing) &&
               are_equal(a.by_function.pixels, b.by_function.pixels);
  for (std::size_t i = 0; equal && i < a.pixels.size(); ++i) {
    equal = are_equal(a.pixels[i], b.pixels[i]);
  }
  return equal;
}

}  // namespace

TEST_CASE("a record comes back from its file as it was, with the same bytes each time") {
  std::mt19937 random(31);
  for (int i = 0; i < 30; ++i) {
    const RecordedFrame frame = random_frame(random);
    const std::string bytes = encode_record(frame);
    REQUIRE(are_equal(decode_record(bytes, "file.exr"), frame));
    REQUIRE(encode_record(frame) == bytes);
  }
}

namespace {

RecordedFrame random_frame_with_legs(std::mt19937& random) {
  RecordedFrame frame;
  while (frame.pixels.empty()) {
    frame = random_frame(random);
  }
  for (SynthesizedPixel& pixel : frame.pixels) {
    const auto legs = maquette::sim::random_legs(random);
    pixel.work = maquette::sim::sum_of(legs);
    frame.legs.put(legs);
  }
  return frame;
}

}  // namespace

TEST_CASE("a record brings back the legs of its pixels, with the same bytes each time") {
  std::mt19937 random(41);
  for (int i = 0; i < 10; ++i) {
    const RecordedFrame frame = random_frame_with_legs(random);
    const std::string bytes = encode_record(frame);
    const RecordedFrame read = decode_record(bytes, "file.exr");
    REQUIRE(are_equal(read, frame));
    REQUIRE(read.has_legs());
    REQUIRE(read.legs.words() == frame.legs.words());
    REQUIRE(encode_record(read) == bytes);
    RecordedFrame without = frame;
    without.legs = {};
    const std::string fewer = encode_record(without);
    REQUIRE(fewer.find("maquetteLegWords") == std::string::npos);
    REQUIRE_FALSE(decode_record(fewer, "file.exr").has_legs());
  }
}

TEST_CASE("a record whose legs are not those of its pixels is refused") {
  std::mt19937 random(42);
  const auto error_of = [](maquette::sim::ExrImage image, auto damage) {
    damage(image);
    image.attributes[maquette::sim::k_record_digest] = maquette::sim::record_digest(image);
    try {
      static_cast<void>(maquette::sim::frame_of(image, "x.exr"));
    } catch (const maquette::sim::DescriptionError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const RecordedFrame frame = random_frame_with_legs(random);
  const maquette::sim::ExrImage image = record_image(frame);
  CHECK(error_of(image, [](auto&) {}).empty());
  CHECK_THAT(error_of(image, [](auto& damaged) { ++damaged.channels.back().values[0]; }),
             ContainsSubstring("x.exr: is damaged: its legs are of another content"));
  CHECK_THAT(error_of(image, [](auto& damaged) { damaged.channels.pop_back(); }),
             ContainsSubstring("x.exr: has fewer words of legs than it says"));
  RecordedFrame other = frame;
  ++other.pixels.back().work.counts[3];
  CHECK_THAT(error_of(record_image(other), [](auto&) {}),
             ContainsSubstring("x.exr: has legs that are not those of its pixels"));
  other = frame;
  other.legs.put({});
  CHECK_THAT(error_of(record_image(other), [](auto&) {}),
             ContainsSubstring("x.exr: has legs that are not those of its pixels"));
}

TEST_CASE("a record holds no clock") {
  std::mt19937 random(33);
  const std::string bytes = encode_record(random_frame(random));
  const std::string date("capDate\0string\0", 15);
  const std::size_t at = bytes.find(date);
  REQUIRE((at == std::string::npos || bytes.substr(at + date.size(), 4) == std::string(4, '\0')));
}

TEST_CASE("every colour survives, and a useful zone may be empty or the whole screen") {
  RecordedFrame frame;
  frame.key = {std::string(40, 'a'), std::string(40, 'b'), {256, 1}};
  REQUIRE(are_equal(decode_record(encode_record(frame), "file.exr"), frame));
  frame.useful_zone = {0, 0, 256, 1};
  for (std::uint32_t code = 0; code < 256; ++code) {
    frame.pixels.push_back(
        {static_cast<std::uint16_t>(code), 0, 0, code << 16 | (255 - code) << 8 | code, {}, {}});
  }
  REQUIRE(are_equal(decode_record(encode_record(frame), "file.exr"), frame));
}

TEST_CASE("a file that is cut or damaged is refused or read as it was, never a crash") {
  std::mt19937 random(32);
  const RecordedFrame frame = random_frame(random);
  const std::string bytes = encode_record(frame);
  for (const std::string& wrong : {std::string(), std::string("text"), bytes.substr(0, 100),
                                   bytes.substr(0, bytes.size() / 2)}) {
    REQUIRE_THROWS_AS(decode_record(wrong, "file.exr"), maquette::sim::DescriptionError);
  }
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = bytes;
    damaged[random() % (i % 2 == 0 ? 2000 : damaged.size())] ^=
        static_cast<char>(1U << random() % 8);
    std::optional<RecordedFrame> read;
    try {
      read = decode_record(damaged, "file.exr");
    } catch (const maquette::sim::DescriptionError& error) {
      REQUIRE_THAT(error.what(), ContainsSubstring("file.exr"));
    }
    REQUIRE((!read || are_equal(*read, frame)));
  }
}

TEST_CASE(
    "a record whose useful zone is not within its picture is refused, whatever its digest says") {
  std::mt19937 random(34);
  const RecordedFrame frame = random_frame(random);
  const maquette::sim::ExrImage image = maquette::sim::record_image(frame);
  for (const char* zone : {"-1 0 1 1", "0 0 -5 0", "0 0 2147483647 2147483647", "2147483647 0 1 1",
                           "0 65536 1 1", "0 0 0 -1"}) {
    INFO(zone);
    maquette::sim::ExrImage wrong = image;
    wrong.attributes["maquetteUsefulZone"] = zone;
    wrong.attributes[maquette::sim::k_record_digest] = maquette::sim::record_digest(wrong);
    REQUIRE_THROWS_WITH(maquette::sim::frame_of(wrong, "file.exr"),
                        ContainsSubstring("not within its picture"));
  }
}

TEST_CASE("a record of another scene, size or firmware is refused by name") {
  const maquette::sim::RecordKey key{std::string(40, 'a'), std::string(40, 'b'), {768, 575}};
  REQUIRE_NOTHROW(check_record(key, key, "file.exr"));
  auto other = key;
  other.scene_sha1[7] = 'c';
  REQUIRE_THROWS_WITH(check_record(key, other, "file.exr"),
                      ContainsSubstring("file.exr: a record of another scene"));
  other = key;
  other.format.height = 576;
  REQUIRE_THROWS_WITH(
      check_record(key, other, "file.exr"),
      ContainsSubstring("768 x 576") && ContainsSubstring("allowed: one of 768 x 575"));
  other = key;
  other.format.has_depth = true;
  REQUIRE_THROWS_WITH(check_record(key, other, "file.exr"),
                      ContainsSubstring("a record with depths"));
  other = key;
  other.firmware[0] = 'c';
  REQUIRE_THROWS_WITH(check_record(key, other, "file.exr"), ContainsSubstring("firmware c"));
  REQUIRE(key.name() != other.name());
}
