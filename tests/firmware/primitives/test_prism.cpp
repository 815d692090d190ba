#include "firmware/primitives/prism.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/extent.hpp"
#include "firmware/polynomials/spline.hpp"
#include "firmware/primitives/box.hpp"
#include "firmware/primitives/outline.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/primitives/parameters_of.hpp"
#include "tests/firmware/primitives/span_laws.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::prism {
namespace {

using trial::Random;

const double k_turn = 2 * std::acos(-1.0);

/// Points of a polygon, or control points of a closed spline, as pairs.
struct Contour {
  std::vector<double> points;
  bool is_curved;
};

/// A prism of either number type, and its outline as fine chords.
struct Solid {
  std::vector<double> parameters;
  std::vector<float> as_float;
  std::vector<Vector<double>> chords;  ///< pairs (x, y, 0)
};

void add_lines(const std::vector<double>& points, std::vector<double>& edges) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; i += 2) {
    edges.insert(edges.end(), {points[i], points[i + 1]});
    edges.insert(edges.end(), {points[(i + 2) % count], points[(i + 3) % count]});
  }
}

void add_cubics(const std::vector<double>& control, std::vector<double>& edges) {
  const int sections = static_cast<int>(control.size()) / 2;
  std::vector<double> points(static_cast<std::size_t>(sections * k_section_stride + k_point_reals));
  write_bezier_points(control.data(), sections, sections, points.data());
  for (int i = 0; i < sections; ++i) {
    const auto first = points.begin() + i * k_section_stride;
    edges.insert(edges.end(), first, first + k_cubic_reals);
  }
}

void add_chords(Solid& solid) {
  const Outline<double> curve = outline(solid.parameters.data());
  for (int edge = 0; edge < curve.edges(); ++edge) {
    const double* points = curve.edge(edge);
    if (curve.is_line(edge)) {
      solid.chords.emplace_back(points[0], points[1], 0);
      solid.chords.emplace_back(points[2], points[3], 0);
      continue;
    }
    constexpr int k_chords = 100;
    for (int i = 0; i < k_chords; ++i) {
      for (const int end : {i, i + 1}) {
        const CurvePoint<double> point = curve_point(points, static_cast<double>(end) / k_chords);
        solid.chords.emplace_back(point.x, point.y, 0);
      }
    }
  }
}

Solid solid_of(const std::vector<Contour>& contours) {
  std::vector<double> lines;
  std::vector<double> cubics;
  for (const Contour& contour : contours) {
    contour.is_curved ? add_cubics(contour.points, cubics) : add_lines(contour.points, lines);
  }
  const int line_count = static_cast<int>(lines.size()) / k_line_reals;
  const int cubic_count = static_cast<int>(cubics.size()) / k_cubic_reals;
  Solid solid;
  solid.parameters.assign(static_cast<std::size_t>(parameter_count(line_count, cubic_count)), 0);
  solid.parameters[0] = line_count;
  solid.parameters[1] = cubic_count;
  std::copy(cubics.rbegin(), cubics.rend(), solid.parameters.rbegin());
  std::copy(lines.rbegin(), lines.rend(),
            solid.parameters.rbegin() + static_cast<std::ptrdiff_t>(cubics.size()));
  complete_parameters(solid.parameters.data());
  solid.as_float.assign(solid.parameters.begin(), solid.parameters.end());
  add_chords(solid);
  return solid;
}

/// About a circle, in either direction; every `stride`-th point next.
Contour round_contour(Random& random, double size, double roughness, int stride) {
  const int count = 2 * stride + 1 + random.below(8);
  const bool is_reversed = random.coin();
  Contour contour{{}, random.coin()};
  for (int i = 0; i < count; ++i) {
    const double angle = (is_reversed ? -k_turn : k_turn) * i * stride / count;
    const double radius = size * (1 - roughness * random.uniform());
    contour.points.push_back(radius * std::cos(angle));
    contour.points.push_back(radius * std::sin(angle));
  }
  return contour;
}

Contour square(double half) {
  return {{-half, -half, half, -half, half, half, -half, half}, false};
}

