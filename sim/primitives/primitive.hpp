#pragma once

#include <any>
#include <utility>

#include "sim/primitives/primitive_description.hpp"

namespace maquette::sim {

/// A primitive of a scene: a shape and what is known of its kind.
struct Primitive {
  const PrimitiveDescription* description;
  std::any shape;
};

/// The primitive of a shape, e.g. SphereShape.
template <class Shape>
Primitive primitive_of(Shape shape) {
  return {&description_of<typename Shape::Kind>(), std::move(shape)};
}

/// The shape of a primitive if it is of that type, else a null pointer.
template <class Shape>
const Shape* shape_of(const Primitive& primitive) {
  return std::any_cast<Shape>(&primitive.shape);
}

/// The firmware's form of a primitive.
inline LocalFrame frame_of(const Primitive& primitive) {
  return primitive.description->frame(primitive.shape);
}

}  // namespace maquette::sim
