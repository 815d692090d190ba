#pragma once

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "firmware/real_roots.hpp"

/// The table of exact roots that tools/exact_roots.gp makes with PARI/GP.
namespace maquette::firmware::trial {

struct ExactCase {
  std::string family;
  int bits;  ///< of the coefficients, which are exact
  Polynomial<double> polynomial;
  std::vector<long double> roots;  ///< in [0, 1], ascending, multiple ones repeated
};

inline ExactCase exact_case_of(const std::string& line) {
  std::istringstream words(line);
  ExactCase result{};
  words >> result.family >> result.bits >> result.polynomial.degree;
  for (int i = 0; i <= result.polynomial.degree; ++i) {
    double mantissa = 0;
    int exponent = 0;
    words >> mantissa >> exponent;
    result.polynomial.terms[i] = std::ldexp(mantissa, exponent);
  }
  std::size_t count = 0;
  words >> count;
  result.roots.resize(count);
  for (long double& root : result.roots) {
    words >> root;
  }
  if (!words) {
    throw std::runtime_error("exact_roots.txt: a line is not complete: " + line);
  }
  return result;
}

/// The cases whose coefficients a number of so many bits holds.
inline std::vector<ExactCase> exact_cases(const std::string& path, int bits) {
  std::ifstream file(path);
  if (!file) {
    throw std::runtime_error(path + ": can not be read");
  }
  std::vector<ExactCase> cases;
  for (std::string line; std::getline(file, line);) {
    const ExactCase one = exact_case_of(line);
    if (one.bits <= bits) {
      cases.push_back(one);
    }
  }
  return cases;
}

/// Value, derivatives and the sum of the terms' magnitudes at u, in extended precision.
struct Neighbourhood {
  long double value;
  long double slope;
  long double curvature;
  long double magnitude;
};

inline Neighbourhood neighbourhood(const Polynomial<double>& polynomial, long double u) {
  const int n = polynomial.degree;
  const auto power = [](long double base, int exponent) {
    return exponent < 0 ? 0.0L : std::pow(base, static_cast<long double>(exponent));
  };
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

}  // namespace maquette::firmware::trial
