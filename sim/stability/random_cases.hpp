#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "firmware/vector.hpp"

/// Random cases for measurements and tests, the same on every host: own mapping from integers to
/// numbers.
namespace maquette::sim::trial {

using firmware::Vector;
using Placement = firmware::Affine<double>;

inline Placement scaled(const Vector<double>& s) {
  return {s.x, 0, 0, 0, s.y, 0, 0, 0, s.z, 0, 0, 0};
}

inline Placement unmoved() { return scaled({1, 1, 1}); }

inline Placement moved(const Vector<double>& by) {
  Placement placement = unmoved();
  placement[3] = by;
  return placement;
}

/// A rotation about a unit axis.
inline Placement turned(const Vector<double>& axis, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Placement placement = unmoved();
  for (int column = 0; column < 3; ++column) {
    const Vector<double> v = placement[column];
    placement[column] = v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
  }
  return placement;
}

inline double determinant(const Placement& p) { return glm::dot(p[0], glm::cross(p[1], p[2])); }

inline Placement inverse(const Placement& p) {
  const double d = determinant(p);
  const Vector<double> x = glm::cross(p[1], p[2]) / d;
  const Vector<double> y = glm::cross(p[2], p[0]) / d;
  const Vector<double> z = glm::cross(p[0], p[1]) / d;
  return {x.x,
          y.x,
          z.x,
          x.y,
          y.y,
          z.y,
          x.z,
          y.z,
          z.z,
          -glm::dot(x, p[3]),
          -glm::dot(y, p[3]),
          -glm::dot(z, p[3])};
}

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  /// In [low, high).
  double uniform(double low = 0, double high = 1) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  /// With a uniform logarithm.
  double magnitude(double low, double high) {
    return low * std::exp(uniform() * std::log(high / low));
  }
  /// 0 .. count - 1.
  int below(int count) { return static_cast<int>(uniform(0, count)); }
  bool coin() { return below(2) == 0; }

  Vector<double> in_cube(double half = 1) {
    const double x = uniform(-half, half);
    const double y = uniform(-half, half);
    return {x, y, uniform(-half, half)};
  }
  Vector<double> direction() {
    const double z = uniform(-1, 1);
    const double angle = uniform(0, 2 * std::acos(-1.0));
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  /// Makes the angle of the given cosine with a unit vector.
  Vector<double> direction_around(const Vector<double>& axis, double cosine) {
    const Vector<double> aside = glm::normalize(glm::cross(axis, direction()));
    return glm::normalize(axis * cosine + aside * std::sqrt(1 - cosine * cosine));
  }
  Placement rotation() {
    const Vector<double> axis = direction();
    return turned(axis, uniform(0, 2 * std::acos(-1.0)));
  }
  /// Rotated, of the given size with axes that differ up to the given ratio, somewhere.
  Placement placement(const Vector<double>& center, double size, double ratio) {
    const double x = magnitude(1, ratio);
    const double y = magnitude(1, ratio);
    const Vector<double> axes = Vector<double>(x, y, magnitude(1, ratio)) * (size / ratio);
    return firmware::concatenate(moved(center), firmware::concatenate(rotation(), scaled(axes)));
  }

 private:
  std::mt19937 engine_;
};

}  // namespace maquette::sim::trial
