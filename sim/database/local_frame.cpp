#include "sim/database/local_frame.hpp"

#include <glm/geometric.hpp>

#include "sim/database/algebraic_frame.hpp"
#include "sim/database/patches_frame.hpp"
#include "sim/database/prism_frame.hpp"
#include "sim/database/revolution_frame.hpp"
#include "sim/database/terrain_frame.hpp"

namespace maquette::sim {

namespace {

Placement scaled_and_moved(const Vector3& scale, double height) {
  return {scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z, 0, 0, height};
}

LocalFrame cylinder_frame(double radius, double height) {
  return {firmware::PrimitiveKind::cylinder,
          {},
          scaled_and_moved({radius, radius, height / 2}, height / 2)};
}

/// The canonical cone has its apex at the origin and its base, of radius 1, at z = 1.
LocalFrame cone_frame(const Object& cone) {
  const double wide = std::max(cone.radius, cone.top_radius);
  const double narrow = std::min(cone.radius, cone.top_radius);
  if (wide == narrow) {
    return cylinder_frame(wide, cone.height);
  }
  const double ratio = narrow / wide;
  const double apex_height = cone.height / (1 - ratio);
  const bool stands_on_base = cone.radius > cone.top_radius;
  const Placement frame =
      stands_on_base ? scaled_and_moved({wide, wide, -apex_height}, apex_height)
                     : scaled_and_moved({wide, wide, apex_height}, cone.height - apex_height);
  return {firmware::PrimitiveKind::cone, {ratio}, frame};
}

}  // namespace

LocalFrame local_frame_of(const Object& primitive) {
  switch (primitive.kind) {
    case ObjectKind::box:
      return {firmware::PrimitiveKind::box, {}, scaled_and_moved(primitive.size / 2.0, 0)};
    case ObjectKind::sphere:
      return {firmware::PrimitiveKind::sphere, {}, scaled_and_moved(primitive.size, 0)};
    case ObjectKind::cylinder:
      return cylinder_frame(primitive.radius, primitive.height);
    case ObjectKind::cone:
      return cone_frame(primitive);
    case ObjectKind::revolution:
      return revolution_frame(std::get<RevolutionShape>(primitive.shape));
    case ObjectKind::terrain:
      return terrain_frame(std::get<TerrainShape>(primitive.shape));
    case ObjectKind::algebraic:
      return algebraic_frame(std::get<AlgebraicShape>(primitive.shape));
    case ObjectKind::prism:
      return prism_frame(std::get<PrismShape>(primitive.shape));
    case ObjectKind::patches:
      return patches_frame(std::get<PatchesShape>(primitive.shape));
    case ObjectKind::half_space:
    case ObjectKind::union_of:
    case ObjectKind::intersection:
    case ObjectKind::difference:
      break;
  }
  return {firmware::PrimitiveKind::half_space, {}, Placement(1.0)};
}

Placement inverse_of(const Placement& placement) {
  const Vector3& x = placement[0];
  const Vector3& y = placement[1];
  const Vector3& z = placement[2];
  const double determinant = glm::dot(x, glm::cross(y, z));
  const Vector3 row_x = glm::cross(y, z) / determinant;
  const Vector3 row_y = glm::cross(z, x) / determinant;
  const Vector3 row_z = glm::cross(x, y) / determinant;
  const Vector3 origin(-glm::dot(row_x, placement[3]), -glm::dot(row_y, placement[3]),
                       -glm::dot(row_z, placement[3]));
  return {row_x.x, row_y.x, row_z.x, row_x.y,  row_y.y,  row_z.y,
          row_x.z, row_y.z, row_z.z, origin.x, origin.y, origin.z};
}

}  // namespace maquette::sim
