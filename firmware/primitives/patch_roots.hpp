#pragma once

#include "firmware/primitives/patch_cell.hpp"

/// Where both coordinates of a patch's image are zero, by Newton's method in parts of the patch
/// around which the boundary goes once. Parts of the patch are looked at until each is met once at
/// most, by one of the two ways that the paper names.
namespace maquette::firmware::patches {

/// Bisections of a patch, along u and v together: roots that are then still not apart lie deeper in
/// a fold than rounding lets anything be told.
template <class Real>
inline constexpr int k_cell_bisection_limit = std::numeric_limits<Real>::digits + 8;

/// Bisections from which on a cell's image may be a line: before, only that of a patch seen edge-on
/// is.
inline constexpr int k_first_thin_look = 4;

/// Steps of Newton's method before the cell is bisected instead.
inline constexpr int k_newton_limit = 12;

/// Spacings, per unit of the local frame, that an image's coordinates may keep from zero at a root.
inline constexpr double k_root_tolerance = 64;

struct SearchMethod {
  enum Value : std::uint8_t { subdivision, roots };
};

/// Whether a cell is narrowed to where its roots may be before it is halved.
constexpr bool narrows(SearchMethod::Value method) {
  switch (method) {
    case SearchMethod::roots:
      return true;
    case SearchMethod::subdivision:
      break;
  }
  return false;
}

/// A root in the patch, and the sense in which the boundary of its surroundings goes around it, 1
/// or -1: it tells on which side of the patch the ray arrives.
template <class Real>
struct Root {
  Real u;
  Real v;
  int winding;
};

template <class Real>
Real clamped(Real u) {
  return larger(constant<Real>(0), smaller(u, constant<Real>(1)));
}

/// Newton's method from the middle of a cell, inside it. Gives the root by the cell's parameters.
/// Returns false where it does not get there.
template <class Real>
bool approach(const Image<Real>& image, Root<Real>& root) {
  const Real zero = constant<Real>(0);
  root.u = root.v = constant<Real>(0.5);
  Real last_move = zero;
  for (int step = 0; step < k_newton_limit; ++step) {
    const Basis<Real> of_u = basis_at(root.u);
    const Basis<Real> of_v = basis_at(root.v);
    const Jet<Real> x = jet_at(image.x.at, 1, of_u, of_v);
    const Jet<Real> y = jet_at(image.y.at, 1, of_u, of_v);
    const Real determinant = x.along_u * y.along_v - x.along_v * y.along_u;
    if (!(absolute(determinant) > zero)) {
      return false;
    }
    const Real inverse = constant<Real>(1) / determinant;
    const Real target_u = root.u - (x.value * y.along_v - x.along_v * y.value) * inverse;
    const Real target_v = root.v - (x.along_u * y.value - x.value * y.along_u) * inverse;
    const Real next_u = clamped(target_u);
    const Real next_v = clamped(target_v);
    const Real move = larger(absolute(next_u - root.u), absolute(next_v - root.v));
    const Real aside = larger(absolute(next_u - target_u), absolute(next_v - target_v));
    root.u = next_u;
    root.v = next_v;
    // Near the root the next move is to this one as this one's square to that of the last.
    if (move * move * move <= ulps<Real>(1) * last_move * last_move) {
      return !(aside > zero) ||
             larger(absolute(x.value), absolute(y.value)) <= ulps<Real>(k_root_tolerance);
    }
    last_move = move;
  }
  return false;
}

/// The root of a cell around which the boundary goes an odd number of times: by Newton's method,
/// and where that fails in the half that has it. Bisects the cell in place. Apart, to spare the
/// stack of `isolate`.
template <class Real>
Root<Real> root_of(Cell<Real>& cell) {
  Root<Real> root;
  Cell<Real> lower;
  for (;;) {
    if (approach(cell.image, root) || cell.bisections() >= 2 * k_cell_bisection_limit<Real>) {
      root.u = cell.u + root.u * cell.width_u;
      root.v = cell.v + root.v * cell.width_v;
      return root;
    }
    bisect(cell, lower, is_longer_along_u(cell.image));
    if (winding_of(lower) % 2 != 0) {
      cell = lower;
    }
  }
}

/// The part of [0, 1] where a function of u and v may be zero: least and most ordinates of each row
/// of its control net are the ordinates of two curves around it (Sherbrooke and Patrikalakis 1993).
template <class Real>
struct Range {
  Real low;
  Real high;

