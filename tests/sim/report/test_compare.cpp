#include <cmath>
#include <random>
#include <set>

#include "sim/picture/image_file.hpp"
#include "sim/report/compare.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/scratch_directory.hpp"

using maquette::models::Picture;
using namespace maquette::sim;
using maquette::tests::ScratchDirectory;

namespace {

Picture noise(std::mt19937& random, int width, int height) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    picture.pixels.push_back(static_cast<std::uint32_t>(random() & 0xffffff));
  }
  return picture;
}

void write_run(const std::filesystem::path& directory, const std::string& configuration,
               const std::string& statistics, const Picture& picture) {
  create_run_directory(directory);
  write_files(directory, {{"config.yaml", configuration},
                          {"stats.json", statistics},
                          {"frame.png", encode_png(picture)}});
}

}  // namespace

TEST_CASE("values: exactly the planted differences are found") {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    FlatValues first;
    FlatValues second;
    std::set<std::string> planted;
    for (int i = 0; i < 30; ++i) {
      const std::string path = "group.key" + std::to_string(i);
      const std::string value = std::to_string(random() % 1000);
      switch (random() % 8) {
        case 0:
          first.emplace_back(path, value);
          second.emplace_back(path, value + "1");
          planted.insert(path);
          break;
        case 1:
          first.emplace_back(path, value);
          planted.insert(path);
          break;
        case 2:
          second.emplace_back(path, value);
          planted.insert(path);
          break;
        default:
          first.emplace_back(path, value);
          second.emplace_back(path, value);
      }
    }
    std::set<std::string> found;
    for (const auto& difference : compare_values(first, second)) {
      REQUIRE(found.insert(difference.path).second);
    }
    REQUIRE(found == planted);
  }
}

TEST_CASE("values: relative differences, and numbers in another writing") {
  const auto differences = compare_values(
      {{"a", "4"}, {"b", "0"}, {"c", "-2"}, {"d", "8 MHz"}, {"e", "1.50"}, {"f", "yes"}},
      {{"a", "5"}, {"b", "-1"}, {"c", "-1"}, {"d", "9 MHz"}, {"e", "1.5"}, {"f", "yes"}});
  REQUIRE(differences.size() == 4);
  CHECK(differences[0].relative == 0.25);
  CHECK(differences[1].relative == -INFINITY);
  CHECK(differences[2].relative == 0.5);
  CHECK_FALSE(differences[3].relative.has_value());
}

TEST_CASE("values: times that differ by one tick differ, however long") {
  CHECK(compare_values({{"t", "90000.000000000001"}}, {{"t", "90000.000000000002"}}).size() == 1);
}

TEST_CASE("pictures: count, largest and mean of planted changes") {
  std::mt19937 random(8);
  for (int round = 0; round < 50; ++round) {
    const Picture first = noise(random, 13, 9);
    Picture second = first;
    std::set<std::size_t> pixels;
    std::set<std::size_t> far;
    std::array<int, 3> largest{};
    std::array<std::int64_t, 3> sums{};
    std::set<std::size_t> places;
    for (auto count = random() % 20; count > 0; --count) {
      const std::size_t place = random() % (3 * first.pixels.size());
      if (!places.insert(place).second) {
        continue;
      }
      const auto shift = static_cast<int>(16 - 8 * (place % 3));
      const auto from = static_cast<int>(first.pixels[place / 3] >> shift & 0xff);
      const int change = static_cast<int>(1 + (random() % 2 == 0 ? 0 : random() % 127));
      const int to = from < 128 ? from + change : from - change;
      second.pixels[place / 3] ^= static_cast<std::uint32_t>(from ^ to) << shift;
      pixels.insert(place / 3);
      if (change > 1) {
        far.insert(place / 3);
      }
      largest[place % 3] = std::max(largest[place % 3], change);
      sums[place % 3] += change;
    }
    const auto difference = compare_pictures(first, second);
    REQUIRE(difference.pixels == static_cast<std::int64_t>(pixels.size()));
    REQUIRE(difference.pixels_off == static_cast<std::int64_t>(far.size()));
    REQUIRE(difference.largest == largest);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      REQUIRE(difference.mean[channel] ==
              Approx(static_cast<double>(sums[channel]) / (13 * 9)).epsilon(1e-12));
    }
  }
}

TEST_CASE("runs: equal ones are equal, and each kind of difference is told") {
  const ScratchDirectory scratch;
  std::mt19937 random(9);
  const Picture picture = noise(random, 8, 8);
  const std::string configuration = "bus: {clock: 8 MHz, arbitration: priority}\nboards: [1, 2]\n";
  const std::string statistics = R"({"frame": {"time_s": 422.5}, "partial": false})";
  write_run(scratch.path() / "a", configuration, statistics, picture);
  const auto compare_with_b = [&scratch] {
    return compare_runs(scratch.path() / "a", scratch.path() / "b");
  };

  SECTION("equal") {
    write_run(scratch.path() / "b", configuration, statistics, picture);
    CHECK(compare_with_b().equal());
    CHECK(comparison_report(compare_with_b()) ==
          "configuration: equal\nstatistics: equal\npicture: equal\n");
  }
  SECTION("configuration") {
    write_run(scratch.path() / "b", "bus: {clock: 8 MHz, arbitration: round_robin}\nboards: [1]\n",
              statistics, picture);
    const auto comparison = compare_with_b();
    CHECK_FALSE(comparison.equal());
    CHECK(comparison_report(comparison) ==
          "configuration: 2 values differ\n  bus.arbitration: priority -> round_robin\n"
          "  boards[1]: 2 -> (absent)\nstatistics: equal\npicture: equal\n");
  }
  SECTION("statistics") {
    write_run(scratch.path() / "b", configuration,
              R"({"frame": {"time_s": 845}, "partial": false})", picture);
    const auto comparison = compare_with_b();
    CHECK_FALSE(comparison.equal());
    CHECK(comparison_report(comparison) ==
          "configuration: equal\nstatistics: 1 value differs\n"
          "  frame.time_s: 422.5 -> 845 (+100 %)\npicture: equal\n");
  }
  SECTION("picture") {
    Picture changed = picture;
    changed.pixels[1] ^= 64U << 8;
    write_run(scratch.path() / "b", configuration, statistics, changed);
    const auto comparison = compare_with_b();
    CHECK_FALSE(comparison.equal());
    CHECK_THAT(
        comparison_report(comparison),
        Catch::Matchers::ContainsSubstring("picture: 1 pixel differs (1.56 %)") &&
            Catch::Matchers::ContainsSubstring("green: largest difference 64 of 255, mean 1"));
  }
  SECTION("size of the picture") {
    write_run(scratch.path() / "b", configuration, statistics, noise(random, 8, 9));
    const auto comparison = compare_with_b();
    CHECK_FALSE(comparison.equal());
    CHECK_THAT(comparison_report(comparison),
               Catch::Matchers::ContainsSubstring("sizes differ, 8 x 8 -> 8 x 9"));
  }
  SECTION("missing or damaged files") {
    CHECK_THROWS_AS(compare_with_b(), DescriptionError);
    for (const char* name : {"config.yaml", "stats.json", "frame.png"}) {
      INFO(name);
      write_run(scratch.path() / "b", configuration, statistics, picture);
      write_files(scratch.path() / "b", {{name, "{ damaged"}});
      CHECK_THROWS_WITH(compare_with_b(), Catch::Matchers::ContainsSubstring(name));
      std::filesystem::remove(scratch.path() / "b" / name);
      CHECK_THROWS_WITH(compare_with_b(), Catch::Matchers::ContainsSubstring(name));
    }
  }
}
