#include "sim/primitives/algebraic.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "firmware/polynomials/bernstein.hpp"
#include "firmware/primitives/algebraic_polynomial.hpp"
#include "firmware/primitives/primitive_table.hpp"
#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"
#include "sim/primitives/root_isolation.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

/// A list of terms, each a list of three exponents and a coefficient.
struct TermListType {
  [[nodiscard]] static std::vector<AlgebraicTerm> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<AlgebraicTerm>& terms);
};

template <class Visitor>
void declare(Visitor& visitor, AlgebraicShape& shape) {
  visitor.field(required("terms",
                         "of the polynomial, [i, j, k, c] for c x^i y^j z^k; the solid is "
                         "where their sum is not above zero"),
                shape.terms, TermListType{});
  visitor.field(required("size", "edge lengths of the box, centred, that cuts the solid off"),
                shape.size, TripleType{{0, k_largest_length, true}, true});
}
namespace {

constexpr int k_degree_limit = firmware::k_degree_limit;
constexpr WholeType k_exponent{WholeDimension::count, {0, k_degree_limit}};
constexpr RealType k_coefficient{RealDimension::number, {-1e30, 1e30}};

[[noreturn]] void fail(const YamlNode& node, std::string_view name, const std::string& message) {
  throw DescriptionError(node.place.position(), std::string{name} + ": " + message);
}

AlgebraicTerm read_term(const YamlNode& node, std::string_view name) {
  if (node.kind != YamlKind::sequence || node.items.size() != 4) {
    fail(node, name,
         node.kind_name() + " stands here; three exponents and a coefficient are allowed");
  }
  AlgebraicTerm term;
  int degree = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    term.exponents[axis] = static_cast<int>(k_exponent.read(node.items[axis], name));
    degree += term.exponents[axis];
  }
  if (degree > k_degree_limit) {
    fail(node, name,
         "a term of degree " + std::to_string(degree) + " stands here; up to " +
             std::to_string(k_degree_limit) + " is allowed");
  }
  term.coefficient = k_coefficient.read(node.items[3], name);
  return term;
}

}  // namespace

std::vector<AlgebraicTerm> TermListType::read(const YamlNode& node, std::string_view name) {
  if (node.kind != YamlKind::sequence) {
    fail(node, name, node.kind_name() + " stands here; a list of terms is allowed");
  }
  std::vector<AlgebraicTerm> terms;
  terms.reserve(node.items.size());
  for (const YamlNode& item : node.items) {
    terms.push_back(read_term(item, name));
  }
  return terms;
}

YamlNode TermListType::write(const std::vector<AlgebraicTerm>& terms) {
  std::vector<YamlNode> items;
  items.reserve(terms.size());
  for (const AlgebraicTerm& term : terms) {
    std::vector<YamlNode> numbers;
    numbers.reserve(4);
    for (const int exponent : term.exponents) {
      numbers.push_back(k_exponent.write(exponent));
    }
    numbers.push_back(k_coefficient.write(term.coefficient));
    items.push_back(yaml_sequence(std::move(numbers)));
  }
  return yaml_sequence(std::move(items));
}

namespace {

/// Throws DescriptionError when the polynomial is constant. `node` is the shape's.
void check_algebraic(const AlgebraicShape& shape, const YamlNode& node) {
  std::map<std::array<int, 3>, double> sums;
  for (const AlgebraicTerm& term : shape.terms) {
    sums[term.exponents] += term.coefficient;
  }
  const bool varies = std::any_of(sums.begin(), sums.end(), [](const auto& sum) {
    return sum.first != std::array<int, 3>{} && sum.second != 0;
  });
  if (!varies) {
    fail(nearest_node(node, "terms"), "terms",
         "the polynomial is constant; a term with an exponent above 0 is needed");
  }
}

constexpr Recursion k_recursions[] = {k_root_isolation};

}  // namespace

LocalFrame frame_of(const AlgebraicShape& shape) {
  const Vector3 half = shape.size / 2.0;
  int degree = 0;
  for (const AlgebraicTerm& term : shape.terms) {
    const auto& [i, j, k] = term.exponents;
    degree = std::max(degree, i + j + k);
  }
  LocalFrame frame;
  frame.kind = firmware::kind_of<firmware::algebraic::Kind>;
  std::vector<double>& parameters = frame.parameters;
  parameters.resize(static_cast<std::size_t>(firmware::algebraic::parameter_count(degree)));
  for (const AlgebraicTerm& term : shape.terms) {
    const auto& [i, j, k] = term.exponents;
    const auto index =
        static_cast<std::size_t>(firmware::algebraic::parameter_index(degree, i, j, k));
    parameters[index] +=
        term.coefficient * std::pow(half.x, i) * std::pow(half.y, j) * std::pow(half.z, k);
  }
  double largest = 0;
  for (const double coefficient : parameters) {
    largest = std::max(largest, std::abs(coefficient));
  }
  for (double& coefficient : parameters) {
    coefficient /= largest;
  }
  parameters[0] = degree;
  frame.to_object = {half.x, 0, 0, 0, half.y, 0, 0, 0, half.z, 0, 0, 0};
  return frame;
}

template <>
const PrimitiveDescription& description_of<firmware::algebraic::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription algebraic = described<AlgebraicShape, check_algebraic>(
        "algebraic",
        "{size: [2, 2, 2], terms: [[2, 0, 0, 1], [0, 2, 0, 1], [0, 0, 2, 1], [0, 0, 0, -1]]}");
    algebraic.recursions = k_recursions;
    return algebraic;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::algebraic::Kind>() {
  return listed_keys<AlgebraicShape>();
}

}  // namespace maquette::sim
