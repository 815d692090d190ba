#include "firmware/primitives/terrain_parameters.hpp"

#include <cmath>
#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::terrain {
namespace {

using trial::Random;

std::vector<double> random_given(Random& random) {
  const int levels = random.below(k_level_limit + 1);
  return {static_cast<double>(levels), static_cast<double>(random.below(k_seed_end)),
          random.uniform(-1, 0),       random.uniform(-1, 1),
          random.uniform(-1, 1),       random.uniform(-1, 1),
          random.uniform(-1, 1),       random.magnitude(1e-6, 1),
          random.uniform(0, 1)};
}

template <class Real>
std::vector<Real> converted(const std::vector<double>& given) {
  const std::vector<Real> rounded(given.begin(), given.end());
  std::vector<Real> parameters(
      static_cast<std::size_t>(parameter_count(static_cast<std::int32_t>(given[0]))));
  REQUIRE(convert(rounded.data(), parameters.data()) == rounded.data() + rounded.size());
  return parameters;
}

TEMPLATE_TEST_CASE("Levels and top stay bounds in the precision that makes them", "", float,
                   double) {
  Random random(5301);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<double> given = random_given(random);
    const std::vector<TestType> parameters = converted<TestType>(given);
    const auto levels = static_cast<std::size_t>(given[0]);
    double sum = 0;
    for (std::size_t level = levels; level > 0; --level) {
      const std::size_t at = static_cast<std::size_t>(k_header_reals) + 2 * (level - 1);
      sum += static_cast<double>(parameters[at]);
      CAPTURE(i, level);
      REQUIRE(static_cast<double>(parameters[at + 1]) >= sum);
      REQUIRE(static_cast<double>(parameters[at + 1]) == Approx(sum).epsilon(1e-5));
      REQUIRE(static_cast<double>(parameters[at]) ==
              Approx(given[7] * std::pow(given[8], static_cast<double>(level - 1)))
                  .epsilon(1e-5)
                  .margin(1e-30));
    }
    for (std::size_t corner = 4; corner < 8; ++corner) {
      REQUIRE(static_cast<double>(parameters[3]) >= static_cast<double>(parameters[corner]) + sum);
    }
  }
}

TEST_CASE("A terrain is what is given of it, but for its levels") {
  Random random(5302);
  const std::vector<double> given = random_given(random);
  const std::vector<double> parameters = converted<double>(given);
  CHECK(parameters[0] == given[0]);
  CHECK(parameters[1] == given[1]);
  CHECK(parameters[2] == given[2]);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    CHECK(parameters[4 + corner] == given[3 + corner]);
  }
}

TEST_CASE("The conversion of a terrain is charged by its levels") {
  const auto work = [](double levels) {
    const std::vector<Counted> given = {
        constant<Counted>(levels), constant<Counted>(1),   constant<Counted>(-1),
        constant<Counted>(0),      constant<Counted>(0),   constant<Counted>(0),
        constant<Counted>(0),      constant<Counted>(0.5), constant<Counted>(0.5)};
    std::vector<Counted> parameters(
        static_cast<std::size_t>(parameter_count(static_cast<std::int32_t>(levels))));
    reset_counted_work();
    convert(given.data(), parameters.data());
    return counted_work();
  };
  CHECK(work(0)[Operation::load] == k_given_reals);
  CHECK(work(8)[Operation::multiply] > work(4)[Operation::multiply]);
}

}  // namespace
}  // namespace maquette::firmware::terrain
