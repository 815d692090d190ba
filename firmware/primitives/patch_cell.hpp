#pragma once

#include "firmware/primitives/patch_winding.hpp"

/// Parts of a patch's image, and what their control points tell of them.
namespace maquette::firmware::patches {

/// Spacings, per unit of the local frame, within which an image is a line.
inline constexpr double k_thin_tolerance = 32;

/// A part of a patch: [u, u + width_u] x [v, v + width_v].
template <class Real>
struct Cell {
  Image<Real> image;
  Real u;
  Real v;
  Real width_u;
  Real width_v;
  int bisections_u;
  int bisections_v;

  [[nodiscard]] int bisections() const { return bisections_u + bisections_v; }
};

/// Turns of a cell's boundary around the ray.
template <class Real>
int winding_of(const Cell<Real>& cell) {
  return winding_of(cell.image, cell.bisections_u, cell.bisections_v);
}

/// The lower half of a cell along u or v; the upper one takes its place.
template <class Real>
void bisect(Cell<Real>& cell, Cell<Real>& lower, bool along_u) {
  const Real half = constant<Real>(0.5);
  bisect(cell.image, lower.image, along_u);
  lower.u = cell.u;
  lower.v = cell.v;
  if (along_u) {
    cell.width_u *= half;
    cell.u += cell.width_u;
    ++cell.bisections_u;
  } else {
    cell.width_v *= half;
    cell.v += cell.width_v;
    ++cell.bisections_v;
  }
  lower.width_u = cell.width_u;
  lower.width_v = cell.width_v;
  lower.bisections_u = cell.bisections_u;
  lower.bisections_v = cell.bisections_v;
}

/// Whether the ray passes beside all control points of an image.
template <class Real>
bool is_passed(const Image<Real>& image) {
  const Sides x = sides_of(image.x.at, k_net_points);
  if (!x.below || !x.above) {
    return true;
  }
  const Sides y = sides_of(image.y.at, k_net_points);
  return !y.below || !y.above;
}

/// A difference of two points of an image.
template <class Real>
struct Side {
  Real x;
  Real y;
};

template <class Real>
Side<Real> side_of(const Image<Real>& image, int from, int to) {
  return {image.x.at[to] - image.x.at[from], image.y.at[to] - image.y.at[from]};
}

/// Positive when b is on the left of a.
template <class Real>
Real cross(const Side<Real>& a, const Side<Real>& b) {
  return a.x * b.y - a.y * b.x;
}

template <class Real>
Real size_of(const Side<Real>& side) {
  return absolute(side.x) + absolute(side.y);
}

/// How far an image goes along u (`step` 4) or v (`step` 1), all four curves together.
template <class Real>
Side<Real> course(const Image<Real>& image, int step) {
  const int next = 5 - step;
  Side<Real> sum = side_of(image, 0, 3 * step);
  for (int i = 1; i < 4; ++i) {
    const Side<Real> side = side_of(image, i * next, i * next + 3 * step);
    sum = {sum.x + side.x, sum.y + side.y};
  }
  return sum;
}

/// The directions of an image's sides, as an angle less than half a turn.
template <class Real>
struct Fan {
  Side<Real> right;
  Side<Real> left;
};

/// Widens a fan around `course` to all sides along u or v, in the sense of `turn` (1 or -1).
/// `across` is on their left. Returns false when the angle is too large.
template <class Real>
bool spread(const Image<Real>& image, int step, const Side<Real>& across, Real turn,
            Fan<Real>& fan) {
  const Real zero = constant<Real>(0);
  const int next = 5 - step;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      const int at = i * next + k * step;
      const Side<Real> difference = side_of(image, at, at + step);
      const Side<Real> side{difference.x * turn, difference.y * turn};
      if (!(cross(side, across) > zero)) {
        if (size_of(side) > zero) {
          return false;
        }
        continue;  // points that fall together have no direction
      }
      if (cross(fan.right, side) < zero) {
        fan.right = side;
      }
      if (cross(fan.left, side) > zero) {
        fan.left = side;
      }
    }
  }
  return true;
}

/// Whether the image turns the other way at a corner than `turn` (1 or -1) says: most images that
/// are not one to one show it there.
template <class Real>
bool turns_over_at_corner(const Image<Real>& image, Real turn) {
  for (int corner = 0; corner < 4; ++corner) {
    const int at_u = (corner & 1) * 8 + (corner >> 1) * 3;
    const int at_v = (corner & 1) * 12 + (corner >> 1) * 2;
    const Real area = cross(side_of(image, at_u, at_u + 4), side_of(image, at_v, at_v + 1));
    if (area * turn < constant<Real>(0)) {
      return true;
    }
  }
  return false;
}

/// Whether no two points of a cell have the same image, because all sides along u point to one
/// side of all sides along v. The ray then meets the cell once or never.
template <class Real>
bool is_one_to_one(const Image<Real>& image, const Side<Real>& along_u, const Side<Real>& along_v) {
  const Real zero = constant<Real>(0);
  const Real area = cross(along_u, along_v);
  if (!(absolute(area) > zero)) {
    return false;
  }
  const Real turn = area < zero ? constant<Real>(-1) : constant<Real>(1);
  if (turns_over_at_corner(image, turn)) {
    return false;
  }
  const Side<Real> left{along_v.x * turn, along_v.y * turn};
  const Side<Real> back{-along_u.x, -along_u.y};
  Fan<Real> of_u{along_u, along_u};
  Fan<Real> of_v{left, left};
  return spread(image, 4, left, constant<Real>(1), of_u) && spread(image, 1, back, turn, of_v) &&
         cross(of_u.left, of_v.right) > zero && cross(of_u.right, of_v.left) > zero;
}

/// Whether an image is a line or a point within the rounding of its control points.
template <class Real>
bool is_thin(const Image<Real>& image, const Side<Real>& along_u, const Side<Real>& along_v) {
  const Real zero = constant<Real>(0);
  Side<Real> along = size_of(along_u) < size_of(along_v) ? along_v : along_u;
  if (!(size_of(along) > zero)) {
    along = {constant<Real>(1), zero};
  }
  Real least = zero;
  Real most = zero;
  for (int i = 0; i < k_net_points; ++i) {
    const Real aside = along.x * image.y.at[i] - along.y * image.x.at[i];
    least = i == 0 ? aside : smaller(least, aside);
    most = i == 0 ? aside : larger(most, aside);
  }
  return most - least <= size_of(along) * ulps<Real>(k_thin_tolerance);
}

/// Length of the two inner curves of an image along u (`step` 4) or v (`step` 1): also when they
/// return to their start, or when the edges beside them are collapsed.
template <class Real>
Real way_of(const Image<Real>& image, int step) {
  const int next = 5 - step;
  Real sum = constant<Real>(0);
  for (int i = 1; i < 3; ++i) {
    const int first = i * next;
    sum += size_of(side_of(image, first, first + 2 * step)) +
           size_of(side_of(image, first + step, first + 3 * step));
  }
  return sum;
}

template <class Real>
bool is_longer_along_u(const Image<Real>& image) {
  return way_of(image, 4) > way_of(image, 1);
}

}  // namespace maquette::firmware::patches
