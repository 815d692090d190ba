#pragma once

#include <string>
#include <vector>

#include "firmware/polynomials/bernstein.hpp"

/// The table of exact roots that tools/exact_roots.gp makes with PARI/GP, and how far rounding of
/// the coefficients may move a root.
namespace maquette::sim {

struct ExactCase {
  std::string family;
  int bits;  ///< of the coefficients, which are exact
  firmware::Polynomial<double> polynomial;
  std::vector<long double> roots;  ///< in [0, 1], ascending, multiple ones repeated
};

/// The cases whose coefficients a number of so many bits holds. Throws DescriptionError when the
/// file cannot be read or a line of it is not complete.
[[nodiscard]] std::vector<ExactCase> exact_cases(const std::string& file, int bits);

/// The exact roots that the firmware's convention for ends leaves: an end counts where its
/// neighbourhood is negative.
[[nodiscard]] std::vector<long double> expected_roots(const ExactCase& exact);

/// Value, derivatives and the sum of the terms' magnitudes at u, in extended precision.
struct Neighbourhood {
  long double value;
  long double slope;
  long double curvature;
  long double magnitude;
};

[[nodiscard]] Neighbourhood neighbourhood(const firmware::Polynomial<double>& polynomial,
                                          long double u);

/// How far rounding of the terms by one ulp may move a simple root: the ulp times its
/// conditioning (Farouki and Rajan 1987).
[[nodiscard]] long double uncertainty(const Neighbourhood& at, long double root, long double ulp);

/// Whether the polynomial is nearly straight as far as its root is uncertain, so that rounding can
/// neither take the root away nor join it with another.
[[nodiscard]] bool is_well_conditioned(const Neighbourhood& at, long double uncertain);

}  // namespace maquette::sim
