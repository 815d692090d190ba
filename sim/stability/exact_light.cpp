#include "sim/stability/exact_light.hpp"

#include <algorithm>
#include <cmath>

#include "sim/stability/crease_scenes.hpp"
#include "sim/stability/tally.hpp"
#include "sim/stability/trial_picture.hpp"

namespace maquette::sim {

namespace {

using trial::Random;

constexpr PictureFormat k_format{40, 30};
constexpr int k_levels = 1;

struct LightTally {
  int pixels = 0;
  int differing = 0;   ///< from the exact picture, by more than a level
  int impossible = 0;  ///< of them, those whose light no exact ray near them has

  void operator+=(const LightTally& other) {
    pixels += other.pixels;
    differing += other.differing;
    impossible += other.impossible;
  }
};

/// The light of exact rays anywhere on the screen.
class ExactLight {
 public:
  explicit ExactLight(const Scene& scene)
      : prepared_(packed_scene<double>(scene, k_format)), area_(prepared_.frame().database) {}

  [[nodiscard]] std::uint32_t at(double column, double row) {
    const firmware::Observer<double>& observer = prepared_.frame().database.observer;
    // The pixel serves the rectangles, which hold the neighbours of those that a body covers.
    // The scenes that are looked at so are seen in perspective.
    firmware::RayQuery<double> query = firmware::primary_ray<firmware::Projection::perspective>(
        observer, inside(column, observer.columns), inside(row, observer.rows));
    query.ray.direction.x = observer.left + column * observer.step;
    query.ray.direction.y = observer.top - row * observer.step;
    firmware::Sight<double> sight;
    return firmware::rgb_of(firmware::luminance(prepared_.frame(), query, area_.view(), sight));
  }

 private:
  static std::int16_t inside(double place, std::int32_t end) {
    return static_cast<std::int16_t>(
        std::clamp(static_cast<std::int32_t>(std::lround(place)), 0, end - 1));
  }

  PreparedScene<double> prepared_;
  SynthesisArea<double> area_;
};

/// Whether an exact ray within a pixel of this one has the same light, looked for in finer and
/// finer grids: where light changes within a pixel there is an edge of what is seen or of a shadow.
bool is_possible(ExactLight& exact, int column, int row, std::uint32_t rgb) {
  for (const int steps : {2, 5, 16, 64}) {
    for (int y = -steps; y <= steps; ++y) {
      for (int x = -steps; x <= steps; ++x) {
        const std::uint32_t near = exact.at(column + 1.0 * x / steps, row + 1.0 * y / steps);
        if (largest_difference(rgb, near) <= k_levels) {
          return true;
        }
      }
    }
  }
  return false;
}

void try_picture(const Scene& scene, LightTally& tally) {
  const TrialPicture tried = trial_picture<float>(scene, k_format);
  ExactLight exact(scene);
  std::size_t index = 0;
  for (int row = 0; row < k_format.height; ++row) {
    for (int column = 0; column < k_format.width; ++column) {
      const std::uint32_t rgb = tried.pixels[index++];
      ++tally.pixels;
      if (largest_difference(rgb, exact.at(column, row)) > k_levels) {
        ++tally.differing;
        tally.impossible += is_possible(exact, column, row, rgb) ? 0 : 1;
      }
    }
  }
}

}  // namespace

std::vector<StabilityRow> exact_light_rows(const std::vector<SolidFamily>& families, int pictures) {
  std::vector<StabilityRow> rows;
  std::uint32_t seed = 8000000;
  for (const CreaseScenes& kind : crease_scenes()) {
    const auto tally = tally_over<LightTally>(pictures, [&](int number, LightTally& sum) {
      Random random(seed + static_cast<std::uint32_t>(number));
      try_picture(kind.make(random, families), sum);
    });
    seed += 100000;
    rows.push_back({"light", kind.name, "pixels", 1.0 * tally.pixels, {}});
    rows.push_back(
        {"light", kind.name, "off by more than a level, at edges", 1.0 * tally.differing, {}});
    rows.push_back(
        {"light", kind.name, "of a light that none near has", 1.0 * tally.impossible, 0});
  }
  return rows;
}

}  // namespace maquette::sim
