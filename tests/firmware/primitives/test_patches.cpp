#include "firmware/primitives/patches.hpp"

#include <cmath>

#include "firmware/extent.hpp"
#include "firmware/primitives/box.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/patch_rays.hpp"

namespace maquette::firmware::patches {
namespace {

/// A closed set of any kind.
ControlNets random_solid(Random& random) {
  switch (random.below(4)) {
    case 0:
      return trial::random_blob(random, 0.7);
    case 1:
      return trial::random_ring(random, 3 + random.below(3), 3 + random.below(3));
    case 2:
      return trial::egg();
    default:
      return trial::flat_cube(0.5);
  }
}

/// A point of the set: on an edge, in a corner or anywhere.
Vector<double> random_point(Random& random, const ControlNets& nets) {
  const auto& net = nets[static_cast<std::size_t>(random.below(static_cast<int>(nets.size())))];
  const auto place = [&] {
    const int kind = random.below(6);
    return kind < 2 ? kind : kind == 2 ? random.below(9) / 8.0 : random.uniform();
  };
  const double u = place();
  return trial::point_of(net, u, place());
}

TEMPLATE_TEST_CASE("Every ray enters and leaves a closed set in turn, also through its joints", "",
                   float, double) {
  Random random(2201);
  for (int i = 0; i < 40; ++i) {
    const ControlNets nets = random_solid(random);
    for (const SearchMethod::Value method : k_methods) {
      const auto parameters = trial::parameters_of<TestType>(nets, true, method);
      for (int k = 0; k < 600; ++k) {
        const bool is_far = random.below(4) == 0;
        const Ray<double> ray =
            ray_towards(random, random_point(random, nets), is_far ? random.magnitude(1, 1e8) : 4);
        const PlanePair<TestType> planes =
            planes_of<TestType>({Vector<TestType>(ray.origin), Vector<TestType>(ray.direction)});
        Hits<TestType> found;
        HitList<TestType> list{found.hits, 0};
        const PatchSet<TestType> set = patch_set(parameters.data());
        intersect_node(planes, set, 0, 0, set.patches, list);
        CAPTURE(i, k, static_cast<int>(method), is_far, set.patches);
        REQUIRE(list.count % 2 == 0);
        sort(found.hits, list.count);
        int balance = 0;
        for (int n = 0; n < list.count; ++n) {
          balance += found.hits[n].face >= k_from_behind ? -1 : 1;
        }
        REQUIRE(balance == 0);
      }
    }
  }
}

/// Chords of parallel rays, and of rays of all directions, through a closed set.
template <class Real>
trial::Measures measures_by_rays(const Parameters<Real>& parameters, Random& random) {
  constexpr int k_rays = 40000;
  constexpr double k_radius = 1.5;
  trial::Measures sum{0, 0};
  for (int i = 0; i < k_rays; ++i) {
    const Vector<double> direction = random.direction();
    const Vector<double> aside = random.direction_around(direction, 0);
    // Stratified, so that the sums converge faster.
    const double share = (i + random.uniform()) / k_rays;
    const Ray<double> ray{aside * (k_radius * std::sqrt(share)) - direction * 3.0, direction};
    const Hits<Real> found = hits_on(parameters, ray);
    sum.area += found.count;
    for (int k = 0; k < found.count; ++k) {
      sum.volume += static_cast<double>(found.hits[k].distance) * (k % 2 == 0 ? -1 : 1);
    }
  }
  const double disc = std::acos(-1.0) * k_radius * k_radius / k_rays;
  return {sum.volume * disc, sum.area * disc * 2};
}

TEMPLATE_TEST_CASE("Chords in all directions give volume and area of a closed set", "", float,
                   double) {
  // Crofton: the mean over all directions of the area that chords cover is a quarter of the
  // surface.
  Random random(2205);
  for (int i = 0; i < 6; ++i) {
    const ControlNets nets = i < 2   ? trial::random_blob(random, 0.3)
                             : i < 4 ? trial::random_ring(random, 4, 4)
                                     : trial::egg();
    const trial::Measures exact = trial::measures_of(nets);
    const trial::Measures measured =
        measures_by_rays(trial::parameters_of<TestType>(nets, true, k_methods[i % 2]), random);
    CAPTURE(i);
    CHECK(measured.volume == Approx(exact.volume).epsilon(0.03));
    CHECK(measured.area == Approx(exact.area).epsilon(0.03));
  }
}

TEMPLATE_TEST_CASE("A cube of flat patches is the box, also along its faces", "", float, double) {
  using Real = TestType;
  Random random(2206);
  const double tolerance = static_cast<double>(ulps<Real>(100));
  for (const SearchMethod::Value method : k_methods) {
    const auto parameters = trial::parameters_of<Real>(trial::flat_cube(0.75), true, method);
    for (int i = 0; i < 4000; ++i) {
      Ray<double> ray = ray_towards(random, random.in_cube(0.75), 4);
      const int axis = random.below(3);
      const bool is_along = random.below(4) == 0;
      if (is_along) {
        ray.origin[axis] = random.coin() ? 0.75 : -0.75;
        ray.direction[axis] = 0;
      }
      const Hits<Real> found = hits_on(parameters, ray);
      REQUIRE(found.count % 2 == 0);
      Hit<double> expected[2];
      const Ray<double> scaled{ray.origin / 0.75, ray.direction / 0.75};
      const int count = box::intersect<double>(scaled, nullptr, expected);
      if (is_along || count == 0 || expected[1].distance - expected[0].distance < 1e-3) {
        continue;
      }
      REQUIRE(found.count == 2);
      for (int k = 0; k < 2; ++k) {
        const double apart = static_cast<double>(found.hits[k].distance) - expected[k].distance;
        REQUIRE(std::fabs(apart) * glm::length(ray.direction) < tolerance);
      }
    }
  }
}

TEMPLATE_TEST_CASE("Grazing rays meet a convex set twice or never", "", float, double) {
  using Real = TestType;
  Random random(2207);
  const ControlNets nets = trial::egg();
  for (const SearchMethod::Value method : k_methods) {
    const auto parameters = trial::parameters_of<Real>(nets, true, method);
    for (int i = 0; i < 3000; ++i) {
      const Vector<double> on = random_point(random, nets);
      const Vector<double> normal =
          glm::normalize(Vector<double>(on.x / 0.49, on.y / 0.49, on.z / (on.z < 0 ? 0.36 : 0.81)));
      const Vector<double> direction = random.direction_around(normal, 0);
      const double offset = random.magnitude(1e-9, 1e-1) * (random.coin() ? 1 : -1);
      const Hits<Real> found =
          hits_on<Real>(parameters, {on + normal * offset - direction * 2.0, direction});
      CAPTURE(i, offset);
      REQUIRE((found.count == 0 || found.count == 2));
      if (offset > 1e-2) {
        REQUIRE(found.count == 0);
      }
      if (offset < -1e-2) {
        REQUIRE(found.count == 2);
      }
    }
  }
}

TEMPLATE_TEST_CASE("Settled points lie on the patch, within the bounds, with normals to the ray",
                   "", float, double) {
  using Real = TestType;
  Random random(2208);
  const double rounding = static_cast<double>(ulps<Real>(1));
  int checked = 0;
  for (int i = 0; i < 60; ++i) {
    const bool is_solid = random.coin();
    ControlNets nets = is_solid ? random_solid(random) : ControlNets{trial::random_net(random)};
    const auto parameters = trial::parameters_of<Real>(nets, is_solid, k_methods[i % 2]);
    Box<Real> box{};
    REQUIRE(bounds(parameters.data(), box));
    for (int k = 0; k < 40; ++k) {
      const Ray<double> ray = ray_towards(random, random.in_cube(0.6), 4);
      const Hits<Real> found = hits_on(parameters, ray);
      for (int n = 0; n < found.count; ++n) {
        const Hit<Real>& hit = found.hits[n];
        const Vector<double> p = ray.origin + ray.direction * static_cast<double>(hit.distance);
        const FacePoint<Real> on_face = settle(Vector<Real>(p), hit.face, parameters.data());
        const Vector<Real>& settled = on_face.position;
        CAPTURE(i, k, n, static_cast<int>(hit.face));
        const Vector<double> way = glm::normalize(ray.direction);
        const Vector<double> outward(on_face.normal);
        REQUIRE(glm::length(outward) == Approx(1).epsilon(1e-4));
        const double slope = glm::dot(outward, way);
        // Rounding along the ray moves off a surface that is grazed less.
        REQUIRE(glm::length(Vector<double>(settled) - p) < 300 * rounding);
        REQUIRE(magnitude(higher(box.low, lower(settled, box.high)) - settled) <= ulps<Real>(4));
        if (std::fabs(slope) > 0.01) {
          ++checked;
          const bool is_front = is_solid ? n % 2 == 0 : true;
          REQUIRE((slope < 0) == is_front);
        }
      }
    }
  }
  CHECK(checked > 1000);
}

TEMPLATE_TEST_CASE("A ray that leaves a convex set does not meet it again", "", float, double) {
  using Real = TestType;
  Random random(2209);
  const ControlNets nets = trial::egg();
  for (const SearchMethod::Value method : k_methods) {
    const auto parameters = trial::parameters_of<Real>(nets, true, method);
    for (int i = 0; i < 6000; ++i) {
      const Vector<double> target =
          random.below(4) == 0 ? random_point(random, nets) : random.in_cube(0.4);
      const Ray<double> ray{target - random.direction() * 2.0, {}};
      const Vector<double> direction = glm::normalize(target - ray.origin);
      const Hits<Real> found = hits_on<Real>(parameters, {ray.origin, direction});
      if (found.count == 0) {
        continue;
      }
      const Hit<Real>& hit = found.hits[0];
      const Vector<Real> p = Vector<Real>(ray.origin) + Vector<Real>(direction) * hit.distance;
      const FacePoint<Real> on_face = settle(p, hit.face, parameters.data());
      const Vector<Real>& settled = on_face.position;
      const Vector<Real> outward = on_face.normal;
      const Vector<Real> start = settled + outward * ulps<Real>(16);
      const Vector<double> away = random.direction_around(glm::normalize(Vector<double>(outward)),
                                                          random.magnitude(1e-6, 1));
      const Hits<Real> again = hits_on<Real>(parameters, {Vector<double>(start), away});
      for (int k = 0; k < again.count; ++k) {
        CAPTURE(i, k, static_cast<double>(again.hits[k].distance));
        REQUIRE(again.hits[k].distance <= Real(0));
      }
    }
  }
}

TEMPLATE_TEST_CASE("Normals exist where an edge is collapsed to a point", "", float, double) {
  using Real = TestType;
  const auto parameters = trial::parameters_of<Real>(trial::egg(), true, SearchMethod::subdivision);
  Random random(2210);
  for (int end = -1; end <= 1; end += 2) {
    const double height = end < 0 ? 0.6 : 0.9;
    for (int i = 0; i < 200; ++i) {
      const double size = i == 0 ? 0 : random.magnitude(1e-12, 1e-3);
      const Vector<double> top(size * random.uniform(-1, 1), size * random.uniform(-1, 1),
                               end * height);
      const Hits<Real> found =
          hits_on<Real>(parameters, {{top.x, top.y, end * 2.0}, {0, 0, -1.0 * end}});
      REQUIRE(found.count == 2);
      const Vector<Real> outward =
          settle(Vector<Real>(top), found.hits[0].face, parameters.data()).normal;
      CAPTURE(i, size, outward.x, outward.y);
      REQUIRE(static_cast<double>(outward.z) * end > 0.999);
    }
  }
}

}  // namespace
}  // namespace maquette::firmware::patches
