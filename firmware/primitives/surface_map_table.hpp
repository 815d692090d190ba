#pragma once

#include "firmware/primitives/primitive_table.hpp"
#include "firmware/primitives/surface_map.hpp"

namespace maquette::firmware {

/// The map of a primitive that has none.
template <class Real, class Kind, class = void>
inline constexpr SurfaceMap<Real> k_map_of_kind = nullptr;

/// A primitive that has one says so in its row of the table of primitives.
template <class Real, class Kind>
inline constexpr SurfaceMap<Real>
    k_map_of_kind<Real, Kind, std::void_t<decltype(Kind::template k_surface_map<Real>)>> =
        Kind::template k_surface_map<Real>;

template <class Real>
struct SurfaceMapTable {
  SurfaceMap<Real> rows[k_primitive_kind_count];
};

template <class Real, class... Kinds>
constexpr SurfaceMapTable<Real> surface_map_table(KindList<Kinds...> /*kinds*/) {
  return {{k_map_of_kind<Real, Kinds>...}};
}

/// Apart from the table of primitives, so that scenes without pictures spare it.
template <class Real>
inline constexpr SurfaceMapTable<Real> k_surface_maps = surface_map_table<Real>(Primitives{});

/// The map of a kind; null where the primitive has none.
template <class Real>
constexpr SurfaceMap<Real> surface_map_of(PrimitiveKind kind) {
  return k_surface_maps<Real>.rows[static_cast<int>(kind)];
}

}  // namespace maquette::firmware
