#include "firmware/primitives/patch_conversion.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "firmware/arithmetic/counted.hpp"
#include "firmware/primitives/patches.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/patch_sets.hpp"

namespace maquette::firmware::patches {
namespace {

using trial::ControlNet;
using trial::ControlNets;
using trial::Random;

/// The uniform cubic B-spline's blending functions (Riesenfeld 1973).
double blend(int k, double u) {
  const double v = 1 - u;
  switch (k) {
    case 0:
      return v * v * v / 6;
    case 1:
      return (3 * u * u * u - 6 * u * u + 4) / 6;
    case 2:
      return (3 * v * v * v - 6 * v * v + 4) / 6;
    default:
      return u * u * u / 6;
  }
}

TEST_CASE("A spline patch is the same patch by its Bezier points") {
  Random random(2301);
  for (int i = 0; i < 200; ++i) {
    const ControlNet spline = trial::random_net(random);
    ControlNet bezier = spline;
    spline_to_bezier(&bezier[0].x);
    for (int n = 0; n < 9; ++n) {
      const double u = random.uniform();
      const double v = random.uniform();
      Vector<double> expected(0, 0, 0);
      for (int k = 0; k < k_net_points; ++k) {
        expected += spline[static_cast<std::size_t>(k)] * (blend(k / 4, u) * blend(k % 4, v));
      }
      REQUIRE(glm::length(trial::point_of(bezier, u, v) - expected) < 1e-15);
    }
  }
}

TEST_CASE("Neighbours in a spline net share their edges to the last bit") {
  Random random(2302);
  std::vector<Vector<double>> control;
  for (int i = 0; i < 25; ++i) {
    control.push_back(random.in_cube());
  }
  const auto patch_at = [&](int row, int column, bool backwards) {
    ControlNet net = trial::net_of([&](int i, int k) {
      return control[static_cast<std::size_t>((row + (backwards ? 3 - i : i)) * 5 + column +
                                              (backwards ? 3 - k : k))];
    });
    spline_to_bezier(&net[0].x);
    return net;
  };
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(patch_at(0, 0, false)[12 + k] == patch_at(1, 0, false)[k]);
    CHECK(patch_at(0, 0, false)[4 * k + 3] == patch_at(0, 1, false)[4 * k]);
    CHECK(patch_at(0, 0, false)[12 + k] == patch_at(1, 0, true)[12 + 3 - k]);
  }
}

std::tuple<double, double, double> key(const double* point) {
  return {point[0], point[1], point[2]};
}

/// Nets of random points, in which patches share some.
std::vector<double> random_given(Random& random, int patches, bool is_spline) {
  const int points = 16 + random.below(100);
  std::vector<double> given = {static_cast<double>(patches), 1, 0, is_spline ? 1.0 : 0.0,
                               static_cast<double>(points)};
  for (int i = 0; i < points * k_point_reals; ++i) {
    given.push_back(random.uniform(-1, 1));
  }
  for (int i = 0; i < patches * k_net_points; ++i) {
    given.push_back(random.below(points));
  }
  return given;
}

TEST_CASE("Each patch is made of the points that it numbers, to the end of what is given") {
  Random random(2305);
  for (int i = 0; i < 100; ++i) {
    const bool is_spline = random.coin();
    const int patches = 1 + random.below(20);
    const std::vector<double> given = random_given(random, patches, is_spline);
    std::vector<double> parameters(static_cast<std::size_t>(parameter_count(patches)));
    REQUIRE(convert(given.data(), parameters.data()) == given.data() + given.size());
    const PatchSet<double> set = patch_set(parameters.data());
    const double* net = given.data() + k_given_header_reals;
    const double* numbers = given.data() + given.size() - patches * k_net_points;
    for (int patch = 0; patch < patches; ++patch) {
      ControlNet expected = trial::net_of([&](int row, int column) {
        const auto number = static_cast<int>(numbers[patch * k_net_points + 4 * row + column]);
        const double* point = net + number * k_point_reals;
        return Vector<double>(point[0], point[1], point[2]);
      });
      if (is_spline) {
        spline_to_bezier(&expected[0].x);
      }
      for (int k = 0; k < k_net_points; ++k) {
        const double* point = set.patch(patch) + k * k_point_reals;
        REQUIRE(Vector<double>(point[0], point[1], point[2]) ==
                expected[static_cast<std::size_t>(k)]);
      }
    }
  }
}

TEST_CASE("Converted in single precision a net is what it is in double within the rounding") {
  Random random(2306);
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> given = random_given(random, 1 + random.below(20), random.coin());
    const auto exact = trial::converted_nets<double>(given);
    const auto single = trial::converted_nets<float>(given);
    for (std::size_t k = 0; k < exact.size(); ++k) {
      REQUIRE(std::fabs(exact[k] - static_cast<double>(single[k])) < 1e-6);
    }
  }
}

