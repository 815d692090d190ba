#include "sim/run/frame_film.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace maquette::sim {

namespace {

constexpr std::int64_t k_most_pictures = 10'000;

void blacken_other_field(int field, models::Picture& picture) {
  for (int row = field % 2; row < picture.height; row += 2) {
    const auto first = picture.pixels.begin() + static_cast<std::ptrdiff_t>(row) *
                                                    static_cast<std::ptrdiff_t>(picture.width);
    std::fill(first, first + picture.width, 0);
  }
}

}  // namespace

FrameFilm film_of(const models::CcettMachine& model) {
  const models::MachineStatistics statistics = model.statistics();
  return {model.frame_memory().background(), model.frame_memory().log(), model.video_timing(),
          statistics.load_time, statistics.frame_time};
}

std::vector<models::Duration> film_instants(models::Duration frame_time, models::Duration step,
                                            int pictures) {
  const bool has_step = step > models::Duration::zero();
  const std::int64_t count =
      has_step ? std::max<std::int64_t>(1, (frame_time - models::Duration(1)) / step + 1)
               : pictures;
  if (count > k_most_pictures) {
    throw std::invalid_argument("makes a film of " + std::to_string(count) +
                                " pictures; up to 10000 are allowed");
  }
  std::vector<models::Duration> instants;
  for (std::int64_t i = 1; i < count; ++i) {
    instants.push_back(has_step ? step * i : frame_time / count * i);
  }
  instants.push_back(frame_time);
  return instants;
}

models::Picture film_picture(const FrameFilm& film, models::Duration instant, bool as_fields) {
  const models::Instant shown = film.start + instant;
  models::Picture picture = models::shown_picture(film.background, film.writes, film.timing, shown);
  if (as_fields) {
    blacken_other_field(film.timing.position(shown).field, picture);
  }
  return picture;
}

}  // namespace maquette::sim
