#include "firmware/combine.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

constexpr SurfaceIndex k_red = 0;    // opaque
constexpr SurfaceIndex k_blue = 1;   // opaque
constexpr SurfaceIndex k_glass = 2;  // transparent
constexpr SurfaceIndex k_water = 3;  // transparent
constexpr NodeIndex k_leaf_of_a = 0;
constexpr NodeIndex k_leaf_of_b = 1;

/// A stretch of matter on a ray.
struct Span {
  float in;
  float out;
  SurfaceIndex medium;
};
using Spans = std::vector<Span>;

/// A crossing as a table states it.
struct Step {
  float distance;
  SurfaceIndex medium;
  NodeIndex seen;

  bool operator==(const Step& other) const {
    return distance == other.distance && medium == other.medium && seen == other.seen;
  }
};
using Steps = std::vector<Step>;

std::ostream& operator<<(std::ostream& out, const Step& step) {
  return out << "(" << step.distance << " -> " << step.medium << ", seen " << step.seen << ")";
}

constexpr float k_scale = 100;

/// A plane whose normal is so far from the ray's direction, along z.
PreparedLeaf<float> plane_at(float angle) {
  PreparedLeaf<float> leaf{};
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  leaf.to_screen = {1, 0, 0, 0, c, s, 0, -s, c, 0, 0, 0};
  leaf.from_screen = {1, 0, 0, 0, c, -s, 0, s, c, 0, 0, 0};
  leaf.scale = k_scale;
  return leaf;
}

/// Combines spans whose distances come from coordinates of size k_scale; their faces stand
/// at angles to the ray.
Steps combined(BooleanOperator combination, const Spans& a, const Spans& b, float angle_of_a = 0,
               float angle_of_b = 0) {
  Surface<float> surfaces[4] = {};
  surfaces[k_glass].transparent = surfaces[k_water].transparent = true;
  PreparedLeaf<float> prepared[2] = {plane_at(angle_of_a), plane_at(angle_of_b)};
  Leaf<float> leaves[2] = {};
  leaves[0].kind = leaves[1].kind = kind_of<half_space::Kind>;
  leaves[k_leaf_of_b].surface = k_blue;
  RayQuery<float> query{};
  query.ray.direction = {0, 0, 1};
  Frame<float> frame{};
  frame.database.leaves = leaves;
  frame.database.surfaces = surfaces;
  frame.prepared.leaves = prepared;
  frame.prepared.coarse_tolerance =
      k_scale * ulps<float>(6 * preprocessing::k_grazing * preprocessing::k_crossing_tolerance);
  std::vector<Crossing<float>> area(4 * (a.size() + b.size()));
  std::size_t count = 0;
  for (const Span& span : a) {
    area[count++] = {span.in, k_leaf_of_a, 0, false, span.medium};
    area[count++] = {span.out, k_leaf_of_a, 1, true, k_void};
  }
  for (const Span& span : b) {
    area[count++] = {span.in, k_leaf_of_b, 0, false, span.medium};
    area[count++] = {span.out, k_leaf_of_b, 1, true, k_void};
  }
  const auto result = static_cast<std::size_t>(combine(frame, query, combination, area.data(),
                                                       static_cast<std::int32_t>(2 * a.size()),
                                                       static_cast<std::int32_t>(2 * b.size())));
  Steps steps;
  for (std::size_t i = 0; i < result; ++i) {
    steps.push_back({area[i].distance, area[i].medium, area[i].leaf});
  }
  return steps;
}

Steps union_of(const Spans& a, const Spans& b) { return combined(BooleanOperator::union_of, a, b); }
Steps intersection(const Spans& a, const Spans& b) {
  return combined(BooleanOperator::intersection, a, b);
}
Steps difference(const Spans& a, const Spans& b) {
  return combined(BooleanOperator::difference, a, b);
}

SurfaceIndex medium_at(const Spans& spans, float distance) {
  for (const Span& span : spans) {
    if (span.in < distance && distance < span.out) {
      return span.medium;
    }
  }
  return k_void;
}

