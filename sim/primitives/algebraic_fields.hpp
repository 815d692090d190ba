#pragma once

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/algebraic_shape.hpp"

/// Every parameter of an algebraic surface, declared once.
namespace maquette::sim {

/// A list of terms, each a list of three exponents and a coefficient.
struct TermListType {
  [[nodiscard]] static std::vector<AlgebraicTerm> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<AlgebraicTerm>& terms);
};

template <class Visitor>
void declare_algebraic(Visitor& visitor, AlgebraicShape& shape) {
  visitor.field(required("terms",
                         "of the polynomial, [i, j, k, c] for c x^i y^j z^k; the solid is "
                         "where their sum is not above zero"),
                shape.terms, TermListType{});
  visitor.field(required("size", "edge lengths of the box, centred, that cuts the solid off"),
                shape.size, TripleType{{0, k_largest_length, true}, true});
}

/// Throws DescriptionError when the polynomial is constant. `node` is the shape's.
void check_algebraic(const AlgebraicShape& shape, const YamlNode& node);

}  // namespace maquette::sim
