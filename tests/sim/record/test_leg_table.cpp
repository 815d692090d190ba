#include "sim/record/leg_table.hpp"

#include "tests/catch.hpp"
#include "tests/sim/record/random_legs.hpp"

using namespace maquette;
using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;

namespace {

using Words = std::vector<std::uint32_t>;

std::vector<std::vector<models::PixelLeg>> random_pixels(std::mt19937& random) {
  std::vector<std::vector<models::PixelLeg>> pixels;
  for (auto left = random() % 40; left > 0; --left) {
    const bool is_again = !pixels.empty() && random() % 2 == 0;
    pixels.push_back(is_again ? pixels[random() % pixels.size()] : random_legs(random));
  }
  return pixels;
}

LegTable table_of(const std::vector<std::vector<models::PixelLeg>>& pixels) {
  LegTable table;
  for (const auto& legs : pixels) {
    table.put(legs);
  }
  return table;
}

}  // namespace

TEST_CASE("A table gives back the legs of each pixel, also by way of its words") {
  std::mt19937 random(7);
  for (int round = 0; round < 100; ++round) {
    const auto pixels = random_pixels(random);
    const LegTable table = table_of(pixels);
    LegTable read;
    REQUIRE(read.read(table.words()).empty());
    REQUIRE(table.pixels() == pixels.size());
    REQUIRE(read.pixels() == pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      REQUIRE(are_equal(table.legs(i), pixels[i]));
      REQUIRE(are_equal(read.legs(i), pixels[i]));
    }
    REQUIRE(read.words() == table.words());
  }
}

TEST_CASE("It is no matter in which parts pixels come") {
  std::mt19937 random(8);
  for (int round = 0; round < 100; ++round) {
    const auto pixels = random_pixels(random);
    LegTable whole;
    for (std::size_t i = 0; i < pixels.size();) {
      LegTable part;
      for (auto left = 1 + random() % 9; left > 0 && i < pixels.size(); --left) {
        part.put(pixels[i++]);
      }
      whole.append(part);
    }
    REQUIRE(whole.words() == table_of(pixels).words());
  }
}

TEST_CASE("Pixels that are alike take a word each") {
  std::mt19937 random(9);
  std::vector<std::vector<models::PixelLeg>> pixels(1, random_legs(random));
  const std::size_t one = table_of(pixels).words().size();
  pixels.resize(1000, pixels.front());
  CHECK(table_of(pixels).words().size() == one + 999);
}

TEST_CASE("Words that are damaged are refused, or are those of another table") {
  std::mt19937 random(10);
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    Words words = table_of(random_pixels(random)).words();
    if (round % 3 == 0) {
      words.resize(random() % words.size());
    } else {
      words[random() % words.size()] = static_cast<std::uint32_t>(random()) >> (random() % 32);
    }
    LegTable read;
    if (!read.read(words).empty()) {
      ++refused;
      continue;
    }
    REQUIRE(read.words() == words);
    for (std::size_t i = 0; i < read.pixels(); ++i) {
      static_cast<void>(read.legs(i));
    }
  }
  CHECK(refused > 1500);
}

TEST_CASE("What is wrong with words is said") {
  const auto error_of = [](const Words& words) { return LegTable().read(words); };
  CHECK(error_of({0, 0, 0, 0}).empty());
  CHECK_THAT(error_of({}), ContainsSubstring("not as many legs as it says"));
  CHECK_THAT(error_of({0, 0, 0, 0, 0}), ContainsSubstring("not as many legs as it says"));
  CHECK_THAT(error_of({1, 99, 0, 0, 0, 0, 0}), ContainsSubstring("a leg that no pixel can have"));
  CHECK_THAT(error_of({0, 1, 1, 0, 0, 0}), ContainsSubstring("a leg that is not there"));
  CHECK_THAT(error_of({0, 0, 0, 1, 0}), ContainsSubstring("a pixel whose legs are not there"));
  CHECK_THAT(error_of({0xFFFFFFFF}), ContainsSubstring("not as many legs as it says"));
}