SurfaceIndex medium_at(const Steps& steps, float distance) {
  SurfaceIndex medium = k_void;
  for (const Step& step : steps) {
    medium = step.distance < distance ? step.medium : medium;
  }
  return medium;
}

bool is_opaque(SurfaceIndex medium) { return medium == k_red || medium == k_blue; }

/// The set operation at one point of the ray, by its definition.
SurfaceIndex expected_medium(BooleanOperator combination, SurfaceIndex a, SurfaceIndex b) {
  const bool in_a = a != k_void;
  const bool in_b = b != k_void;
  if (combination == BooleanOperator::difference) {
    return in_a && !in_b ? a : k_void;
  }
  if (combination == BooleanOperator::intersection) {
    return in_a && in_b ? a : k_void;
  }
  if (in_a != in_b) {
    return in_a ? a : b;
  }
  if (is_opaque(a) != is_opaque(b)) {
    return is_opaque(a) ? a : b;
  }
  return smaller(a, b);
}

/// Up to three spans with ends on a coarse grid, so that ends of both operands often fall together.
Spans random_spans(trial::Random& random) {
  Spans spans;
  int at = random.below(3);
  for (int left = random.below(4); left > 0; --left) {
    const int in = at + random.below(3);
    const int out = in + 1 + random.below(3);
    const auto medium = static_cast<SurfaceIndex>(random.below(4));
    spans.push_back({static_cast<float>(in), static_cast<float>(out), medium});
    at = out + 1;
  }
  return spans;
}

/// The same spans with ends off by what two ways of computing a coordinate may differ.
Spans rounded_otherwise(trial::Random& random, Spans spans) {
  const auto off = [&random] {
    return static_cast<float>(random.uniform(-1.5, 1.5)) * k_scale * ulps<float>(1);
  };
  for (Span& span : spans) {
    span.in += off();
    span.out += off();
  }
  return spans;
}

TEST_CASE("Intervals of opaque bodies combine as tables say") {
  const NodeIndex a = k_leaf_of_a;
  const NodeIndex b = k_leaf_of_b;
  const Spans one{{2, 6, k_red}};
  const Spans apart{{7, 9, k_blue}};
  const Spans overlapping{{4, 8, k_blue}};
  const Spans nested{{3, 5, k_blue}};
  const Spans around{{1, 7, k_blue}};
  const Spans touching{{6, 9, k_blue}};
  const Spans same_start{{2, 4, k_blue}};
  const Spans same_end{{4, 6, k_blue}};
  const Spans equal{{2, 6, k_blue}};
  const Spans none{};

  CHECK(union_of(one, none) == Steps{{2, k_red, a}, {6, k_void, a}});
  CHECK(union_of(none, one) == Steps{{2, k_red, b}, {6, k_void, b}});
  CHECK(union_of(none, none).empty());
  CHECK(union_of(one, apart) ==
        Steps{{2, k_red, a}, {6, k_void, a}, {7, k_blue, b}, {9, k_void, b}});
  CHECK(union_of(one, overlapping) == Steps{{2, k_red, a}, {8, k_void, b}});
  CHECK(union_of(one, nested) == Steps{{2, k_red, a}, {6, k_void, a}});
  CHECK(union_of(one, around) == Steps{{1, k_blue, b}, {7, k_void, b}});
  CHECK(union_of(one, touching) == Steps{{2, k_red, a}, {9, k_void, b}});
  CHECK(union_of(touching, one) == Steps{{2, k_red, b}, {9, k_void, a}});
  CHECK(union_of(one, equal) == Steps{{2, k_red, a}, {6, k_void, b}});

  CHECK(intersection(one, none).empty());
  CHECK(intersection(none, one).empty());
  CHECK(intersection(one, apart).empty());
  CHECK(intersection(one, overlapping) == Steps{{4, k_red, b}, {6, k_void, a}});
  CHECK(intersection(one, nested) == Steps{{3, k_red, b}, {5, k_void, b}});
  CHECK(intersection(one, around) == Steps{{2, k_red, a}, {6, k_void, a}});
  CHECK(intersection(one, touching).empty());
  CHECK(intersection(touching, one).empty());
  CHECK(intersection(one, equal) == Steps{{2, k_red, a}, {6, k_void, a}});

  CHECK(difference(one, none) == Steps{{2, k_red, a}, {6, k_void, a}});
  CHECK(difference(none, one).empty());
  CHECK(difference(one, apart) == Steps{{2, k_red, a}, {6, k_void, a}});
  CHECK(difference(one, overlapping) == Steps{{2, k_red, a}, {4, k_void, b}});
  CHECK(difference(one, nested) ==
        Steps{{2, k_red, a}, {3, k_void, b}, {5, k_red, b}, {6, k_void, a}});
  CHECK(difference(one, around).empty());
  CHECK(difference(one, touching) == Steps{{2, k_red, a}, {6, k_void, a}});
  CHECK(difference(touching, one) == Steps{{6, k_blue, a}, {9, k_void, a}});
  CHECK(difference(one, same_start) == Steps{{4, k_red, b}, {6, k_void, a}});
  CHECK(difference(one, same_end) == Steps{{2, k_red, a}, {4, k_void, b}});
  CHECK(difference(one, equal).empty());
}

