#include "sim/primitives/patch_nets.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "firmware/primitives/patch_conversion.hpp"

namespace maquette::sim {
namespace {

/// The first points of patches along one side of a grid, from row to row or column to column.
struct GridSide {
  int points;
  bool closed;
  int stride;

  /// A Bezier patch ends where its neighbour begins; a spline's patches overlap.
  [[nodiscard]] int patches() const {
    return closed ? points / stride : (stride == 3 ? (points - 1) / 3 : points - 3);
  }
};

std::vector<PatchIndices> grid_indices(const PatchesShape& shape) {
  const PatchGrid& grid = *shape.grid;
  const int stride = meets_at_points(shape.basis) ? 3 : 1;
  const int rows = static_cast<int>(shape.points.size()) / grid.columns;
  const GridSide down{rows, grid.closed_columns, stride};
  const GridSide across{grid.columns, grid.closed_rows, stride};
  std::vector<PatchIndices> patches;
  for (int row = 0; row < down.patches(); ++row) {
    for (int column = 0; column < across.patches(); ++column) {
      PatchIndices& indices = patches.emplace_back();
      for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
          indices.push_back((row * stride + i) % rows * grid.columns +
                            (column * stride + k) % grid.columns);
        }
      }
    }
  }
  return patches;
}

/// Makes points one that lie closer together than rounding moves them.
void weld(std::vector<PatchNet>& nets) {
  constexpr double k_rounding = 1e-13;
  const Extent3 extent = extent_of(nets);
  const glm::dvec3 largest = glm::max(glm::abs(extent.low), glm::abs(extent.high));
  const double tolerance = k_rounding * std::max({largest.x, largest.y, largest.z});
  std::vector<glm::dvec3> kept;
  for (PatchNet& net : nets) {
    for (glm::dvec3& point : net) {
      const auto same = std::find_if(kept.begin(), kept.end(), [&](const glm::dvec3& other) {
        return glm::length(point - other) <= tolerance;
      });
      if (same == kept.end()) {
        kept.push_back(point);
      } else {
        point = *same;
      }
    }
  }
}

using Edge = std::array<glm::dvec3, 4>;

struct EdgeOrder {
  bool operator()(const Edge& a, const Edge& b) const {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto key = [i](const Edge& edge) {
        return std::tuple{edge[i].x, edge[i].y, edge[i].z};
      };
      if (key(a) != key(b)) {
        return key(a) < key(b);
      }
    }
    return false;
  }
};

/// The edges of a patch, one after the other around it.
std::array<Edge, 4> edges_of(const PatchNet& net) {
  return {{{net[0], net[4], net[8], net[12]},
           {net[12], net[13], net[14], net[15]},
           {net[15], net[11], net[7], net[3]},
           {net[3], net[2], net[1], net[0]}}};
}

bool is_point(const Edge& edge) {
  return std::all_of(edge.begin(), edge.end(),
                     [&](const glm::dvec3& point) { return point == edge[0]; });
}

}  // namespace

std::vector<PatchIndices> patch_indices(const PatchesShape& shape) {
  return shape.patches ? *shape.patches : grid_indices(shape);
}

std::vector<PatchNet> patch_nets(const PatchesShape& shape) {
  std::vector<PatchNet> nets;
  for (const PatchIndices& indices : patch_indices(shape)) {
    PatchNet& net = nets.emplace_back();
    std::transform(indices.begin(), indices.end(), net.begin(),
                   [&](int index) { return shape.points[static_cast<std::size_t>(index)]; });
    switch (shape.basis) {
      case PatchBasis::bezier:
        break;
      case PatchBasis::b_spline:
        firmware::patches::spline_to_bezier(&net[0].x);
        break;
    }
  }
  weld(nets);
  return nets;
}

Extent3 extent_of(const std::vector<PatchNet>& nets) {
  Extent3 extent{nets.front()[0], nets.front()[0]};
  for (const PatchNet& net : nets) {
    for (const glm::dvec3& point : net) {
      extent.low = glm::min(extent.low, point);
      extent.high = glm::max(extent.high, point);
    }
  }
  return extent;
}

std::optional<std::size_t> open_patch(const std::vector<PatchNet>& nets) {
  std::map<Edge, int, EdgeOrder> times;
  for (const PatchNet& net : nets) {
    for (const Edge& edge : edges_of(net)) {
      ++times[edge];
    }
  }
  for (std::size_t i = 0; i < nets.size(); ++i) {
    for (const Edge& edge : edges_of(nets[i])) {
      const auto opposite = times.find({edge[3], edge[2], edge[1], edge[0]});
      if (!is_point(edge) &&
          (times[edge] != 1 || opposite == times.end() || opposite->second != 1)) {
        return i;
      }
    }
  }
  return std::nullopt;
}

double enclosed_volume(const std::vector<PatchNet>& nets) {
  // Gauss's rule with five points is exact: P . (dP/du x dP/dv) is of degree 8 in u and in v.
  constexpr double k_nodes[] = {0.046910077030668004, 0.23076534494715845, 0.5, 0.7692346550528415,
                                0.953089922969332};
  constexpr double k_weights[] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                  0.23931433524968324, 0.11846344252809454};
  const glm::dvec3 middle = (extent_of(nets).low + extent_of(nets).high) * 0.5;
  double volume = 0;
  for (const PatchNet& net : nets) {
    for (int i = 0; i < 5; ++i) {
      for (int k = 0; k < 5; ++k) {
        const auto at =
            firmware::patches::patch_point<double>(&net[0].x, k_nodes[i], k_nodes[k], middle);
        volume += k_weights[i] * k_weights[k] / 3 *
                  glm::dot(at.apart, glm::cross(at.along_u, at.along_v));
      }
    }
  }
  return volume;
}

}  // namespace maquette::sim
