#include "sim/scene/placement.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sim/fields/field_reader.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/scene/rotation.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

constexpr Range<double> k_any_number{-k_largest_length, k_largest_length};
constexpr std::size_t k_matrix_numbers = 12;

/// Beyond it the firmware's numbers overflow.
constexpr double k_largest_element = 1e30;

bool has_allowed_elements(const Placement& placement) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!(std::fabs(placement[column][row]) <= k_largest_element)) {
        return false;
      }
    }
  }
  return true;
}

Placement read_rotation(const YamlNode& node) {
  Vector3 axis{0, 0, 1};
  double angle = 0;
  FieldReader reader{node, "rotate"};
  reader.field(required("axis", "to turn around"), axis, TripleType{k_any_number});
  reader.field(required("angle", "right-handed around the axis"), angle,
               RealType{RealDimension::angle, {-1e6, 1e6}});
  reader.finish();
  if (axis == Vector3{0, 0, 0}) {
    throw DescriptionError(nearest_node(node, "axis").place.position(),
                           "axis: [0, 0, 0] has no direction");
  }
  return Placement{rotation(axis, angle)};
}

Placement read_scale(const YamlNode& node) {
  const Vector3 scale = TripleType{k_any_number, true}.read(node, "scale");
  if (scale.x == 0 || scale.y == 0 || scale.z == 0) {
    throw DescriptionError(node.place.position(),
                           "scale: 0 flattens the object; numbers other than 0 are allowed");
  }
  return {{scale.x, 0, 0}, {0, scale.y, 0}, {0, 0, scale.z}, {0, 0, 0}};
}

Placement read_translation(const YamlNode& node) {
  Placement result{1.0};
  result[3] = TripleType{k_any_number}.read(node, "translate");
  return result;
}

Placement read_matrix(const YamlNode& node) {
  if (node.kind != YamlKind::sequence || node.items.size() != k_matrix_numbers) {
    throw DescriptionError(node.place.position(),
                           "matrix: a list of twelve numbers is allowed, the rows of a 3x4 matrix");
  }
  constexpr RealType k_element{RealDimension::number, {-k_largest_element, k_largest_element}};
  Placement result{1.0};
  for (std::size_t i = 0; i < k_matrix_numbers; ++i) {
    result[static_cast<int>(i % 4)][static_cast<int>(i / 4)] =
        k_element.read(node.items[i], "matrix");
  }
  if (is_singular(result)) {
    throw DescriptionError(node.place.position(), "matrix: it flattens the object");
  }
  return result;
}

Placement read_step(const YamlNode& node) {
  static const std::vector<std::string_view> steps{"translate", "rotate", "scale", "matrix"};
  check_keys(node, "place", steps);
  if (node.entries.size() != 1) {
    throw DescriptionError(node.place.position(),
                           "place: each step is one of translate, rotate, scale, matrix, as in "
                           "[{scale: 2}, {translate: [0, 0, 1]}]");
  }
  const YamlEntry& step = node.entries.front();
  if (step.key == "translate") {
    return read_translation(step.value);
  }
  if (step.key == "rotate") {
    return read_rotation(step.value);
  }
  return step.key == "scale" ? read_scale(step.value) : read_matrix(step.value);
}

}  // namespace

Placement concatenated(const Placement& outer, const Placement& inner) {
  Placement result;
  for (int column = 0; column < 4; ++column) {
    const Vector3& from = inner[column];
    result[column] = outer[0] * from.x + outer[1] * from.y + outer[2] * from.z;
  }
  result[3] += outer[3];
  return result;
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

bool is_singular(const Placement& placement) {
  constexpr double k_least_volume = 1e-12;
  const double lengths =
      glm::length(placement[0]) * glm::length(placement[1]) * glm::length(placement[2]);
  const double volume = std::fabs(glm::dot(placement[0], glm::cross(placement[1], placement[2])));
  return !has_allowed_elements(placement) || !(volume > k_least_volume * lengths);
}

Placement read_placement(const YamlNode& node) {
  if (node.kind != YamlKind::sequence) {
    check_mapping(node, "place");
    return read_step(node);
  }
  Placement placement{1.0};
  bool first = true;
  for (const YamlNode& step : node.items) {
    check_mapping(step, "place");
    const Placement next = read_step(step);
    placement = first ? next : concatenated(next, placement);
    first = false;
  }
  if (is_singular(placement)) {
    throw DescriptionError(node.place.position(),
                           "place: together the steps flatten the object or blow it up");
  }
  return placement;
}

YamlNode write_placement(const Placement& placement) {
  std::vector<YamlNode> rows;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      rows.push_back(yaml_scalar(format_quantity(placement[column][row], RealDimension::number)));
    }
  }
  YamlNode step = yaml_mapping();
  append(step, "matrix", yaml_sequence(std::move(rows)));
  return step;
}

}  // namespace maquette::sim