TEST_CASE("Intervals of transparent bodies combine as tables say") {
  const NodeIndex a = k_leaf_of_a;
  const NodeIndex b = k_leaf_of_b;
  const Spans glass{{2, 6, k_glass}};
  const Spans stone{{4, 8, k_red}};
  const Spans grain{{3, 5, k_red}};
  const Spans water{{4, 8, k_water}};

  CHECK(union_of(glass, stone) == Steps{{2, k_glass, a}, {4, k_red, b}, {8, k_void, b}});
  CHECK(union_of(stone, glass) == Steps{{2, k_glass, b}, {4, k_red, a}, {8, k_void, a}});
  CHECK(union_of(glass, grain) ==
        Steps{{2, k_glass, a}, {3, k_red, b}, {5, k_glass, b}, {6, k_void, a}});
  CHECK(union_of(glass, water) == Steps{{2, k_glass, a}, {6, k_water, a}, {8, k_void, b}});
  CHECK(union_of(water, glass) == Steps{{2, k_glass, b}, {6, k_water, b}, {8, k_void, a}});
  CHECK(union_of(glass, Spans{{6, 8, k_water}}) ==
        Steps{{2, k_glass, a}, {6, k_water, b}, {8, k_void, b}});
  CHECK(union_of(glass, Spans{{6, 8, k_glass}}) == Steps{{2, k_glass, a}, {8, k_void, b}});
  CHECK(union_of(glass, Spans{{2, 6, k_red}}) == Steps{{2, k_red, b}, {6, k_void, b}});

  CHECK(intersection(glass, stone) == Steps{{4, k_glass, b}, {6, k_void, a}});
  CHECK(intersection(stone, glass) == Steps{{4, k_red, a}, {6, k_void, b}});
  CHECK(difference(glass, grain) ==
        Steps{{2, k_glass, a}, {3, k_void, b}, {5, k_glass, b}, {6, k_void, a}});
  CHECK(difference(stone, glass) == Steps{{6, k_red, b}, {8, k_void, a}});
}

TEST_CASE("Random intervals combine as sets of points do, also when ends differ by rounding") {
  trial::Random random(101);
  for (int i = 0; i < 4000; ++i) {
    const Spans a = random_spans(random);
    const Spans b = random_spans(random);
    const bool exact_ends = random.coin();
    const Spans b_on_ray = exact_ends ? b : rounded_otherwise(random, b);
    const auto combination = static_cast<BooleanOperator>(random.below(3));
    const Steps steps = combined(combination, a, b_on_ray);
    for (int cell = 0; cell < 32; ++cell) {
      const float middle = static_cast<float>(cell) + 0.5F;
      const SurfaceIndex expected =
          expected_medium(combination, medium_at(a, middle), medium_at(b, middle));
      const SurfaceIndex found = medium_at(steps, middle);
      // Between two opaque bodies there is nothing to see, so either may stand for both.
      const bool alike = expected == found || (is_opaque(expected) && is_opaque(found));
      REQUIRE(alike);
    }
    for (std::size_t k = 1; k < steps.size(); ++k) {
      REQUIRE(steps[k].distance - steps[k - 1].distance > 0.5F);
      REQUIRE(steps[k].medium != steps[k - 1].medium);
    }
  }
}

