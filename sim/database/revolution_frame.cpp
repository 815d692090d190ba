#include "sim/database/revolution_frame.hpp"

#include <algorithm>

#include "firmware/primitives/generatrix.hpp"
#include "sim/primitives/generatrix_curve.hpp"

namespace maquette::sim {

LocalFrame revolution_frame(const RevolutionShape& shape) {
  const GeneratrixCurve curve = generatrix_curve(shape);
  const Extent2 extent = extent_of(curve);
  const double radius = extent.high.x;
  const double half_height = (extent.high.y - extent.low.y) / 2;
  const double middle = extent.low.y + half_height;

  std::vector<glm::dvec2> points = displaced_points(shape);
  if (enclosed_area(curve) < 0) {
    std::reverse(points.begin(), points.end());
  }
  std::vector<double> control;
  for (const glm::dvec2& point : points) {
    control.insert(control.end(), {point.x / radius, (point.y - middle) / half_height});
  }
  LocalFrame frame;
  frame.kind = firmware::PrimitiveKind::revolution;
  frame.parameters.resize(static_cast<std::size_t>(
      firmware::revolution::parameter_count(static_cast<int>(curve.sections()))));
  firmware::revolution::write_parameters(control.data(), static_cast<int>(points.size()),
                                         !shape.closed, frame.parameters.data());
  frame.to_object = {radius, 0, 0, 0, radius, 0, 0, 0, half_height, 0, 0, middle};
  return frame;
}

}  // namespace maquette::sim
