#include "sim/primitives/algebraic_fields.hpp"

#include <algorithm>
#include <map>

#include "firmware/polynomials/bernstein.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
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

}  // namespace maquette::sim
