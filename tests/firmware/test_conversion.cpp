#include "firmware/conversion.hpp"

#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/generatrices.hpp"

namespace maquette::firmware {
namespace {

const std::vector<double> k_vase =
    trial::given_spline({0.5, -1, 0.8, -0.5, 1, 0, 0.6, 0.5, 0.4, 1}, true);

/// Leaves of a kind, one behind the other, each with so many parameters.
template <class Real>
struct Leaves {
  std::vector<Leaf<Real>> leaves;
  std::vector<Real> given;
  std::vector<Real> parameters;

  void add(PrimitiveKind kind, const std::vector<double>& own_given, std::size_t count) {
    Leaf<Real> leaf{};
    leaf.kind = kind;
    leaf.first_parameter = static_cast<std::uint32_t>(parameters.size());
    leaves.push_back(leaf);
    given.insert(given.end(), own_given.begin(), own_given.end());
    parameters.resize(parameters.size() + count, Real(-77));
  }

  void convert() {
    Database<Real> database{};
    database.leaves = leaves.data();
    database.leaf_count = static_cast<NodeIndex>(leaves.size());
    database.parameter_count = static_cast<std::uint32_t>(parameters.size());
    firmware::convert<Real>(
        database, {given.data(), static_cast<std::uint32_t>(given.size()), parameters.data()});
  }
};

TEST_CASE("Every leaf has its parameters at its place: converted, or as they are given") {
  const std::vector<double> vase = trial::converted<double>(k_vase);
  Leaves<double> leaves;
  leaves.add(kind_of<torus::Kind>, {1, 2, 3}, 3);
  leaves.add(kind_of<revolution::Kind>, k_vase, vase.size());
  leaves.add(kind_of<sphere::Kind>, {}, 0);
  leaves.add(kind_of<revolution::Kind>, k_vase, vase.size());
  leaves.add(kind_of<algebraic::Kind>, {4, 5}, 2);
  leaves.convert();
  std::vector<double> expected = {1, 2, 3};
  expected.insert(expected.end(), vase.begin(), vase.end());
  expected.insert(expected.end(), vase.begin(), vase.end());
  expected.insert(expected.end(), {4, 5});
  CHECK(leaves.parameters == expected);
}

TEST_CASE("Each parameter that is only copied is charged as one word") {
  Leaves<Counted> leaves;
  leaves.add(kind_of<torus::Kind>, {1, 2, 3}, 3);
  reset_counted_work();
  leaves.convert();
  CHECK(counted_work()[Operation::load] == 3);
  CHECK(counted_work()[Operation::add] == 0);
}

}  // namespace
}  // namespace maquette::firmware
