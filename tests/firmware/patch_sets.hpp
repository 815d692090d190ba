#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "firmware/primitives/patch_conversion.hpp"
#include "tests/firmware/random_cases.hpp"

/// Sets of patches for tests, with what is known of them from elsewhere.
namespace maquette::firmware::trial {

using patches::SearchMethod;

/// 16 points.
using ControlNet = std::array<Vector<double>, patches::k_net_points>;
using ControlNets = std::vector<ControlNet>;

template <class Real>
using Parameters = std::vector<Real>;

/// As boards are given it: a net that shares no points.
inline std::vector<double> given_nets(const ControlNets& nets, bool is_solid,
                                      SearchMethod::Value method, bool is_spline = false) {
  const auto patches = static_cast<double>(nets.size());
  std::vector<double> given = {patches, is_solid ? 1.0 : 0.0, patches::narrows(method) ? 1.0 : 0.0,
                               is_spline ? 1.0 : 0.0, patches * patches::k_net_points};
  for (const ControlNet& net : nets) {
    for (const Vector<double>& point : net) {
      given.insert(given.end(), {point.x, point.y, point.z});
    }
  }
  for (int i = 0; i < static_cast<int>(nets.size()) * patches::k_net_points; ++i) {
    given.push_back(i);
  }
  return given;
}

/// The parameters that a number type makes of what is given.
template <class Real>
Parameters<Real> converted_nets(const std::vector<double>& given) {
  const std::vector<Real> rounded(given.begin(), given.end());
  Parameters<Real> parameters(
      static_cast<std::size_t>(patches::parameter_count(static_cast<int>(given[0]))));
  patches::convert(rounded.data(), parameters.data());
  return parameters;
}

template <class Real>
Parameters<Real> parameters_of(const ControlNets& nets, bool is_solid, SearchMethod::Value method) {
  return converted_nets<Real>(given_nets(nets, is_solid, method));
}

/// The net whose points a function of their places i, k in 0 .. 3 gives.
template <class Function>
ControlNet net_of(Function point) {
  ControlNet net;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      net[static_cast<std::size_t>(4 * i + k)] = point(i, k);
    }
  }
  return net;
}

inline ControlNet random_net(Random& random) {
  return net_of([&](int /*i*/, int /*k*/) { return random.in_cube(0.9); });
}

/// The six sides of a cube of 4 x 4 x 4 points, each moved by a function of its place, which is the
/// same for all sides that it belongs to. The sides' normals point outwards.
template <class Function>
ControlNets cube_of(Function point) {
  ControlNets nets;
  for (int axis = 0; axis < 3; ++axis) {
    for (int end = 0; end < 4; end += 3) {
      nets.push_back(net_of([&](int i, int k) {
        std::array<int, 3> at{};
        at[static_cast<std::size_t>(axis)] = end;
        at[static_cast<std::size_t>((axis + (end > 0 ? 1 : 2)) % 3)] = i;
        at[static_cast<std::size_t>((axis + (end > 0 ? 2 : 1)) % 3)] = k;
        return point(at);
      }));
    }
  }
  return nets;
}

inline Vector<double> place_in_cube(const std::array<int, 3>& at) {
  return Vector<double>(at[0], at[1], at[2]) * (2.0 / 3) - Vector<double>(1, 1, 1);
}

inline ControlNets flat_cube(double half) {
  return cube_of([&](const std::array<int, 3>& at) { return place_in_cube(at) * half; });
}

/// Roughly a ball, with random dents as deep as `roughness` and edges where the sides meet.
inline ControlNets random_blob(Random& random, double roughness) {
  std::array<double, 64> size{};
  for (double& s : size) {
    s = 0.7 * (1 - roughness * random.uniform());
  }
  return cube_of([&](const std::array<int, 3>& at) {
    const int number = (at[0] * 4 + at[1]) * 4 + at[2];
    return glm::normalize(place_in_cube(at)) * size[static_cast<std::size_t>(number)];
  });
}

/// Spline points, `rows` x `columns`, closed both ways, around a ring: without any edge.
inline ControlNets random_ring(Random& random, int rows, int columns) {
  const double turn = 2 * std::acos(-1.0);
  std::vector<Vector<double>> control;
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const double along = turn * i / rows;
      const double around = turn * k / columns;
      const double thickness = random.uniform(0.15, 0.35);
      const double radius = 0.6 + thickness * std::cos(around);
      control.emplace_back(radius * std::cos(along), radius * std::sin(along),
                           thickness * std::sin(around));
    }
  }
  ControlNets nets;
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const ControlNet spline = net_of([&](int m, int n) {
        return control[static_cast<std::size_t>((i + m) % rows * columns + (k + n) % columns)];
      });
      ControlNet net = spline;
      patches::spline_to_bezier(&net[0].x);
      nets.push_back(net);
    }
  }
  return nets;
}

/// An egg about the z axis of eight patches whose edges at the poles are collapsed.
inline ControlNets egg() {
  const double k = 4.0 / 3 * (std::sqrt(2.0) - 1);
  const double quarter[4][2] = {{1, 0}, {1, k}, {k, 1}, {0, 1}};
  ControlNets nets;
  for (int end = -1; end <= 1; end += 2) {
    const double height = end < 0 ? 0.6 : 0.9;
    for (int turn = 0; turn < 4; ++turn) {
      nets.push_back(net_of([&](int i, int j) {
        const int around = end > 0 ? i : j;
        const int up = end > 0 ? j : i;
        double x = quarter[around][0];
        double y = quarter[around][1];
        for (int t = 0; t < turn; ++t) {
          const double kept = x;
          x = -y;
          y = kept;
        }
        const double radius = 0.7 * quarter[up][0];
        return Vector<double>(radius * x, radius * y, end * height * quarter[up][1]);
      }));
    }
  }
  return nets;
}

inline Vector<double> point_of(const ControlNet& net, double u, double v) {
  return patches::patch_point<double>(&net[0].x, u, v, {0, 0, 0}).apart;
}

/// What lies inside a closed set and how large its boundary is, by Gauss' rule of five points,
/// which is exact for the volume.
struct Measures {
  double volume;
  double area;
};

inline Measures measures_of(const ControlNets& nets) {
  const double inner = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3;
  const double outer = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
  const double inner_weight = (322 + 13 * std::sqrt(70.0)) / 900;
  const double outer_weight = (322 - 13 * std::sqrt(70.0)) / 900;
  const double places[5] = {-outer, -inner, 0, inner, outer};
  const double weights[5] = {outer_weight, inner_weight, 128.0 / 225, inner_weight, outer_weight};
  Measures measures{0, 0};
  for (const ControlNet& net : nets) {
    for (int i = 0; i < 5; ++i) {
      for (int k = 0; k < 5; ++k) {
        const auto at = patches::patch_point<double>(&net[0].x, (places[i] + 1) / 2,
                                                     (places[k] + 1) / 2, {0, 0, 0});
        const Vector<double> element =
            glm::cross(at.along_u, at.along_v) * (weights[i] * weights[k] / 4);
        measures.volume += glm::dot(at.apart, element) / 3;
        measures.area += glm::length(element);
      }
    }
  }
  return measures;
}

}  // namespace maquette::firmware::trial
