#include "sim/stability/stability_checks.hpp"

#include <set>

#include "firmware/primitives/primitive_table.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/scratch_directory.hpp"

namespace maquette::sim {
namespace {

const std::string k_project = MAQUETTE_PROJECT_DIRECTORY;

const StabilityMaterial& material() {
  static const StabilityMaterial shipped =
      stability_material(k_project + "/scenes", k_project + "/sim/stability/exact_roots.txt");
  return shipped;
}

template <class Real>
void check_bounds(const std::string& group, double share) {
  int bounds = 0;
  for (const StabilityCheck& check : stability_checks<Real>(material(), share)) {
    if (check.group != group) {
      continue;
    }
    for (const StabilityRow& row : check.measure()) {
      CAPTURE(row.group, row.subject, row.counted, row.value);
      CHECK(row.group == group);
      CHECK(row.holds());
      bounds += row.bound ? 1 : 0;
    }
  }
  CHECK(bounds > 0);
}

TEMPLATE_TEST_CASE("Pictures do not depend on the scale of the scene", "", float, double) {
  check_bounds<TestType>("scale", 0.05);
}

TEMPLATE_TEST_CASE("Secondary rays neither meet what they leave nor fall out", "", float, double) {
  check_bounds<TestType>("secondary_rays", 0.02);
}

TEMPLATE_TEST_CASE("Solids keep in and out apart on every ray", "", float, double) {
  check_bounds<TestType>("csg", 0.01);
}

TEST_CASE("Creases show no light that is nowhere near in the exact picture") {
  check_bounds<float>("light", 0.05);
}

TEMPLATE_TEST_CASE("Extreme inputs give pictures or are refused", "", float, double) {
  check_bounds<TestType>("extreme", 0.02);
}

TEST_CASE("Every group has checks, and every check belongs to a group") {
  std::set<std::string> groups;
  for (const StabilityCheck& check : stability_checks<float>(material(), 1)) {
    groups.insert(check.group);
  }
  CHECK(groups == std::set<std::string>(stability_groups().begin(), stability_groups().end()));
}

TEST_CASE("Every primitive that makes solids is tried") {
  constexpr std::size_t k_without_thickness = 1;  // shells
  CHECK(material().families.size() == firmware::k_primitive_kind_count - k_without_thickness);
}

TEST_CASE("A row holds up to its bound, and never by a value that is no number") {
  StabilityRow row{"roots", "ordinary", "parity errors", 1, 0};
  CHECK_FALSE(row.holds());
  row.value = 0;
  CHECK(row.holds());
  row.value = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(row.holds());
  row.bound.reset();
  CHECK(row.holds());
}

TEST_CASE("A directory without scenes is refused") {
  const tests::ScratchDirectory directory;
  CHECK_THROWS_AS(shipped_scenes(directory.path().string()), DescriptionError);
  CHECK_THROWS_AS(shipped_scenes((directory.path() / "none").string()), DescriptionError);
}

}  // namespace
}  // namespace maquette::sim
