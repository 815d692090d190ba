#include "sim/stability/root_families.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "firmware/polynomials/real_roots.hpp"
#include "sim/stability/exact_roots.hpp"
#include "sim/stability/random_cases.hpp"

namespace maquette::sim {

namespace {

using firmware::Polynomial;
using firmware::RealRoots;

constexpr const char* k_group = "roots";

/// A root may be off by so many times what rounding of the terms by one ulp may move it.
constexpr long double k_allowed_ulps = 2;

/// What is known of a family after all its polynomials.
struct RootTally {
  int roots = 0;
  int missed = 0;    ///< well-conditioned roots without a root found within their conditioning
  int spurious = 0;  ///< roots found where the value is not within rounding
  int parity_errors = 0;
  int steps = 0;
  long double largest_error = 0;  ///< of well-conditioned roots, in ulps times conditioning
};

template <class Real>
Polynomial<Real> as(const Polynomial<double>& polynomial) {
  Polynomial<Real> result;
  result.degree = polynomial.degree;
  for (int i = 0; i <= polynomial.degree; ++i) {
    result.terms[i] = static_cast<Real>(polynomial.terms[i]);
  }
  return result;
}

template <class Real>
long double distance_to_nearest(const RealRoots<Real>& found, long double root) {
  long double distance = 2;  // more than any two roots are apart
  for (int i = 0; i < found.count; ++i) {
    distance = std::fmin(distance, std::fabs(static_cast<long double>(found.at[i]) - root));
  }
  return distance;
}

template <class Real>
void add_case(const ExactCase& exact, RootTally& tally) {
  const auto ulp = static_cast<long double>(std::numeric_limits<Real>::epsilon());
  const RealRoots<Real> found = firmware::roots_of(as<Real>(exact.polynomial));
  const std::vector<long double> expected = expected_roots(exact);
  tally.roots += found.count;
  tally.steps += found.steps;
  tally.parity_errors += (found.count - static_cast<int>(expected.size())) % 2 != 0 ? 1 : 0;
  for (const long double root : expected) {
    const Neighbourhood at = neighbourhood(exact.polynomial, root);
    const long double uncertain = uncertainty(at, root, ulp);
    if (is_well_conditioned(at, uncertain)) {
      const long double error = distance_to_nearest(found, root);
      tally.missed += error > k_allowed_ulps * uncertain ? 1 : 0;
      tally.largest_error = std::fmax(tally.largest_error, uncertain > 0 ? error / uncertain : 0);
    }
  }
  for (int i = 0; i < found.count; ++i) {
    const auto root = static_cast<long double>(found.at[i]);
    const Neighbourhood at = neighbourhood(exact.polynomial, root);
    const long double rounding = ulp * (at.magnitude + std::fabs(at.slope) * root);
    tally.spurious += std::fabs(at.value) > k_allowed_ulps * rounding ? 1 : 0;
  }
}

void add_rows(const std::string& family, const RootTally& tally, std::vector<StabilityRow>& rows) {
  rows.push_back({k_group, family, "well-conditioned roots missed", 1.0 * tally.missed, 0});
  rows.push_back({k_group, family, "spurious roots", 1.0 * tally.spurious, 0});
  rows.push_back({k_group, family, "parity errors", 1.0 * tally.parity_errors, 0});
  rows.push_back({k_group, family, "largest error, in ulps times conditioning",
                  static_cast<double>(tally.largest_error), static_cast<double>(k_allowed_ulps)});
  const double iterations = tally.roots > 0 ? 1.0 * tally.steps / tally.roots : 0;
  rows.push_back({k_group, family, "iterations per root", iterations, {}});
}

/// Whether all roots are in [0, 1] and in order, and no more than there is room for.
template <class Real>
bool is_sound(const RealRoots<Real>& found) {
  Real last = 0;
  for (int i = 0; i < found.count; ++i) {
    if (!(found.at[i] >= last && found.at[i] <= Real{1})) {
      return false;
    }
    last = found.at[i];
  }
  return found.count <= firmware::k_degree_limit;
}

/// Whether the number of roots is odd just where the signs of the ends differ; zero counts as
/// positive.
template <class Real>
bool has_parity(const Polynomial<Real>& polynomial, const RealRoots<Real>& found) {
  const bool changes = (polynomial.terms[0] < 0) != (polynomial.terms[polynomial.degree] < 0);
  return changes == (found.count % 2 != 0);
}

/// Random polynomials of these terms: how many break a law.
template <class Real, std::size_t Count>
void add_extreme_family(const std::string& family, const Real (&terms)[Count], std::uint32_t seed,
                        bool with_parity, std::vector<StabilityRow>& rows) {
  constexpr int k_polynomials = 20000;
  trial::Random random(seed);
  int unsound = 0;
  int parity_errors = 0;
  for (int i = 0; i < k_polynomials; ++i) {
    Polynomial<Real> polynomial{random.below(firmware::k_degree_limit + 1), {}};
    for (int k = 0; k <= polynomial.degree; ++k) {
      polynomial.terms[k] = terms[random.below(Count)];
    }
    const RealRoots<Real> found = firmware::roots_of(polynomial);
    unsound += is_sound(found) ? 0 : 1;
    parity_errors += has_parity(polynomial, found) ? 0 : 1;
  }
  rows.push_back({k_group, family, "roots outside [0, 1] or out of order", 1.0 * unsound, 0});
  if (with_parity) {
    rows.push_back({k_group, family, "parity errors", 1.0 * parity_errors, 0});
  }
}

template <class Real>
void add_extreme_families(std::vector<StabilityRow>& rows) {
  using Limits = std::numeric_limits<Real>;
  const Real tiny = Limits::denorm_min();
  const Real small = Limits::min();
  const Real denormal[] = {0, tiny, -tiny, 3 * tiny, -7 * tiny, small / 2, -small / 4, small};
  const Real not_finite[] = {0,
                             1,
                             -1,
                             Limits::max(),
                             -Limits::max(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             Limits::quiet_NaN()};
  add_extreme_family("denormal", denormal, 1801, true, rows);
  add_extreme_family("not_finite", not_finite, 1802, false, rows);
}

}  // namespace

template <class Real>
std::vector<StabilityRow> root_rows(const std::string& exact_roots_file) {
  std::map<std::string, RootTally> families;
  for (const ExactCase& exact : exact_cases(exact_roots_file, std::numeric_limits<Real>::digits)) {
    add_case<Real>(exact, families[exact.family]);
  }
  std::vector<StabilityRow> rows;
  for (const auto& [family, tally] : families) {
    add_rows(family, tally, rows);
  }
  add_extreme_families<Real>(rows);
  return rows;
}

template std::vector<StabilityRow> root_rows<float>(const std::string& exact_roots_file);
template std::vector<StabilityRow> root_rows<double>(const std::string& exact_roots_file);

}  // namespace maquette::sim
