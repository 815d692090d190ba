#pragma once

#include <any>
#include <stdexcept>
#include <string_view>

#include "sim/fields/field_reader.hpp"
#include "sim/fields/field_writer.hpp"
#include "sim/primitives/board_call.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// Turns about z that map every solid of a primitive onto itself.
enum class OwnTurns { none, quarters, all };

/// All that is known of a primitive besides its geometry, which is the firmware's. A shape is what
/// a scene says of one primitive, a plain struct of a type of its own.
struct PrimitiveDescription {
  std::string_view name;     ///< its key in a scene, and its namespace in the firmware
  std::string_view example;  ///< a shape that is read, as short as may be
  /// Reads and checks a shape; `what` names it in messages. Throws DescriptionError.
  std::any (*read)(const YamlNode& node, std::string_view what);
  /// The shape with every value written.
  YamlNode (*write)(const std::any& shape);
  LocalFrame (*frame)(const std::any& shape);
  /// What speaks against a transparent surface, and what is allowed; empty for a solid.
  std::string_view (*why_opaque)(const std::any& shape);
  OwnTurns own_turns = OwnTurns::none;
  /// Which of its parameters takes the tolerance of the roots that give a ray's hits, in ulps.
  int root_tolerance = k_no_tolerance;
  /// Its functions that call themselves, for the stack.
  RecursionList recursions{};

  static constexpr int k_no_tolerance = -1;
};

/// The description of a primitive of the firmware's table. Each has a specialisation in the source
/// of its name; without it the program does not link.
template <class Kind>
const PrimitiveDescription& description_of();

template <class Shape>
void accept_any(const Shape& /*shape*/, const YamlNode& /*node*/) {}

template <class Shape>
std::string_view is_solid(const Shape& /*shape*/) {
  return {};
}

/// The part of a description that comes with the type of the shape, for which there are
/// `declare(visitor, shape)`, which declares its fields, and `frame_of(shape)`. `check` is told a
/// shape that was read and its node and throws DescriptionError. To be evaluated while compiling.
template <class Shape, void (*check)(const Shape&, const YamlNode&) = accept_any<Shape>,
          std::string_view (*why_opaque)(const Shape&) = is_solid<Shape>>
constexpr PrimitiveDescription described(std::string_view name, std::string_view example) {
  if (!has_namespace(name)) {
    throw std::invalid_argument("the program of a board has no such namespace");
  }
  PrimitiveDescription description{};
  description.name = name;
  description.example = example;
  description.read = [](const YamlNode& node, std::string_view what) {
    Shape shape;
    FieldReader reader{node, what};
    declare(reader, shape);
    reader.finish();
    check(shape, node);
    return std::any{shape};
  };
  description.write = [](const std::any& shape) {
    FieldWriter writer;
    auto written = std::any_cast<Shape>(shape);
    declare(writer, written);
    return writer.take();
  };
  description.frame = [](const std::any& shape) { return frame_of(*std::any_cast<Shape>(&shape)); };
  description.why_opaque = [](const std::any& shape) {
    return why_opaque(*std::any_cast<Shape>(&shape));
  };
  return description;
}

}  // namespace maquette::sim
