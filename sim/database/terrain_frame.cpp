#include "sim/database/terrain_frame.hpp"

#include <algorithm>
#include <cmath>

#include "sim/primitives/terrain_fields.hpp"

namespace maquette::sim {

LocalFrame terrain_frame(const TerrainShape& shape) {
  firmware::terrain::Shape<double> scaled = relief_of(shape);
  const double height = std::max(std::fabs(firmware::terrain::top_of(scaled)), shape.depth);
  scaled.floor /= height;
  scaled.displacement /= height;
  for (double& corner : scaled.corners) {
    corner /= height;
  }
  LocalFrame frame;
  frame.kind = firmware::PrimitiveKind::terrain;
  frame.parameters.resize(
      static_cast<std::size_t>(firmware::terrain::parameter_count(shape.levels)));
  firmware::terrain::write_parameters(scaled, frame.parameters.data());
  const double middle = -shape.size / 2;
  frame.to_object = {shape.size, 0, 0, 0, shape.size, 0, 0, 0, height, middle, middle, 0};
  return frame;
}

}  // namespace maquette::sim
