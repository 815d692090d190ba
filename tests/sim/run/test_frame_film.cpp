#include "sim/run/frame_film.hpp"

#include <random>
#include <stdexcept>

#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

using models::Duration;

constexpr Duration k_second{1'000'000'000'000};

TEST_CASE("Instants of a film rise to the frame's end, steps apart or as many as asked for") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    const Duration frame(1 + static_cast<std::int64_t>(random() % 1'000'000'000'000'000));
    const int pictures = 1 + static_cast<int>(random() % 300);
    const std::vector<Duration> alike = film_instants(frame, {}, pictures);
    CHECK(alike.size() == static_cast<std::size_t>(pictures));
    CHECK(alike.back() == frame);
    const Duration step(1 + frame.count() / (1 + static_cast<std::int64_t>(random() % 99)));
    const std::vector<Duration> stepped = film_instants(frame, step, 0);
    CHECK(stepped.back() == frame);
    for (std::size_t k = 0; k + 1 < stepped.size(); ++k) {
      CHECK(stepped[k] == step * static_cast<std::int64_t>(k + 1));
      CHECK(stepped[k] < frame);
    }
  }
  CHECK(film_instants(10 * k_second, 5 * k_second, 0) ==
        std::vector<Duration>{5 * k_second, 10 * k_second});
  CHECK_THROWS_AS(film_instants(10 * k_second, Duration(1), 0), std::invalid_argument);
}

/// A frame memory of 4 x 4 pixels, each written at an instant of its own.
FrameFilm small_film() {
  models::VideoParameters video;
  FrameFilm film{{4, 4, std::vector<std::uint32_t>(16, 0x102030)},
                 {},
                 models::VideoTiming(video, 4, 4),
                 k_second,
                 16 * k_second};
  for (std::uint32_t pixel = 0; pixel < 16; ++pixel) {
    film.writes.push_back({(2 + pixel) * k_second, pixel, 0xFF0000 + pixel});
  }
  return film;
}

TEST_CASE("A film shows what was written and scanned, and as fields every other line of it") {
  const FrameFilm film = small_film();
  for (int second = 0; second <= 20; ++second) {
    const Duration instant = second * k_second + k_second / 2;
    const models::Picture picture = film_picture(film, instant, false);
    const models::Picture fields = film_picture(film, instant, true);
    const int field = film.timing.position(film.start + instant).field;
    for (int i = 0; i < 16; ++i) {
      const auto place = static_cast<std::size_t>(i);
      const bool is_written = second >= i + 1;
      CHECK(picture.pixels[place] ==
            (is_written ? 0xFF0000U + static_cast<std::uint32_t>(i) : 0x102030U));
      const bool is_scanned = (i / 4) % 2 == (field == 1 ? 0 : 1);
      CHECK(fields.pixels[place] == (is_scanned ? picture.pixels[place] : 0U));
    }
  }
}

}  // namespace
}  // namespace maquette::sim
