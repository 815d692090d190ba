#include "sim/database/patches_frame.hpp"

#include <algorithm>

#include "firmware/primitives/patch_set.hpp"
#include "sim/primitives/patch_nets.hpp"

namespace maquette::sim {
namespace {

/// The patches with u and v exchanged: their normals point the other way.
void turn_over(std::vector<PatchNet>& nets) {
  for (PatchNet& net : nets) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        std::swap(net[4 * i + k], net[4 * k + i]);
      }
    }
  }
}

}  // namespace

LocalFrame patches_frame(const PatchesShape& shape) {
  std::vector<PatchNet> nets = patch_nets(shape);
  if (shape.solid && enclosed_volume(nets) < 0) {
    turn_over(nets);
  }
  const Extent3 extent = extent_of(nets);
  const glm::dvec3 middle = (extent.low + extent.high) * 0.5;
  const glm::dvec3 half = (extent.high - extent.low) * 0.5;
  const double size = std::max({half.x, half.y, half.z});
  std::vector<double> points;
  for (const PatchNet& net : nets) {
    for (const glm::dvec3& point : net) {
      const glm::dvec3 local = (point - middle) / size;
      points.insert(points.end(), {local.x, local.y, local.z});
    }
  }
  namespace patches = firmware::patches;
  const int count = static_cast<int>(nets.size());
  LocalFrame frame;
  frame.kind = firmware::PrimitiveKind::patches;
  frame.parameters.resize(static_cast<std::size_t>(patches::parameter_count(count)));
  patches::write_parameters(points.data(), count, shape.solid,
                            shape.method == PatchMethod::roots ? patches::SearchMethod::roots
                                                               : patches::SearchMethod::subdivision,
                            frame.parameters.data());
  frame.to_object = {size, 0, 0, 0, size, 0, 0, 0, size, middle.x, middle.y, middle.z};
  return frame;
}

}  // namespace maquette::sim