TEST_CASE("A union does not depend on the order of its operands") {
  trial::Random random(102);
  for (int i = 0; i < 4000; ++i) {
    const Spans a = random_spans(random);
    const Spans b = random_spans(random);
    Steps one = union_of(a, b);
    const Steps other = union_of(b, a);
    for (Step& step : one) {
      step.seen = step.seen == k_leaf_of_a ? k_leaf_of_b : k_leaf_of_a;
    }
    REQUIRE(one.size() == other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      REQUIRE(one[k].distance == other[k].distance);
      REQUIRE(one[k].medium == other[k].medium);
      // Where faces of one surface coincide, either may be seen.
      const SurfaceIndex in_a = medium_at(a, one[k].distance + 0.5F);
      const SurfaceIndex in_b = medium_at(b, one[k].distance + 0.5F);
      if (one[k].medium != k_void && in_a != in_b) {
        REQUIRE(one[k].seen == other[k].seen);
      }
    }
  }
}

TEST_CASE("At a crease the face is seen that bounds the matter, of coincident faces the winner's") {
  const NodeIndex a = k_leaf_of_a;
  const NodeIndex b = k_leaf_of_b;
  const float rounding = 4e-5F;
  constexpr float k_crease = 1.2F;
  const Spans blue{{2, 6, k_blue}};
  const Spans red{{2 + rounding, 6 + rounding, k_red}};
  const auto seen = [](BooleanOperator combination, const Spans& one, const Spans& other,
                       float angle) {
    const Steps steps = combined(combination, one, other, 0, angle);
    REQUIRE(steps.size() == 2);
    return std::pair(steps[0].seen, steps[1].seen);
  };
  CHECK(seen(BooleanOperator::union_of, blue, red, 0).first == b);
  CHECK(seen(BooleanOperator::union_of, blue, red, k_crease) == std::pair(a, b));
  CHECK(seen(BooleanOperator::union_of, red, blue, k_crease) == std::pair(b, a));
  CHECK(seen(BooleanOperator::intersection, blue, red, 0) == std::pair(a, a));
  CHECK(seen(BooleanOperator::intersection, blue, red, k_crease) == std::pair(b, a));
  CHECK(seen(BooleanOperator::intersection, red, blue, k_crease) == std::pair(a, b));
  const Spans behind{{1, 2 + rounding, k_red}};
  CHECK(seen(BooleanOperator::difference, blue, behind, k_crease).first == b);
}

TEST_CASE("Of three crossings within rounding the two that are nearest fall together") {
  const float rounding = 4e-5F;
  // A body that ends where it begins in the other leaves nothing of itself.
  CHECK(difference({{6 - rounding, 6, k_red}}, {{2, 6, k_blue}}).empty());
  CHECK(intersection({{6 - rounding, 6, k_red}}, {{6, 9, k_blue}}).empty());
}

TEST_CASE("A ray that grazes faces sees one where they are apart by rounding across them") {
  const float apart = 5e-3F;
  const float grazing = std::acos(0.01F);
  const Spans one{{2, 6, k_red}};
  const Spans other{{2 + apart, 6 + apart, k_blue}};
  CHECK(combined(BooleanOperator::difference, one, other).size() == 2);
  CHECK(combined(BooleanOperator::difference, one, other, grazing, grazing).empty());
  CHECK(combined(BooleanOperator::difference, one, other, grazing, 0.8F).size() == 2);
}

TEST_CASE("Crossings apart by more than rounding are kept apart") {
  const float gap = 2e-3F;
  CHECK(union_of({{2, 6, k_red}}, {{6 + gap, 9, k_blue}}).size() == 4);
  CHECK(difference({{2, 6, k_red}}, {{2 + gap, 9, k_blue}}).size() == 2);
  CHECK(intersection({{2, 6, k_red}}, {{6 - gap, 9, k_blue}}).size() == 2);
}

}  // namespace
}  // namespace maquette::firmware