/// Contours in one another, each a hole or an island in the one around it.
Solid random_solid(Random& random) {
  std::vector<Contour> contours{round_contour(random, 1, 0.3, 1)};
  for (double size = 0.3; random.coin(); size /= 3) {
    contours.push_back(round_contour(random, size, 0.3, 1));
  }
  return solid_of(contours);
}

/// Contours that cross themselves and one another.
Solid random_tangle(Random& random) {
  std::vector<Contour> contours;
  for (int i = random.below(3); i >= 0; --i) {
    contours.push_back(round_contour(random, 0.9, 0.8, 1 + random.below(3)));
  }
  return solid_of(contours);
}

struct Place {
  bool is_inside;
  double distance;  ///< to the outline
};

Place outline_place(const Solid& solid, const Vector<double>& point) {
  const Vector<double> p(point.x, point.y, 0);
  Place place{false, 1e9};
  for (std::size_t i = 0; i < solid.chords.size(); i += 2) {
    const Vector<double>& a = solid.chords[i];
    const Vector<double>& b = solid.chords[i + 1];
    const Vector<double> side = b - a;
    const double length_squared = glm::dot(side, side);
    const double along = length_squared > 0 ? glm::dot(p - a, side) / length_squared : 0;
    const double share = std::fmax(0, std::fmin(1, along));
    place.distance = std::fmin(place.distance, glm::length(p - a - side * share));
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + side.x * (p.y - a.y) / side.y) {
      place.is_inside = !place.is_inside;
    }
  }
  return place;
}

Place place_of(const Solid& solid, const Vector<double>& point) {
  Place place = outline_place(solid, point);
  place.distance = std::fmin(place.distance, std::fabs(std::fabs(point.z) - 1));
  place.is_inside = place.is_inside && std::fabs(point.z) < 1;
  return place;
}

template <class Real>
struct Hits {
  Hit<Real> hits[k_crossing_limit];
  int count;
};

template <class Real>
Hits<Real> hits_on(const Solid& solid, const Vector<double>& origin,
                   const Vector<double>& direction) {
  Hits<Real> found;
  found.count = intersect<Real>({Vector<Real>(origin), Vector<Real>(direction)},
                                parameters_of<Real>(solid), found.hits);
  return found;
}

/// Random rays towards the solid, many of them special: level, along the axis or nearly so, through
/// a corner, along an edge.
Ray<double> random_ray(Random& random, const Solid& solid, double far) {
  Vector<double> target = random.in_cube(0.95);
  Vector<double> direction = random.direction();
  const std::size_t chord =
      2 * static_cast<std::size_t>(random.below(static_cast<int>(solid.chords.size() / 2)));
  switch (random.below(8)) {
    case 0:
      direction.z = 0;
      break;
    case 1:
      direction = {0, 0, random.coin() ? 1 : -1};
      break;
    case 2:
      direction *= random.magnitude(1e-12, 1e-2);
      direction.z = 1;
      break;
    case 3:
      target.x = solid.chords[chord].x;
      target.y = solid.chords[chord].y;
      break;
    case 4:
      target.x = solid.chords[chord].x;
      target.y = solid.chords[chord].y;
      direction = solid.chords[chord + 1] - solid.chords[chord];
      direction.z = random.coin() ? 0 : 0.3;
      break;
    default:
      break;
  }
  direction = glm::normalize(direction);
  return {target - direction * random.uniform(0, far), direction * random.magnitude(0.3, 3)};
}

template <class Real>
void check_spans(const Solid& solid, const Ray<double>& ray, double margin) {
  const Hits<Real> found = hits_on<Real>(solid, ray.origin, ray.direction);
  trial::check_spans(found.hits, found.count, ray, trial::samples_around(ray, 15, 0.11), margin,
                     [&](const Vector<double>& p) {
                       const Place place = place_of(solid, p);
                       return place.is_inside ? -place.distance : place.distance;
                     });
}

TEMPLATE_TEST_CASE("The spans of a ray are what lies inside the outline", "", float, double) {
  Random random(2201);
  for (int i = 0; i < 120; ++i) {
    const Solid solid = random.coin() ? random_solid(random) : random_tangle(random);
    for (int k = 0; k < 12; ++k) {
      CAPTURE(i, k);
      check_spans<TestType>(solid, random_ray(random, solid, 4), 2e-4);
    }
  }
}

