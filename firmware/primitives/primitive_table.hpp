#pragma once

#include "firmware/kind_list.hpp"
#include "firmware/primitives/algebraic.hpp"
#include "firmware/primitives/box.hpp"
#include "firmware/primitives/cone.hpp"
#include "firmware/primitives/cylinder.hpp"
#include "firmware/primitives/half_space.hpp"
#include "firmware/primitives/patches.hpp"
#include "firmware/primitives/prism.hpp"
#include "firmware/primitives/revolution.hpp"
#include "firmware/primitives/shell.hpp"
#include "firmware/primitives/sphere.hpp"
#include "firmware/primitives/terrain.hpp"
#include "firmware/primitives/torus.hpp"

namespace maquette::firmware {

/// The table of primitives: each is one row here, its geometry in the header of its name; what a
/// scene says of it stands in the header and the source of that name in sim/primitives.
using Primitives = KindList<half_space::Kind, box::Kind, sphere::Kind, cylinder::Kind, cone::Kind,
                            revolution::Kind, terrain::Kind, algebraic::Kind, prism::Kind,
                            patches::Kind, torus::Kind, shell::Kind>;

inline constexpr int k_primitive_kind_count = Primitives::k_count;
static_assert(k_primitive_kind_count <= k_primitive_kind_limit);

template <class Real>
struct PrimitiveTable {
  Primitive<Real> rows[k_primitive_kind_count];
};

template <class Real, class... Kinds>
constexpr PrimitiveTable<Real> primitive_table(KindList<Kinds...> /*kinds*/) {
  return {{Kinds::template primitive<Real>()...}};
}

template <class Real>
inline constexpr PrimitiveTable<Real> k_primitives = primitive_table<Real>(Primitives{});

template <class Real>
constexpr const Primitive<Real>& primitive_of(PrimitiveKind kind) {
  return k_primitives<Real>.rows[static_cast<int>(kind)];
}

/// The function that intersects rays with primitives of a kind.
constexpr Function intersection_of(PrimitiveKind kind) {
  return static_cast<Function>(k_fixed_function_count + static_cast<int>(kind));
}

/// The kind of the leaves of a primitive, e.g. kind_of<sphere::Kind>.
template <class Kind>
inline constexpr auto kind_of = static_cast<PrimitiveKind>(PlaceIn<Kind, Primitives>::k_value);

/// Whether the primitives of a kind lie in the unit ball. No table, so that it takes no more code
/// than a comparison with each kind of which that is true.
template <class... Kinds>
[[gnu::always_inline]] constexpr bool fits_unit_ball(PrimitiveKind kind,
                                                     KindList<Kinds...> /*kinds*/) {
  return ((k_fits_unit_ball<Kinds> && kind == kind_of<Kinds>) || ...);
}

}  // namespace maquette::firmware
