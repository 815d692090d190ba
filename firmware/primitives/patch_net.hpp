#pragma once

#include <cstddef>
#include <limits>

#include "firmware/vector.hpp"

/// Bicubic patches by their Bezier points: P(u, v) for u and v in [0, 1]. Ordinate 4 i + j belongs
/// to the i-th point along u and the j-th along v.
namespace maquette::firmware::patches {

inline constexpr int k_net_points = 16;

/// Reals of a control point, and from one patch to the next.
inline constexpr std::ptrdiff_t k_point_reals = 3;
inline constexpr std::ptrdiff_t k_patch_stride = k_net_points * k_point_reals;

/// One coordinate of a patch.
template <class Real>
struct Net {
  Real at[k_net_points];
};

/// The halves of a curve of four ordinates, `step` apart, over [0, 1/2] and [1/2, 1] (de
/// Casteljau). The upper one takes the place of the curve. A curve read backwards gives the same
/// halves to the last bit.
template <class Real>
void bisect_curve(Real* curve, Real* lower, std::ptrdiff_t step) {
  const Real half = constant<Real>(0.5);
  const Real first = half * (curve[0] + curve[step]);
  const Real middle = half * (curve[step] + curve[2 * step]);
  const Real last = half * (curve[2 * step] + curve[3 * step]);
  const Real low = half * (first + middle);
  const Real high = half * (middle + last);
  const Real joint = half * (low + high);
  lower[0] = curve[0];
  lower[step] = first;
  lower[2 * step] = low;
  lower[3 * step] = joint;
  curve[0] = joint;
  curve[step] = high;
  curve[2 * step] = last;
}

/// The lower half of a net along u or along v; the upper one takes its place.
template <class Real>
void bisect(Net<Real>& net, Net<Real>& lower, bool along_u) {
  const std::ptrdiff_t step = along_u ? 4 : 1;
  const std::ptrdiff_t next = along_u ? 1 : 4;
  for (int i = 0; i < 4; ++i) {
    bisect_curve(net.at + i * next, lower.at + i * next, step);
  }
}

/// Bernstein polynomials of degree 3, and of degree 2 times 3, which make a derivative of
/// differences.
template <class Real>
struct Basis {
  Real cubic[4];
  Real quadratic[3];
};

template <class Real>
Basis<Real> basis_at(Real u) {
  const Real v = constant<Real>(1) - u;
  const Real three = constant<Real>(3);
  const Real three_uu = three * u * u;
  const Real three_vv = three * v * v;
  const Real uv = u * v;
  return {{v * v * v, three_vv * u, three_uu * v, u * u * u},
          {three_vv, (three + three) * uv, three_uu}};
}

/// A coordinate with its derivatives. Exactly zero where control points that fall together make it
/// so.
template <class Real>
struct Jet {
  Real value;
  Real along_u;
  Real along_v;
};

/// Of ordinates that lie `step` reals apart.
template <class Real>
Jet<Real> jet_at(const Real* ordinates, std::ptrdiff_t step, const Basis<Real>& u,
                 const Basis<Real>& v) {
  Real rows[4];
  Jet<Real> jet;
  jet.along_v = constant<Real>(0);
  for (int i = 0; i < 4; ++i) {
    charge<Real>(Operation::load, 4);
    const Real* row = ordinates + 4 * step * i;
    const Real a = row[0];
    const Real b = row[step];
    const Real c = row[2 * step];
    const Real d = row[3 * step];
    rows[i] = v.cubic[0] * a + v.cubic[1] * b + v.cubic[2] * c + v.cubic[3] * d;
    jet.along_v += u.cubic[i] *
                   (v.quadratic[0] * (b - a) + v.quadratic[1] * (c - b) + v.quadratic[2] * (d - c));
  }
  jet.value =
      u.cubic[0] * rows[0] + u.cubic[1] * rows[1] + u.cubic[2] * rows[2] + u.cubic[3] * rows[3];
  jet.along_u = u.quadratic[0] * (rows[1] - rows[0]) + u.quadratic[1] * (rows[2] - rows[1]) +
                u.quadratic[2] * (rows[3] - rows[2]);
  return jet;
}

template <class Real>
Real value_at(const Real* ordinates, std::ptrdiff_t step, const Basis<Real>& u,
              const Basis<Real>& v) {
  Real value = constant<Real>(0);
  for (int i = 0; i < 4; ++i) {
    charge<Real>(Operation::load, 4);
    const Real* row = ordinates + 4 * step * i;
    value += u.cubic[i] * (v.cubic[0] * row[0] + v.cubic[1] * row[step] +
                           v.cubic[2] * row[2 * step] + v.cubic[3] * row[3 * step]);
  }
  return value;
}

/// A patch as a ray sees it: its distances from two planes whose intersection is the ray. Both are
/// zero where the ray meets the patch (Kajiya 1982).
template <class Real>
struct Image {
  Net<Real> x;
  Net<Real> y;
};

template <class Real>
void bisect(Image<Real>& image, Image<Real>& lower, bool along_u) {
  bisect(image.x, lower.x, along_u);
  bisect(image.y, lower.y, along_u);
}

}  // namespace maquette::firmware::patches
