#include "sim/primitives/generatrix_frame.hpp"

#include <algorithm>

#include "firmware/primitives/generatrix_conversion.hpp"
#include "sim/primitives/generatrix_curve.hpp"

namespace maquette::sim {
namespace {

/// The frame of points (r, z): its unit of r, and the middle and unit of z.
struct ProfileFrame {
  double radius;
  double middle;
  double half_height;
};

ProfileFrame frame_around(const Extent2& extent) {
  const double half_height = (extent.high.y - extent.low.y) / 2;
  return {extent.high.x, extent.low.y + half_height, half_height};
}

/// A unit of at least a length, at most twice as much: `unit` or two of it where that is so.
double unit_for(double length, double unit) {
  constexpr double k_rounding = 1e-12;
  for (const double multiple : {unit, 2 * unit}) {
    if (length <= multiple * (1 + k_rounding) && 2 * length > multiple) {
      return multiple;
    }
  }
  return length;
}

/// That of the points at rest, as long as the displaced ones suit it: then a board is told nothing
/// else anew than the control points that move.
ProfileFrame profile_frame(const RevolutionShape& shape) {
  const Extent2 extent = extent_of(generatrix_curve(shape));
  const ProfileFrame own = frame_around(extent);
  if (shape.displacements.empty()) {
    return own;
  }
  const ProfileFrame rest = frame_around(extent_of(generatrix_curve(shape, shape.points)));
  const double reach = std::max(extent.high.y - rest.middle, rest.middle - extent.low.y);
  const double half_height = unit_for(reach, rest.half_height);
  const double radius = unit_for(own.radius, rest.radius);
  const bool keeps_middle =
      (half_height == rest.half_height || half_height == 2 * rest.half_height) &&
      2 * own.half_height > half_height;
  return keeps_middle ? ProfileFrame{radius, rest.middle, half_height}
                      : ProfileFrame{radius, own.middle, own.half_height};
}

/// What a board is given of a generatrix, of which it converts the control points of B-splines. The
/// host makes sections of what points stand for otherwise.
std::vector<double> given_by(const RevolutionShape& shape, const ProfileFrame& frame) {
  const bool is_spline = shape.curve.value_or(GeneratrixKind::b_spline) == GeneratrixKind::b_spline;
  const GeneratrixCurve curve = generatrix_curve(shape);
  std::vector<double> given = {static_cast<double>(curve.sections()), shape.closed ? 0.0 : 1.0, 1,
                               is_spline ? 1.0 : 0.0};
  for (const glm::dvec2& point : is_spline ? displaced_points(shape) : curve.points) {
    given.insert(given.end(),
                 {point.x / frame.radius, (point.y - frame.middle) / frame.half_height});
  }
  return given;
}

}  // namespace

LocalFrame generatrix_frame(const RevolutionShape& shape, firmware::PrimitiveKind kind) {
  namespace revolution = firmware::revolution;
  const ProfileFrame profile = profile_frame(shape);
  LocalFrame frame;
  frame.kind = kind;
  frame.given = given_by(shape, profile);
  frame.parameters.resize(static_cast<std::size_t>(
      revolution::parameter_count(static_cast<int>(generatrix_curve(shape).sections()))));
  revolution::convert(frame.given.data(), frame.parameters.data());
  frame.to_object = {profile.radius, 0, 0, 0, profile.radius, 0, 0, 0, profile.half_height, 0, 0,
                     profile.middle};
  return frame;
}

}  // namespace maquette::sim
