#include "sim/stability/root_families.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "sim/stability/exact_roots.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

const std::string k_table =
    std::string(MAQUETTE_PROJECT_DIRECTORY) + "/sim/stability/exact_roots.txt";

TEMPLATE_TEST_CASE("No family of polynomials loses, invents or misplaces a root", "", float,
                   double) {
  std::set<std::string> families;
  for (const StabilityRow& row : root_rows<TestType>(k_table)) {
    CAPTURE(row.subject, row.counted, row.value);
    CHECK(row.holds());
    families.insert(row.subject);
  }
  CHECK(families.size() == 16);
}

TEMPLATE_TEST_CASE("A root of an ordinary ray takes three to five steps", "", float, double) {
  const std::set<std::string> ordinary = {"ordinary", "sextic",  "flat_ray",
                                          "grazing",  "cluster", "random"};
  std::size_t found = 0;
  for (const StabilityRow& row : root_rows<TestType>(k_table)) {
    if (row.counted == "iterations per root" && ordinary.count(row.subject) > 0) {
      CAPTURE(row.subject);
      CHECK(row.value > 2);
      CHECK(row.value < 5);
      ++found;
    }
  }
  CHECK(found == ordinary.size());
}

TEST_CASE("At an exact root the value is nothing but rounding") {
  int simple = 0;
  for (const ExactCase& exact : exact_cases(k_table, std::numeric_limits<double>::digits)) {
    for (const long double root : exact.roots) {
      const Neighbourhood at = neighbourhood(exact.polynomial, root);
      const long double ulp = std::numeric_limits<long double>::epsilon();
      const long double uncertain = uncertainty(at, root, ulp);
      if (is_well_conditioned(at, uncertain)) {
        ++simple;
        constexpr long double k_roundings = 64;
        CHECK(std::fabs(at.value) <= k_roundings * uncertain * std::fabs(at.slope));
      }
    }
  }
  CHECK(simple > 1000);
}

TEST_CASE("A table of exact roots that is damaged is refused with its line") {
  const tests::ScratchDirectory directory;
  const std::string file =
      write_file(directory, "roots.txt", "random 24 1 -1 0 1 0 1 0.5\nrandom 24 2 1 0 1\n");
  CHECK_THROWS_WITH(exact_cases(file, 24), Catch::Matchers::ContainsSubstring("roots.txt:2:1: "));
  CHECK_THROWS_AS(exact_cases((directory.path() / "none").string(), 24), DescriptionError);
}

}  // namespace
}  // namespace maquette::sim
