#include "sim/stability/exact_roots.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "firmware/arithmetic/elementary.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

using firmware::Polynomial;

ExactCase exact_case_of(const std::string& line, const SourcePosition& position) {
  std::istringstream words(line);
  ExactCase result{};
  words >> result.family >> result.bits >> result.polynomial.degree;
  for (int i = 0; i <= std::min(result.polynomial.degree, firmware::k_degree_limit); ++i) {
    double mantissa = 0;
    int exponent = 0;
    words >> mantissa >> exponent;
    result.polynomial.terms[i] = std::ldexp(mantissa, exponent);
  }
  std::size_t count = 0;
  words >> count;
  for (std::size_t i = 0; words && i < count; ++i) {
    words >> result.roots.emplace_back();
  }
  if (!words) {
    throw DescriptionError(position,
                           "the line is not complete; family, bits, degree, mantissa and exponent "
                           "of each term, number of roots and the roots are allowed");
  }
  return result;
}

long double power(long double base, int exponent) {
  long double result = exponent < 0 ? 0 : 1;
  for (int i = 0; i < exponent; ++i) {
    result *= base;
  }
  return result;
}

bool is_zero(double term) { return firmware::sign_of(term) == 0; }

}  // namespace

std::vector<ExactCase> exact_cases(const std::string& file, int bits) {
  std::ifstream stream(file);
  if (!stream) {
    throw DescriptionError(file + ": the table of exact roots cannot be read");
  }
  std::vector<ExactCase> cases;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    const ExactCase one = exact_case_of(line, {file, ++number, 1});
    if (one.bits <= bits) {
      cases.push_back(one);
    }
  }
  return cases;
}

std::vector<long double> expected_roots(const ExactCase& exact) {
  const Polynomial<double>& p = exact.polynomial;
  const double* end = p.terms + p.degree + 1;
  const double* first = std::find_if_not(p.terms, end, is_zero);
  if (first == end) {
    return {};
  }
  const double* last = end - 1;
  while (is_zero(*last)) {
    --last;
  }
  std::vector<long double> expected;
  if (first != p.terms && *first < 0) {
    expected.push_back(0);
  }
  for (const long double root : exact.roots) {
    if (root > 0 && root < 1) {
      expected.push_back(root);
    }
  }
  if (last != end - 1 && *last < 0) {
    expected.push_back(1);
  }
  return expected;
}

Neighbourhood neighbourhood(const Polynomial<double>& polynomial, long double u) {
  const int n = polynomial.degree;
  Neighbourhood sum{};
  const long double v = 1 - u;
  for (int i = 0; i <= n; ++i) {
    const auto c = static_cast<long double>(polynomial.terms[i]);
    const int j = n - i;
    const long double term = c * power(u, i) * power(v, j);
    sum.value += term;
    sum.magnitude += std::fabs(term);
    sum.slope += c * (i * power(u, i - 1) * power(v, j) - j * power(u, i) * power(v, j - 1));
    sum.curvature += c * (i * (i - 1) * power(u, i - 2) * power(v, j) -
                          2 * i * j * power(u, i - 1) * power(v, j - 1) +
                          j * (j - 1) * power(u, i) * power(v, j - 2));
  }
  return sum;
}

long double uncertainty(const Neighbourhood& at, long double root, long double ulp) {
  return ulp * (at.magnitude / std::fabs(at.slope) + root);
}

bool is_well_conditioned(const Neighbourhood& at, long double uncertain) {
  constexpr long double k_straight = 0.05L;
  return uncertain * std::fabs(at.curvature) < k_straight * std::fabs(at.slope);
}

}  // namespace maquette::sim