TEMPLATE_TEST_CASE("No ray, however far its origin, meets a prism an odd number of times", "",
                   float, double) {
  Random random(2202);
  for (int i = 0; i < 300; ++i) {
    const Solid solid = random.coin() ? random_solid(random) : random_tangle(random);
    for (int k = 0; k < 400; ++k) {
      const Ray<double> ray = random_ray(random, solid, random.magnitude(1, 1e8));
      CAPTURE(i, k);
      const int count = hits_on<TestType>(solid, ray.origin, ray.direction).count;
      REQUIRE(count % 2 == 0);
      REQUIRE(count <= hit_limit(parameters_of<TestType>(solid)));
    }
  }
}

/// Coordinates 0, +-1/2, +-1 of a number below 125.
Vector<double> lattice_point(int number) {
  return Vector<double>(number % 5 - 2, number / 5 % 5 - 2, number / 25 - 2) * 0.5;
}

TEMPLATE_TEST_CASE("Rays through corners, along edges and in faces are no exception", "", float,
                   double) {
  const Solid frame = solid_of({square(1), square(0.5)});
  for (int from = 0; from < 125; ++from) {
    for (int to = 0; to < 125; ++to) {
      if (lattice_point(to) != Vector<double>(0, 0, 0)) {
        CAPTURE(from, to);
        check_spans<TestType>(frame, {lattice_point(from), lattice_point(to)}, 1e-5);
      }
    }
  }
}

TEMPLATE_TEST_CASE("A square prism is the box", "", float, double) {
  using Real = TestType;
  Random random(2203);
  const Solid cube = solid_of({square(1)});
  const double tolerance = 100 * static_cast<double>(ulps<Real>(1));
  for (int i = 0; i < 20000; ++i) {
    const Ray<double> ray = random_ray(random, cube, 4);
    const Ray<Real> rounded{Vector<Real>(ray.origin), Vector<Real>(ray.direction)};
    Hit<Real> expected[2];
    const int count = box::intersect<Real>(rounded, nullptr, expected);
    const Hits<Real> found = hits_on<Real>(cube, ray.origin, ray.direction);
    const double speed = glm::length(ray.direction);
    const auto apart = [&](const Hit<Real>& a, const Hit<Real>& b) {
      return static_cast<double>(b.distance - a.distance) * speed;
    };
    if (count != found.count) {
      // Through an edge or in a face, where rounding decides.
      const Hit<Real>* hits = count == 2 ? expected : found.hits;
      const double middle = 0.5 * static_cast<double>(hits[0].distance + hits[1].distance);
      REQUIRE(place_of(cube, ray.origin + ray.direction * middle).distance < tolerance);
      continue;
    }
    for (int k = 0; k < count; ++k) {
      CAPTURE(i, k, ray.direction.x, ray.direction.y, ray.direction.z);
      // In an edge of the cube the two may name different faces.
      const Vector<double> outward =
          settle(ray.origin, found.hits[k].face, cube.parameters.data()).normal;
      const double slope = std::fmin(std::fabs(glm::dot(glm::normalize(outward), ray.direction)),
                                     std::fabs(ray.direction[expected[k].face / 2])) /
                           speed;
      REQUIRE(std::fabs(apart(expected[k], found.hits[k])) * slope < tolerance);
    }
  }
}

struct Measure {
  double volume;
  double area;
};

/// Closed forms (Green): the chords' area and length, two deep and two ends. The edges have the
/// solid on their left.
Measure exact_measure(const Solid& solid) {
  double area = 0;
  double length = 0;
  for (std::size_t i = 0; i < solid.chords.size(); i += 2) {
    const Vector<double>& a = solid.chords[i];
    const Vector<double>& b = solid.chords[i + 1];
    area += 0.5 * (a.x * b.y - b.x * a.y);
    length += glm::length(b - a);
  }
  return {2 * area, 2 * area + 2 * length};
}

