#include "sim/database/prism_frame.hpp"

#include "sim/primitives/prism_edges.hpp"

namespace maquette::sim {

LocalFrame prism_frame(const PrismShape& shape) {
  PrismEdges edges = prism_edges(shape);
  const PlaneBox box = box_of(edges);
  const glm::dvec2 half = (box.high - box.low) / 2.0;
  const glm::dvec2 middle = box.low + half;
  for (std::vector<Edge>* list : {&edges.lines, &edges.cubics}) {
    for (Edge& edge : *list) {
      for (glm::dvec2& point : edge.points) {
        point = (point - middle) / half;
      }
    }
  }
  LocalFrame frame;
  frame.kind = firmware::PrimitiveKind::prism;
  frame.parameters = outline_parameters(edges);
  const double half_height = shape.height / 2;
  frame.to_object = {half.x, 0, 0,           0,        half.y,   0,
                     0,      0, half_height, middle.x, middle.y, half_height};
  return frame;
}

}  // namespace maquette::sim