TEST_CASE("A conversion is charged, of splines more than of Bezier patches") {
  Random random(2307);
  std::vector<double> given = random_given(random, 5, true);
  const auto work = [&given] {
    reset_counted_work();
    trial::converted_nets<Counted>(given);
    return counted_work();
  };
  const Work spline = work();
  given[k_given_basis] = 0;
  const Work bezier = work();
  CHECK(bezier[Operation::load] >= 2 * 5 * k_patch_stride);
  CHECK(bezier[Operation::multiply] < 100);
  CHECK(spline[Operation::multiply] > 5 * 3 * 8 * 8);
}

/// Checks that a node's box holds its patches, and the same below it.
void check_node(const PatchSet<double>& set, int node, int first, int patches) {
  const double* at = set.boxes + node * k_box_reals;
  for (int i = first * k_net_points; i < (first + patches) * k_net_points; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      REQUIRE(std::fabs(set.points[i * k_point_reals + axis] - at[axis]) <= at[3 + axis] + 1e-15);
    }
  }
  if (patches > 1) {
    const int half = patches / 2;
    check_node(set, node + 1, first, half);
    check_node(set, node + 2 * half, first + half, patches - half);
  }
}

TEST_CASE("The tree holds every patch once, inside the boxes of all its nodes") {
  Random random(2303);
  for (int patches = 1; patches <= k_patch_limit; patches += 1 + patches / 3) {
    ControlNets nets;
    for (int i = 0; i < patches; ++i) {
      nets.push_back(trial::random_net(random));
    }
    const auto parameters = trial::parameters_of<double>(nets, true, SearchMethod::roots);
    const PatchSet<double> set = patch_set(parameters.data());
    REQUIRE(set.patches == patches);
    REQUIRE(set.is_solid);
    REQUIRE(set.method == SearchMethod::roots);
    REQUIRE(set.patch(patches) == parameters.data() + parameters.size());
    check_node(set, 0, 0, patches);
    std::multiset<std::tuple<double, double, double>> given;
    std::multiset<std::tuple<double, double, double>> kept;
    for (int i = 0; i < patches; ++i) {
      given.insert(key(&nets[static_cast<std::size_t>(i)][5].x));
      kept.insert(key(set.patch(i) + 5 * k_point_reals));
    }
    REQUIRE(given == kept);
  }
}

TEST_CASE("A net bisected along u or v is the same patch, its edges the same numbers") {
  Random random(2304);
  for (int i = 0; i < 200; ++i) {
    Net<double> net{};
    for (double& ordinate : net.at) {
      ordinate = random.uniform(-1, 1);
    }
    const bool along_u = random.coin();
    Net<double> upper = net;
    Net<double> lower;
    bisect(upper, lower, along_u);
    for (int k = 0; k < 9; ++k) {
      const double u = random.uniform();
      const double v = random.uniform();
      const double half_u = along_u ? u / 2 : u;
      const double half_v = along_u ? v : v / 2;
      const double low = value_at(lower.at, 1, basis_at(u), basis_at(v));
      const double high = value_at(upper.at, 1, basis_at(u), basis_at(v));
      REQUIRE(low == Approx(value_at(net.at, 1, basis_at(half_u), basis_at(half_v))).margin(1e-15));
      const Jet<double> whole = jet_at(net.at, 1, basis_at(along_u ? 0.5 + half_u : u),
                                       basis_at(along_u ? v : 0.5 + half_v));
      REQUIRE(high == Approx(whole.value).margin(1e-15));
      const Jet<double> part = jet_at(upper.at, 1, basis_at(u), basis_at(v));
      REQUIRE(part.along_u == Approx(whole.along_u * (along_u ? 0.5 : 1)).margin(1e-14));
      REQUIRE(part.along_v == Approx(whole.along_v * (along_u ? 1 : 0.5)).margin(1e-14));
    }
    for (int k = 0; k < 4; ++k) {
      const int step = along_u ? 1 : 4;
      REQUIRE(lower.at[(along_u ? 12 : 3) + k * step] == upper.at[k * step]);
    }
  }
}

}  // namespace
}  // namespace maquette::firmware::patches
