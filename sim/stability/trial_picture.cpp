#include "sim/stability/trial_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace maquette::sim {

namespace {

template <class Real>
bool is_sound(const firmware::Color<Real>& luminance) {
  for (int i = 0; i < 3; ++i) {
    if (!(std::isfinite(luminance[i]) && luminance[i] >= Real{0})) {
      return false;
    }
  }
  return true;
}

}  // namespace

template <class Real>
TrialPicture trial_picture(const PreparedScene<Real>& prepared, int stride) {
  const firmware::Frame<Real>& frame = prepared.frame();
  const firmware::Observer<Real>& observer = frame.database.observer;
  SynthesisArea<Real> area(frame.database);
  TrialPicture picture;
  for (int row = 0; row < observer.rows; row += stride) {
    for (int column = 0; column < observer.columns; column += stride) {
      firmware::Sight<Real> sight;
      const auto ray = firmware::primary_ray(frame.database, static_cast<std::int16_t>(column),
                                             static_cast<std::int16_t>(row));
      const firmware::Color<Real> luminance = firmware::luminance(frame, ray, area.view(), sight);
      const bool sound = is_sound(luminance);
      picture.unsound += sound ? 0 : 1;
      picture.pixels.push_back(sound ? firmware::rgb_of(luminance) : 0);
    }
  }
  return picture;
}

template TrialPicture trial_picture<float>(const PreparedScene<float>& prepared, int stride);
template TrialPicture trial_picture<double>(const PreparedScene<double>& prepared, int stride);

int largest_difference(std::uint32_t a, std::uint32_t b) {
  int largest = 0;
  for (const unsigned shift : {0U, 8U, 16U}) {
    const auto of_a = static_cast<int>(a >> shift & 0xFFU);
    const auto of_b = static_cast<int>(b >> shift & 0xFFU);
    largest = std::max(largest, std::abs(of_a - of_b));
  }
  return largest;
}

int differing_pixels(const TrialPicture& a, const TrialPicture& b, int levels) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    count += largest_difference(a.pixels[i], b.pixels[i]) > levels ? 1 : 0;
  }
  return count;
}

}  // namespace maquette::sim