/// From the chords of parallel rays through a grid, over directions spread evenly (a spiral of
/// equal areas): the volume is theirs, the area twice the mean of the crossings' cells (Crofton).
template <class Real>
Measure measure_by_chords(const Solid& solid, Random& random) {
  const double cell = 0.05;
  const int cells = static_cast<int>(4 / cell);
  const int directions = 40;
  Measure measure{0, 0};
  for (int i = 0; i < directions; ++i) {
    const double height = (2 * i + 1.0) / directions - 1;
    const double turn = i * k_turn / 2 * (3 - std::sqrt(5.0));
    const double radius = std::sqrt(1 - height * height);
    const Vector<double> direction(radius * std::cos(turn), radius * std::sin(turn), height);
    const Vector<double> aside = glm::normalize(glm::cross(direction, random.direction()));
    const Vector<double> up = glm::cross(direction, aside);
    for (int place = 0; place < cells * cells; ++place) {
      const double x = -2 + (place % cells + random.uniform()) * cell;
      const double y = -2 + (place / cells + random.uniform()) * cell;
      const Hits<Real> found =
          hits_on<Real>(solid, aside * x + up * y - direction * 3.0, direction);
      measure.area += 2.0 * found.count;
      for (int k = 0; k < found.count; ++k) {
        measure.volume += static_cast<double>(found.hits[k].distance) * (k % 2 == 0 ? -1 : 1);
      }
    }
  }
  const double share = cell * cell / directions;
  return {measure.volume * share, measure.area * share};
}

TEMPLATE_TEST_CASE("Chords give the volume and the area of prisms with holes", "", float, double) {
  Random random(2204);
  const Solid frame = solid_of({square(0.8), square(0.5)});
  const Measure of_frame = exact_measure(frame);
  CHECK(of_frame.volume == Approx(2 * (1.6 * 1.6 - 1)));
  CHECK(of_frame.area == Approx(2 * (1.6 * 1.6 - 1) + 2 * (6.4 + 4)));
  for (const Solid& solid : {frame, random_solid(random), random_solid(random)}) {
    const Measure expected = exact_measure(solid);
    const Measure found = measure_by_chords<TestType>(solid, random);
    CHECK(found.volume == Approx(expected.volume).epsilon(0.005));
    CHECK(found.area == Approx(expected.area).epsilon(0.01));
  }
}

/// Distance from a hit to the next edge of the solid.
double room_around(const Solid& solid, const Vector<double>& p, std::uint8_t face) {
  if (face >= k_upper_end) {
    return outline_place(solid, p).distance;
  }
  const Outline<double> curve = outline(solid.parameters.data());
  const double* points = curve.edge(face);
  const double* last = points + (curve.is_line(face) ? 2 : 6);
  const double to_ends = std::fmin(std::hypot(p.x - points[0], p.y - points[1]),
                                   std::hypot(p.x - last[0], p.y - last[1]));
  return std::fmin(to_ends, 1 - std::fabs(p.z));
}

/// How far rounding to float may move a hit along its ray; large where it may take it past an edge.
double uncertainty(const Solid& solid, const Ray<double>& ray, const Hit<double>& hit) {
  const Vector<double> p = ray.origin + ray.direction * hit.distance;
  const Vector<double> outward =
      glm::normalize(settle(p, hit.face, solid.parameters.data()).normal);
  return room_around(solid, p, hit.face) < 1e-5
             ? 1e9
             : 1e-5 / std::fabs(glm::dot(outward, ray.direction));
}

TEST_CASE("Floats find the hits of doubles where the ray does not graze") {
  Random random(2205);
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const Solid solid = random_solid(random);
    for (int k = 0; k < 40; ++k) {
      Ray<double> ray = random_ray(random, solid, 4);
      ray.origin = Vector<double>(Vector<float>(ray.origin));
      ray.direction = Vector<double>(Vector<float>(ray.direction));
      const Hits<double> exact = hits_on<double>(solid, ray.origin, ray.direction);
      const Hits<float> found = hits_on<float>(solid, ray.origin, ray.direction);
      for (int j = 0; j < exact.count; ++j) {
        const double t = exact.hits[j].distance;
        const double span = std::fabs(exact.hits[j ^ 1].distance - t);
        const double tolerance = uncertainty(solid, ray, exact.hits[j]);
        const double other = uncertainty(solid, ray, exact.hits[j ^ 1]);
        const double worst = std::fmax(tolerance, other);
        if (worst > 1e-4 || span < 10 * worst) {
          continue;
        }
        ++checked;
        CAPTURE(i, k, j, t, tolerance, static_cast<int>(exact.hits[j].face));
        REQUIRE(std::any_of(found.hits, found.hits + found.count, [&](const Hit<float>& hit) {
          return std::fabs(static_cast<double>(hit.distance) - t) < tolerance;
        }));
      }
    }
  }
  CHECK(checked > 5000);
}