  [[nodiscard]] bool is_empty() const { return !(low <= high); }
};

/// Narrows the lower end to where the polygon's hull may first reach zero, coming from below when
/// `sign` is 1 and from above when it is -1. `backwards` narrows the upper end.
template <class Real>
Real first_zero(const Real (&ordinates)[4], Real sign, bool backwards) {
  const Real third = constant<Real>(1) / constant<Real>(3);
  const Real zero = constant<Real>(0);
  Real first = constant<Real>(2);
  for (int i = 0; i < 3; ++i) {
    const Real from = ordinates[backwards ? 3 - i : i] * sign;
    if (!(from < zero)) {
      continue;
    }
    for (int k = i + 1; k < 4; ++k) {
      const Real to = ordinates[backwards ? 3 - k : k] * sign;
      if (!(to < zero)) {
        const Real way = from / (from - to);
        first = smaller(first, (from_integer<Real>(i) + from_integer<Real>(k - i) * way) * third);
      }
    }
  }
  return backwards ? constant<Real>(1) - first : first;
}

/// Where along u (`step` 4) or v (`step` 1) the distance of the image from the line through the ray
/// in the direction `across` can be zero.
template <class Real>
Range<Real> range_of(const Image<Real>& image, int step, const Side<Real>& across) {
  const int next = 5 - step;
  const Real zero = constant<Real>(0);
  Real least[4];
  Real most[4];
  const Real margin = size_of(across) * ulps<Real>(k_thin_tolerance);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      const int at = i * step + k * next;
      const Real aside = image.x.at[at] * across.y - image.y.at[at] * across.x;
      least[i] = k == 0 ? aside : smaller(least[i], aside);
      most[i] = k == 0 ? aside : larger(most[i], aside);
    }
    least[i] -= margin;
    most[i] += margin;
  }
  Range<Real> range{zero, constant<Real>(1)};
  const Real one = constant<Real>(1);
  if (most[0] < zero) {
    range.low = first_zero(most, one, false);
  } else if (least[0] > zero) {
    range.low = first_zero(least, -one, false);
  }
  if (most[3] < zero) {
    range.high = first_zero(most, one, true);
  } else if (least[3] > zero) {
    range.high = first_zero(least, -one, true);
  }
  return range;
}

/// Halves the cell along u or v as long as all of the range is in one half.
template <class Real>
void narrow(Cell<Real>& cell, Range<Real> range, bool along_u) {
  constexpr int k_limit = 8;
  const Real half = constant<Real>(0.5);
  Cell<Real> lower;
  for (int i = 0; i < k_limit && (range.high <= half || range.low >= half); ++i) {
    bisect(cell, lower, along_u);
    if (range.high <= half) {
      cell = lower;
    } else {
      range.low -= half;
      range.high -= half;
    }
    range = {range.low + range.low, range.high + range.high};
  }
}

/// The roots of one patch, found so far.
template <class Real>
struct RootList {
  static constexpr int k_limit = 18;  ///< of two bicubics (Kajiya 1982)
  Root<Real> at[k_limit];
  int count;
};

/// Where rounding makes more roots than there can be, two of them are left out.
template <class Real>
void add(RootList<Real>& roots, const Root<Real>& root) {
  if (roots.count < RootList<Real>::k_limit) {
    roots.at[roots.count++] = root;
  } else {
    --roots.count;
  }
}

/// Leaves out of the cell what holds no root of the system. Returns false when nothing is left.
template <class Real>
bool narrow(Cell<Real>& cell, const Side<Real>& along_u, const Side<Real>& along_v) {
  const Range<Real> of_u = range_of(cell.image, 4, along_v);
  const Range<Real> of_v = range_of(cell.image, 1, along_u);
  if (of_u.is_empty() || of_v.is_empty()) {
    return false;
  }
  narrow(cell, of_u, true);
  narrow(cell, of_v, false);
  return true;
}

/// Looks at a cell and narrows it. Returns whether it is to be halved; otherwise its root, if there
/// is one, is added. Apart, so that `isolate` keeps no more than a cell on the stack.
///
/// Method `subdivision`: a part whose control points are all on one side of the ray is left out,
/// the others are halved (Whitted 1980), until the ray meets each part once at most.
///
/// Method `roots`: the two polynomials are solved as a system (Kajiya 1982), which shows where in u
/// and v its roots can be. Kajiya's way to them is one polynomial of degree 18, the resultant; but
/// that is zero everywhere for patches of lower degree in disguise, and in single precision loses
/// what it tells of others. Here the system is isolated in Bernstein form, in both unknowns
/// (Sherbrooke and Patrikalakis 1993): each polynomial is first combined with the other to depend
/// on one unknown as far as possible.
template <class Real>
[[gnu::noinline]] bool is_undecided(Cell<Real>& cell, SearchMethod::Value method,
                                    RootList<Real>& roots) {
  for (;;) {
    charge<Real>(Operation::isolation);
    if (is_passed(cell.image)) {
      return false;
    }
    const Side<Real> along_u = course(cell.image, 4);
    const Side<Real> along_v = course(cell.image, 1);
    const bool is_small = cell.bisections() >= k_first_thin_look;
    if (is_one_to_one(cell.image, along_u, along_v) ||
        (is_small && is_thin(cell.image, along_u, along_v)) ||
        cell.bisections() >= k_cell_bisection_limit<Real>) {
      const int winding = winding_of(cell);
      if (winding % 2 != 0) {
        Root<Real> root = root_of(cell);
        root.winding = winding;
        add(roots, root);
      }
      return false;
    }
    const int bisections = cell.bisections();
    if (narrows(method) && !narrow(cell, along_u, along_v)) {
      return false;
    }
    if (cell.bisections() == bisections) {
      return true;
    }
  }
}

/// Adds the roots in a cell, which is bisected in place.
template <class Real>
void isolate(Cell<Real>& cell, SearchMethod::Value method, RootList<Real>& roots) {
  if (!is_undecided(cell, method, roots)) {
    return;
  }
  Cell<Real> lower;
  bisect(cell, lower, is_longer_along_u(cell.image));
  isolate(lower, method, roots);
  isolate(cell, method, roots);
}

/// The roots of a patch's image, in no order.
template <class Real>
void find_roots(const Image<Real>& image, SearchMethod::Value method, RootList<Real>& roots) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  roots.count = 0;
  Cell<Real> whole{image, zero, zero, one, one, 0, 0};
  isolate(whole, method, roots);
}

}  // namespace maquette::firmware::patches
