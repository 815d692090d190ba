#include "firmware/primitives/patch_roots.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

#include "tests/catch.hpp"
#include "tests/firmware/patch_rays.hpp"

namespace maquette::firmware::patches {
namespace {

/// A patch in a plane whose points lie where those of a bilinear one would.
ControlNet parallelogram(const Vector<double>& corner, const Vector<double>& u,
                         const Vector<double>& v) {
  return trial::net_of([&](int i, int k) { return corner + u * (i / 3.0) + v * (k / 3.0); });
}

TEMPLATE_TEST_CASE("A flat patch is met where its plane is", "", float, double) {
  using Real = TestType;
  Random random(2202);
  const double rounding = static_cast<double>(ulps<Real>(1));
  int met = 0;
  for (int i = 0; i < 6000; ++i) {
    const Vector<double> corner = random.in_cube(0.3);
    const Vector<double> along_u = random.in_cube(0.4);
    const Vector<double> along_v = random.in_cube(0.4);
    const Ray<double> ray = ray_towards(
        random, corner + along_u * random.uniform(-1, 2) + along_v * random.uniform(-1, 2), 4);
    const double volume = glm::dot(ray.direction, glm::cross(along_u, along_v));
    const double flatness = std::fabs(volume) / glm::length(ray.direction);
    if (flatness < 1e-3) {
      continue;
    }
    const Vector<double> apart = ray.origin - corner;
    const double u = glm::dot(ray.direction, glm::cross(apart, along_v)) / volume;
    const double v = glm::dot(ray.direction, glm::cross(along_u, apart)) / volume;
    const double distance = -glm::dot(apart, glm::cross(along_u, along_v)) / volume;
    const double margin = 100 * rounding / flatness;
    const double inside = std::fmin(std::fmin(u, 1 - u), std::fmin(v, 1 - v));
    const auto parameters = trial::parameters_of<Real>({parallelogram(corner, along_u, along_v)},
                                                       false, k_methods[i % 2]);
    const Hits<Real> found = hits_on(parameters, ray);
    CAPTURE(i, u, v, flatness);
    if (inside < -margin) {
      REQUIRE(found.count == 0);
    } else if (inside > margin) {
      ++met;
      REQUIRE(found.count == 2);
      const double apart_on_ray = static_cast<double>(found.hits[0].distance) - distance;
      REQUIRE(std::fabs(apart_on_ray) * glm::length(ray.direction) < margin);
      REQUIRE(found.hits[1].distance == found.hits[0].distance);
      REQUIRE((found.hits[0].face >= k_from_behind) == (volume > 0));
    }
  }
  CHECK(met > 300);
}

/// z = a x^2 + b y^2 + c for x and y in [-0.9, 0.9].
ControlNet paraboloid(double a, double b, double c) {
  const double at[4] = {-0.9, -0.3, 0.3, 0.9};
  const double squared[4] = {0.81, -0.27, -0.27, 0.81};
  return trial::net_of([&](int i, int k) {
    return Vector<double>(at[i], at[k], a * squared[i] + b * squared[k] + c);
  });
}

TEMPLATE_TEST_CASE("A quadric graph is met where its equation says", "", float, double) {
  using Real = TestType;
  Random random(2203);
  const double rounding = static_cast<double>(ulps<Real>(1));
  int met = 0;
  for (int i = 0; i < 8000; ++i) {
    const double a = random.uniform(-0.5, 0.5);
    const double b = random.uniform(-0.5, 0.5);
    const double c = random.uniform(-0.1, 0.1);
    const Ray<double> ray = ray_towards(random, random.in_cube(0.5), 3);
    const Vector<double>& o = ray.origin;
    const Vector<double> d = glm::normalize(ray.direction);
    const double square = a * d.x * d.x + b * d.y * d.y;
    const double half = a * o.x * d.x + b * o.y * d.y - d.z / 2;
    const double rest = a * o.x * o.x + b * o.y * o.y + c - o.z;
    const double discriminant = half * half - square * rest;
    if (std::fabs(square) < 1e-3 || std::fabs(discriminant) < 1e-4) {
      continue;
    }
    const double tolerance = 1000 * rounding / std::sqrt(std::fabs(discriminant));
    std::vector<double> expected;
    bool is_clear = true;
    for (int sign = -1; sign <= 1 && discriminant > 0; sign += 2) {
      const double t = (-half + sign * std::sqrt(discriminant)) / square;
      const double inside = 0.9 - std::fmax(std::fabs(o.x + t * d.x), std::fabs(o.y + t * d.y));
      is_clear = is_clear && std::fabs(inside) > tolerance;
      if (inside > 0) {
        expected.push_back(t);
      }
    }
    if (!is_clear) {
      continue;
    }
    std::sort(expected.begin(), expected.end());
    const auto parameters =
        trial::parameters_of<Real>({paraboloid(a, b, c)}, false, k_methods[i % 2]);
    const Hits<Real> found = hits_on<Real>(parameters, {o, d});
    CAPTURE(i, discriminant, square);
    REQUIRE(found.count == 2 * static_cast<int>(expected.size()));
    for (std::size_t k = 0; k < expected.size(); ++k) {
      ++met;
      REQUIRE(std::fabs(static_cast<double>(found.hits[2 * k].distance) - expected[k]) < tolerance);
    }
  }
  CHECK(met > 2000);
}

/// Whether two rays' hits are the same ones, as far as rounding can tell.
template <class A, class B>
bool agree(const Hits<A>& a, const Hits<B>& b, double tolerance) {
  bool same = a.count == b.count;
  for (int i = 0; same && i < a.count; ++i) {
    same = std::fabs(static_cast<double>(a.hits[i].distance) -
                     static_cast<double>(b.hits[i].distance)) < tolerance &&
           a.hits[i].face == b.hits[i].face;
  }
  return same;
}

TEST_CASE("Both methods and both number types find the same hits") {
  Random random(2204);
  int of_methods = 0;
  int of_types = 0;
  int hits = 0;
  constexpr int k_rays = 10000;
  for (int i = 0; i < k_rays / 10; ++i) {
    ControlNets nets;
    for (int n = 1 + random.below(4); n > 0; --n) {
      nets.push_back(trial::random_net(random));
    }
    const auto halved = trial::parameters_of<double>(nets, false, SearchMethod::subdivision);
    const auto solved = trial::parameters_of<double>(nets, false, SearchMethod::roots);
    const auto in_float = trial::parameters_of<float>(nets, false, k_methods[i % 2]);
    for (int k = 0; k < 10; ++k) {
      const Ray<double> ray = ray_towards(random, random.in_cube(0.5), 4);
      const double length = glm::length(ray.direction);
      const Hits<double> found = hits_on(halved, ray);
      hits += found.count;
      of_methods += agree(found, hits_on(solved, ray), 1e-9 / length) ? 0 : 1;
      of_types += agree(found, hits_on(in_float, ray), 3e-3 / length) ? 0 : 1;
    }
  }
  CHECK(hits > k_rays);
  CHECK(of_methods == 0);
  CHECK(of_types <= k_rays / 1000);  // rays along a fold or an edge of a patch
}

/// How often a ray, both ways, meets the triangles of a fine mesh over a patch.
int mesh_hits(const ControlNet& net, const Ray<double>& ray) {
  constexpr int k_cells = 60;
  const Vector<double> across = glm::normalize(glm::cross(ray.direction, {0.3, 0.5, 0.8}));
  const Vector<double> up = glm::cross(glm::normalize(ray.direction), across);
  std::vector<glm::dvec2> image;
  for (int i = 0; i <= k_cells; ++i) {
    for (int k = 0; k <= k_cells; ++k) {
      const Vector<double> apart =
          trial::point_of(net, i / static_cast<double>(k_cells), k / static_cast<double>(k_cells)) -
          ray.origin;
      image.emplace_back(glm::dot(apart, across), glm::dot(apart, up));
    }
  }
  const auto left = [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x > 0;
  };
  const auto meets = [&](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return left(a, b) == left(b, c) && left(b, c) == left(c, a);
  };
  int count = 0;
  for (int i = 0; i < k_cells; ++i) {
    for (int k = 0; k < k_cells; ++k) {
      const auto at = static_cast<std::size_t>(i * (k_cells + 1) + k);
      const glm::dvec2* const next = image.data() + at + k_cells + 1;
      count += meets(image[at], next[0], image[at + 1]) ? 1 : 0;
      count += meets(image[at + 1], next[0], next[1]) ? 1 : 0;
    }
  }
  return count;
}

TEST_CASE("As many hits are found as a fine mesh of the patch has") {
  Random random(2211);
  int hits = 0;
  int several = 0;
  int different = 0;
  constexpr int k_rays = 3000;
  for (int i = 0; i < k_rays; ++i) {
    const ControlNet net = trial::random_net(random);
    const auto parameters = trial::parameters_of<double>({net}, false, k_methods[i % 2]);
    const Ray<double> ray = ray_towards(random, random.in_cube(0.4), 4);
    const int found = hits_on(parameters, ray).count / 2;
    hits += found;
    several += found > 1 ? 1 : 0;
    different += found == mesh_hits(net, ray) ? 0 : 1;
  }
  CHECK(hits > k_rays / 2);
  CHECK(several > k_rays / 10);
  CHECK(different <= k_rays / 500);  // the mesh's own error at folds and edges
}

}  // namespace
}  // namespace maquette::firmware::patches
