#pragma once

#include <vector>

#include "firmware/primitives/generatrix_conversion.hpp"

/// Generatrices as boards are given them, and as they convert them.
namespace maquette::firmware::trial {

/// By the control points (r, z) of a uniform cubic B-spline.
inline std::vector<double> given_spline(const std::vector<double>& control, bool is_open) {
  const int points = static_cast<int>(control.size()) / 2;
  std::vector<double> given = {static_cast<double>(section_count(points, is_open)),
                               is_open ? 1.0 : 0.0, 1, 1};
  given.insert(given.end(), control.begin(), control.end());
  return given;
}

/// By the points (r, z) of Bezier sections, three for each and the last.
inline std::vector<double> given_sections(const std::vector<double>& points, bool is_open) {
  const auto sections = static_cast<double>(points.size() / 6);
  std::vector<double> given = {sections, is_open ? 1.0 : 0.0, 1, 0};
  given.insert(given.end(), points.begin(), points.end());
  return given;
}

/// The parameters that a number type makes of them.
template <class Real>
std::vector<Real> converted(const std::vector<double>& given) {
  const std::vector<Real> rounded(given.begin(), given.end());
  std::vector<Real> parameters(
      static_cast<std::size_t>(revolution::parameter_count(static_cast<int>(given[0]))));
  revolution::convert(rounded.data(), parameters.data());
  return parameters;
}

}  // namespace maquette::firmware::trial
