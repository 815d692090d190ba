#include "sim/scene/rotation.hpp"

#include <glm/geometric.hpp>

#include <cmath>

#include "firmware/arithmetic/elementary.hpp"

namespace maquette::sim {

SineCosine sine_cosine_deg(double degrees) {
  const double turn = std::fmod(degrees, 360.0);          // exact
  const double quarters = std::floor(turn / 90.0 + 0.5);  // -4 .. 4
  const double radians = (turn - quarters * 90.0) * (firmware::elementary::k_pi / 180.0);
  const double sine = firmware::sine(radians);
  const double cosine = firmware::cosine(radians);
  switch ((static_cast<int>(quarters) + 4) % 4) {
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    case 3:
      return {-cosine, sine};
    default:
      return {sine, cosine};
  }
}

glm::dmat3 rotation(const glm::dvec3& axis, double degrees) {
  // Scaled first, so that the squares of a very short or very long axis are numbers.
  const double largest =
      std::fmax(std::fabs(axis.x), std::fmax(std::fabs(axis.y), std::fabs(axis.z)));
  const glm::dvec3 scaled = axis / largest;
  const glm::dvec3 unit = scaled / std::sqrt(glm::dot(scaled, scaled));
  const auto [sine, cosine] = sine_cosine_deg(degrees);
  const double rest = 1 - cosine;
  const double x = unit.x;
  const double y = unit.y;
  const double z = unit.z;
  return {{cosine + rest * x * x, rest * x * y + sine * z, rest * x * z - sine * y},
          {rest * x * y - sine * z, cosine + rest * y * y, rest * y * z + sine * x},
          {rest * x * z + sine * y, rest * y * z - sine * x, cosine + rest * z * z}};
}

}  // namespace maquette::sim
