#include "sim/run/changed_ranges.hpp"

#include <algorithm>
#include "sim/stability/random_cases.hpp"

#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

TEST_CASE("What is held and the changed parts together are the image") {
  trial::Random random(1601);
  for (int i = 0; i < 500; ++i) {
    const std::size_t word = random.coin() ? 2 : 4;
    std::vector<unsigned char> held(static_cast<std::size_t>(random.below(200)));
    for (unsigned char& byte : held) {
      byte = static_cast<unsigned char>(random.below(256));
    }
    std::vector<unsigned char> image = held;
    image.resize(static_cast<std::size_t>(random.below(200)), 7);
    for (int change = random.below(10); change > 0 && !image.empty(); --change) {
      image[static_cast<std::size_t>(random.below(static_cast<int>(image.size())))] ^= 1;
    }
    std::vector<unsigned char> memory = held;
    memory.resize(std::max(held.size(), image.size()));
    std::size_t end_of_last = 0;
    bool is_first = true;
    for (const models::ImageRange& range : changed_ranges(held, image, word)) {
      REQUIRE(range.first % word == 0);
      REQUIRE(range.end > range.first);
      REQUIRE((is_first || range.first > end_of_last));
      is_first = false;
      end_of_last = range.end;
      std::copy(image.begin() + static_cast<std::ptrdiff_t>(range.first),
                image.begin() + static_cast<std::ptrdiff_t>(range.end),
                memory.begin() + static_cast<std::ptrdiff_t>(range.first));
      for (std::size_t at = range.first; at < range.end; at += word) {
        const std::size_t end = std::min(at + word, image.size());
        const bool is_held =
            end <= held.size() && std::equal(image.begin() + static_cast<std::ptrdiff_t>(at),
                                             image.begin() + static_cast<std::ptrdiff_t>(end),
                                             held.begin() + static_cast<std::ptrdiff_t>(at));
        REQUIRE_FALSE(is_held);
      }
    }
    memory.resize(image.size());
    REQUIRE(memory == image);
  }
}

TEST_CASE("Nothing is loaded of what is held whole") {
  const std::vector<unsigned char> image{1, 2, 3, 4, 5};
  CHECK(changed_ranges(image, image, 2).empty());
}

}  // namespace
}  // namespace maquette::sim
