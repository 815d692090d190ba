#pragma once

#include <cstdint>

#include "firmware/database.hpp"
#include "firmware/primitives/conversion_table.hpp"

/// The part of preprocessing that comes first, in scenes with a primitive that has a conversion:
/// the host loads what the scene gives of the primitives, and each board makes their parameters of
/// it in its own RAM (paper, section IV.2.1: control points of B-splines to those of Bezier
/// sections).
namespace maquette::firmware {

template <class Real>
struct Conversion {
  const Real* given;  ///< of all leaves, in their order
  std::uint32_t given_count;
  Real* parameters;  ///< what Database::parameters points to
};

template <class Real, class Visit>
constexpr void for_each_field(const Conversion<Real>& conversion, Visit& visit) {
  visit(conversion.given);
  visit(conversion.given_count);
  visit(conversion.parameters);
}

/// Where the parameters of the leaf behind a node begin.
template <class Real>
std::uint32_t parameters_end(const Database<Real>& database, NodeIndex node) {
  return node + 1 == database.leaf_count ? database.parameter_count
                                         : database.leaves[node + 1].first_parameter;
}

/// Copies the parameters of a leaf; returns the end of what is given.
template <class Real>
const Real* copied(const Real* given, Real* parameters, const Real* end) {
  while (parameters != end) {
    charge<Real>(Operation::load);
    *parameters++ = *given++;
  }
  return given;
}

/// Fills the parameters of all leaves, of which each has its place.
template <class Real>
void convert(const Database<Real>& database, const Conversion<Real>& conversion) {
  const InFunction<Real> here(Function::preparation);
  const Real* given = conversion.given;
  for (NodeIndex node = 0; node < database.leaf_count; ++node) {
    const Leaf<Real>& leaf = database.leaves[node];
    Real* parameters = conversion.parameters + leaf.first_parameter;
    const Convert<Real> convert_leaf = conversion_of<Real>(leaf.kind);
    given = convert_leaf != nullptr
                ? convert_leaf(given, parameters)
                : copied(given, parameters, conversion.parameters + parameters_end(database, node));
  }
}

}  // namespace maquette::firmware
