#pragma once

#include <type_traits>

#include "firmware/primitives/primitive_table.hpp"

namespace maquette::firmware {

/// Makes the parameters of a primitive, which rays are intersected with, of what a scene gives.
/// Returns the end of what is given.
template <class Real>
using Convert = const Real* (*)(const Real* given, Real* parameters);

/// Of a primitive whose parameters are given as they are.
template <class Real, class Kind, class = void>
inline constexpr Convert<Real> k_convert_of_kind = nullptr;

/// A primitive that has one says so in its row of the table of primitives.
template <class Real, class Kind>
inline constexpr Convert<Real>
    k_convert_of_kind<Real, Kind, std::void_t<decltype(Kind::template k_convert<Real>)>> =
        Kind::template k_convert<Real>;

template <class Real>
struct ConversionTable {
  Convert<Real> rows[k_primitive_kind_count];
};

template <class Real, class... Kinds>
constexpr ConversionTable<Real> conversion_table(KindList<Kinds...> /*kinds*/) {
  return {{k_convert_of_kind<Real, Kinds>...}};
}

/// Apart from the table of primitives, so that scenes in which nothing is converted spare it.
template <class Real>
inline constexpr ConversionTable<Real> k_conversions = conversion_table<Real>(Primitives{});

/// The conversion of a kind; null where the primitive has none.
template <class Real>
constexpr Convert<Real> conversion_of(PrimitiveKind kind) {
  return k_conversions<Real>.rows[static_cast<int>(kind)];
}

}  // namespace maquette::firmware
