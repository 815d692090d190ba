#pragma once

#include <cstdint>
#include <type_traits>

#include "firmware/ray_tree.hpp"

/// How a board's RAM holds what the host loads and what the firmware makes of it: the fields of
/// each structure in the order of their declaration. It is the one description of the layout, from
/// which sizes are told and images are written; the program of a board is compiled against it.
namespace maquette::firmware {

template <class Real, class Visit>
constexpr void for_each_field(const Leaf<Real>& leaf, Visit& visit) {
  visit(leaf.parent);
  visit(leaf.kind);
  visit(leaf.surface);
  visit(leaf.first_parameter);
  visit(leaf.to_scene);
  visit(leaf.from_scene);
}

template <class Visit>
constexpr void for_each_field(const Composite& composite, Visit& visit) {
  visit(composite.parent);
  visit(composite.children);
  visit(composite.combination);
}

template <class Real, class Visit>
constexpr void for_each_field(const Surface<Real>& surface, Visit& visit) {
  visit(surface.diffuse);
  visit(surface.specular);
  visit(surface.metal);
  visit(surface.transparent);
  visit(surface.absorbing);
  visit(surface.facets);
  visit(surface.index);
  visit(surface.extinction);
  visit(surface.facet_parameter);
  visit(surface.facet_scale);
  visit(surface.absorption);
}

template <class Real, class Visit>
constexpr void for_each_field(const Light<Real>& light, Visit& visit) {
  visit(light.position);
  visit(light.intensity);
}

template <class Real, class Visit>
constexpr void for_each_field(const LightShape<Real>& shape, Visit& visit) {
  visit(shape.reference_squared);
  visit(shape.axis);
  visit(shape.edge_cosine);
  visit(shape.per_cosine);
}

template <class Real, class Visit>
constexpr void for_each_field(const Texture<Real>& texture, Visit& visit) {
  visit(texture.from_leaf);
  visit(texture.colors);
  visit(texture.columns_per_turn);
  visit(texture.rows_per_turn);
  visit(texture.first_texel);
  visit(texture.columns);
  visit(texture.rows);
  visit(texture.kind);
}

template <class Real, class Visit>
constexpr void for_each_field(const Samples<Real>& samples, Visit& visit) {
  visit(samples.per_side);
  visit(samples.contrast);
}

template <class Real, class Visit>
constexpr void for_each_field(const Observer<Real>& observer, Visit& visit) {
  visit(observer.to_screen);
  visit(observer.from_screen);
  visit(observer.left);
  visit(observer.top);
  visit(observer.step);
  visit(observer.columns);
  visit(observer.rows);
}

template <class Visit>
constexpr void for_each_field(const Needs& needs, Visit& visit) {
  visit(needs.primitives);
  visit(needs.several_spans);
  visit(needs.unions);
  visit(needs.large_unions);
  visit(needs.intersections);
  visit(needs.differences);
  visit(needs.diffuse);
  visit(needs.specular);
  visit(needs.dielectrics);
  visit(needs.metals);
  visit(needs.facets);
  visit(needs.parallel_view);
  visit(needs.transparency);
  visit(needs.absorption);
  visit(needs.lights);
  visit(needs.shadows);
  visit(needs.ambient);
  visit(needs.reflections);
  visit(needs.depth);
  visit(needs.surface_ambient);
  visit(needs.shaped_lights);
  visit(needs.textures);
  visit(needs.textured);
  visit(needs.samples);
}

template <class Real, class Visit>
constexpr void for_each_field(const Database<Real>& database, Visit& visit) {
  visit(database.leaves);
  visit(database.composites);
  visit(database.parameters);
  visit(database.surfaces);
  visit(database.lights);
  visit(database.surface_ambients);
  visit(database.light_shapes);
  visit(database.leaf_textures);
  visit(database.textures);
  visit(database.texels);
  visit(database.leaf_count);
  visit(database.composite_count);
  visit(database.parameter_count);
  visit(database.surface_count);
  visit(database.light_count);
  visit(database.texture_count);
  visit(database.texel_count);
  visit(database.root);
  visit(database.observer);
  visit(database.ambient);
  visit(database.background);
  visit(database.ray_depth);
  visit(database.minimum_weight);
  visit(database.samples);
  visit(database.needs);
}

template <class Visit>
constexpr void for_each_field(const Rectangle& rectangle, Visit& visit) {
  visit(rectangle.first_column);
  visit(rectangle.end_column);
  visit(rectangle.first_row);
  visit(rectangle.end_row);
}

template <class Real, class Visit>
constexpr void for_each_field(const Box<Real>& box, Visit& visit) {
  visit(box.low);
  visit(box.high);
}

template <class Real, class Visit>
constexpr void for_each_field(const Sphere<Real>& sphere, Visit& visit) {
  visit(sphere.center);
  visit(sphere.radius);
  visit(sphere.radius_squared);
}

template <class Real, class Visit>
constexpr void for_each_field(const Extent<Real>& extent, Visit& visit) {
  visit(extent.box);
  visit(extent.sphere);
  visit(extent.rectangle);
  visit(extent.bounded);
  visit(extent.transparent);
}

template <class Real, class Visit>
constexpr void for_each_field(const PreparedLeaf<Real>& leaf, Visit& visit) {
  visit(leaf.to_screen);
  visit(leaf.from_screen);
  visit(leaf.scale);
}

template <class Real, class Visit>
constexpr void for_each_field(const PreparedSurface<Real>& surface, Visit& visit) {
  visit(surface.diffuse);
  visit(surface.ambient);
}

template <class Real, class Visit>
constexpr void for_each_field(const DepthRange<Real>& range, Visit& visit) {
  visit(range.low);
  visit(range.codes_per_unit);
}

template <class Real, class Visit>
constexpr void for_each_field(const Prepared<Real>& prepared, Visit& visit) {
  visit(prepared.leaves);
  visit(prepared.extents);
  visit(prepared.surfaces);
  visit(prepared.light_positions);
  visit(prepared.light_axes);
  visit(prepared.useful_zone);
  visit(prepared.coarse_tolerance);
  visit(prepared.depths);
}

template <class Real, class Visit>
constexpr void for_each_field(const Frame<Real>& frame, Visit& visit) {
  visit(frame.database);
  visit(frame.prepared);
}

template <class Real, class Visit>
constexpr void for_each_field(const Crossing<Real>& crossing, Visit& visit) {
  visit(crossing.distance);
  visit(crossing.leaf);
  visit(crossing.face);
  visit(crossing.outwards);
  visit(crossing.medium);
}

template <class Real, class Visit>
constexpr void for_each_field(const Ray<Real>& ray, Visit& visit) {
  visit(ray.origin);
  visit(ray.direction);
}

template <class Real, class Visit>
constexpr void for_each_field(const PendingRay<Real>& pending, Visit& visit) {
  visit(pending.ray);
  visit(pending.weight);
  visit(pending.depth);
  visit(pending.medium);
  visit(pending.left_behind);
}

template <class Real, class Visit>
constexpr void for_each_field(const WorkArea<Real>& area, Visit& visit) {
  visit(area.crossings);
  visit(area.rays);
}

/// Tells sizes on a board, where pointers and numbers of the scene are long words: what is larger
/// than a byte lies on an even address, and so does a structure with anything such in it, which
/// also ends on one.
class BoardLayout {
 public:
  static constexpr std::int64_t k_long_bytes = 4;

