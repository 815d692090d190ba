#pragma once

#include "firmware/primitives/prism.hpp"

/// What the edges of a prism's outline tell of its other parameters.
namespace maquette::firmware::prism {

/// Extents of the tree's nodes, each node before its children.
template <class Real>
void write_extents(const Outline<Real>& curve, int first, int edges, Real* extents) {
  Real* own = extents;
  own[0] = own[1] = curve.edge(first)[0];
  own[2] = own[3] = curve.edge(first)[1];
  for (int edge = first; edge < first + edges; ++edge) {
    const Real* points = curve.edge(edge);
    const int count = curve.is_line(edge) ? 2 : 4;
    for (int i = 0; i < count; ++i) {
      charge<Real>(Operation::load, 2);
      own[0] = smaller(own[0], points[i * k_point_reals]);
      own[1] = larger(own[1], points[i * k_point_reals]);
      own[2] = smaller(own[2], points[i * k_point_reals + 1]);
      own[3] = larger(own[3], points[i * k_point_reals + 1]);
    }
  }
  if (edges > 1) {
    const int half = edges / 2;
    write_extents(curve, first, half, extents + k_extent_reals);
    write_extents(curve, first + half, edges - half, extents + half * (2 * k_extent_reals));
  }
}

/// Whether the solid lies on the right of an edge's middle: by the crossings before it of the line
/// that leaves it to the right.
template <class Real>
bool has_solid_on_right(const Outline<Real>& curve, int edge) {
  const Real half = constant<Real>(0.5);
  const Real* points = curve.edge(edge);
  CurvePoint<Real> middle{half * (points[0] + points[2]), half * (points[1] + points[3]),
                          points[2] - points[0], points[3] - points[1]};
  if (!curve.is_line(edge)) {
    middle = curve_point(points, half);
  }
  const PlaneRay<Real> ray = plane_ray(middle.x, middle.y, middle.change_y, -middle.change_x);
  Hit<Real> hits[k_crossing_limit];
  const int count = cross_outline(ray, curve, hits);
  sort(hits, count);
  int own = -1;
  for (int i = 0; i < count; ++i) {
    if (hits[i].face == edge &&
        (own < 0 || absolute(hits[i].distance) < absolute(hits[own].distance))) {
      own = i;
    }
  }
  return own >= 0 && own % 2 == 0;
}

/// Completes parameters of which the two numbers of edges and the edges' points are given, these in
/// either direction: writes the extents and turns the edges so that they have the solid on their
/// left.
template <class Real>
void complete_parameters(Real* parameters) {
  const Outline<Real> curve = outline(parameters);
  write_extents(curve, 0, curve.edges(), parameters + k_header_reals);
  for (int edge = 0; edge < curve.edges(); ++edge) {
    if (!has_solid_on_right(curve, edge)) {
      continue;
    }
    Real* points = parameters + (curve.edge(edge) - parameters);
    const int last = curve.is_line(edge) ? 1 : 3;
    for (int i = 0; i < last - i; ++i) {
      for (int k = 0; k < k_point_reals; ++k) {
        Real& low = points[i * k_point_reals + k];
        Real& high = points[(last - i) * k_point_reals + k];
        const Real kept = low;
        low = high;
        high = kept;
      }
    }
  }
}

}  // namespace maquette::firmware::prism