TEMPLATE_TEST_CASE("Settled points lie on the surface, within its bounds, with outward normals", "",
                   float, double) {
  using Real = TestType;
  Random random(2206);
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const Solid solid = random_solid(random);
    const Real* parameters = parameters_of<Real>(solid);
    Box<Real> box{};
    REQUIRE(bounds(parameters, box));
    for (int k = 0; k < 20; ++k) {
      const Ray<double> ray = random_ray(random, solid, 4);
      const Hits<Real> found = hits_on<Real>(solid, ray.origin, ray.direction);
      for (int j = 0; j < found.count; ++j) {
        const Hit<Real>& hit = found.hits[j];
        const Vector<double> p = ray.origin + ray.direction * static_cast<double>(hit.distance);
        const FacePoint<Real> on_face = settle(Vector<Real>(p), hit.face, parameters);
        const Vector<Real>& settled = on_face.position;
        const Vector<double> on(settled);
        CAPTURE(i, k, j, static_cast<int>(hit.face), on.x, on.y, on.z);
        REQUIRE(place_of(solid, on).distance < 5e-5);
        REQUIRE(magnitude(higher(box.low, lower(settled, box.high)) - settled) <= ulps<Real>(4));
        const Vector<Real> outward = on_face.normal;
        REQUIRE(length(outward) > Real(0));
        const double step = 1e-3;
        const Vector<double> away = glm::normalize(Vector<double>(outward)) * step;
        const Place beyond = place_of(solid, on + away);
        const Place within = place_of(solid, on - away);
        if (beyond.distance > 0.9 * step && within.distance > 0.9 * step) {
          ++checked;
          REQUIRE(!beyond.is_inside);
          REQUIRE(within.is_inside);
        }
      }
    }
  }
  CHECK(checked > 1000);
}

TEMPLATE_TEST_CASE("A ray that leaves a convex prism does not meet it again", "", float, double) {
  using Real = TestType;
  Random random(2207);
  const Solid solids[] = {
      solid_of({{{1, 0, 0.7, 0.7, 0, 1, -0.7, 0.7, -1, 0, -0.7, -0.7, 0, -1, 0.7, -0.7}, true}}),
      solid_of({square(0.8)})};
  for (int i = 0; i < 20000; ++i) {
    const Solid& solid = solids[i % 2];
    const Real* parameters = parameters_of<Real>(solid);
    const Vector<double> target = random.in_cube(0.6);
    const Vector<double> direction = random.direction();
    const Hits<Real> found = hits_on<Real>(solid, target - direction * 3.0, direction);
    if (found.count == 0) {
      continue;
    }
    const Vector<Real> p =
        Vector<Real>(target - direction * 3.0) + Vector<Real>(direction) * found.hits[0].distance;
    const FacePoint<Real> on_face = settle(p, found.hits[0].face, parameters);
    const Vector<Real>& settled = on_face.position;
    const Vector<Real> outward = normalize(on_face.normal);
    const Vector<Real> start = settled + outward * ulps<Real>(32);
    const Vector<double> axis(outward);
    const Vector<double> away =
        random.direction_around(glm::normalize(axis), random.magnitude(1e-6, 1));
    const Hits<Real> again = hits_on<Real>(solid, Vector<double>(start), away);
    for (int k = 0; k < again.count; ++k) {
      CAPTURE(i, k, glm::dot(axis, away));
      REQUIRE(again.hits[k].distance <= ulps<Real>(64));
    }
  }
}

}  // namespace
}  // namespace maquette::firmware::prism