  template <class Field>
  constexpr void operator()(const Field& field) {
    if constexpr (std::is_integral_v<Field> || std::is_enum_v<Field>) {
      place(sizeof field, sizeof field == 1 ? 1 : 2);
    } else if constexpr (std::is_pointer_v<Field>) {
      place(k_long_bytes, 2);
    } else {
      BoardLayout inner;
      for_each_field(field, inner);
      place(inner.bytes(), inner.alignment());
    }
  }

  template <class Field, std::size_t count>
  constexpr void operator()(const Field (&fields)[count]) {
    for (const Field& field : fields) {
      (*this)(field);
    }
  }

  constexpr void operator()(const float& /*number*/) { place(k_long_bytes, 2); }

  template <class Real>
  constexpr void operator()(const Vector<Real>& /*vector*/) {
    place(3 * k_long_bytes, 2);
  }

  template <class Real>
  constexpr void operator()(const Affine<Real>& /*frame*/) {
    place(12 * k_long_bytes, 2);
  }

  [[nodiscard]] constexpr std::int64_t bytes() const { return aligned(bytes_, alignment_); }
  [[nodiscard]] constexpr std::int64_t alignment() const { return alignment_; }

 private:
  static constexpr std::int64_t aligned(std::int64_t bytes, std::int64_t alignment) {
    return bytes + bytes % alignment;
  }

  constexpr void place(std::int64_t bytes, std::int64_t alignment) {
    bytes_ = aligned(bytes_, alignment) + bytes;
    alignment_ = alignment > alignment_ ? alignment : alignment_;
  }

  std::int64_t bytes_ = 0;
  std::int64_t alignment_ = 1;
};

/// Bytes of a structure in a board's RAM.
template <class Structure>
constexpr std::int64_t board_bytes() {
  BoardLayout layout;
  layout(Structure{});
  return layout.bytes();
}

}  // namespace maquette::firmware
