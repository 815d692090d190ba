#pragma once

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/test_frame.hpp"

/// Bodies held against their volume and area by random lines.
namespace maquette::firmware::trial {

/// What uniform isotropic random lines through a sphere tell of a body inside of it: the mean
/// length of its chords gives the volume, the mean number of crossings the area (Cauchy and
/// Crofton).
struct LineSums {
  double volume;
  double volume_error;  ///< standard error
  double area;
  double area_error;
};

template <class Real>
LineSums line_sums(BuiltFrame<Real>& built, const Vector<double>& center, double radius,
                   std::uint32_t seed) {
  constexpr int k_lines = 30000;
  Random random(seed);
  double chords = 0;
  double chords_squared = 0;
  double crossings = 0;
  double crossings_squared = 0;
  for (int i = 0; i < k_lines; ++i) {
    const Vector<double> direction = random.direction();
    const Vector<double> aside = random.direction_around(direction, 0);
    const double off = radius * std::sqrt(random.uniform());
    const auto met = built.crossings_of(center + aside * off - direction * (2 * radius), direction);
    double chord = 0;
    for (std::size_t k = 0; k + 1 < met.size(); k += 2) {
      chord += static_cast<double>(met[k + 1].distance) - static_cast<double>(met[k].distance);
    }
    const auto count = static_cast<double>(met.size());
    chords += chord;
    chords_squared += chord * chord;
    crossings += count;
    crossings_squared += count * count;
  }
  const double disc = elementary::k_pi * radius * radius;
  const auto error_of = [](double sum, double squares) {
    const double mean = sum / k_lines;
    return std::sqrt((squares / k_lines - mean * mean) / k_lines);
  };
  return {disc * chords / k_lines, disc * error_of(chords, chords_squared),
          2 * disc * crossings / k_lines, 2 * disc * error_of(crossings, crossings_squared)};
}

/// Places the model at random, without distortion, and compares what lines tell with closed values.
/// The body must lie within `radius` of the model's origin.
template <class Real, class Build>
void check_body(const Build& build, double radius, double volume, double area) {
  for (const std::uint32_t seed : {601U, 602U}) {
    Random random(seed);
    const double size = random.magnitude(0.01, 100);
    const Vector<double> center = random.in_cube(5) * size;
    Model model;
    const Placement placement = random.placement(center, size, 1);
    const NodeIndex root = build(model, placement);
    BuiltFrame<Real> built(model, root);
    const LineSums sums = line_sums(built, center, radius * size, seed);
    CAPTURE(seed, size);
    CHECK(std::fabs(sums.volume - volume * size * size * size) < 4 * sums.volume_error);
    CHECK(std::fabs(sums.area - area * size * size) < 4 * sums.area_error);
  }
}

}  // namespace maquette::firmware::trial
