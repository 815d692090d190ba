#include "firmware/classify.hpp"

#include "firmware/arithmetic/counted.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/line_sums.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::check_body;
using trial::line_sums;
using trial::LineSums;
using trial::Model;
using trial::Placement;
using trial::Random;

constexpr double k_pi = elementary::k_pi;

TEMPLATE_TEST_CASE("Chords give the volume and the area of every convex primitive", "", float,
                   double) {
  const auto single = [](PrimitiveKind kind, double parameter) {
    return [=](Model& model, const Placement& placement) {
      return model.add(kind, placement, 0, parameter);
    };
  };
  check_body<TestType>(single(kind_of<box::Kind>, 0), 1.8, 8, 24);
  check_body<TestType>(single(kind_of<sphere::Kind>, 0), 1.2, 4 * k_pi / 3, 4 * k_pi);
  check_body<TestType>(single(kind_of<cylinder::Kind>, 0), 1.5, 2 * k_pi, 6 * k_pi);
  for (const double top : {0.0, 0.3, 0.9}) {
    check_body<TestType>(single(kind_of<cone::Kind>, top), 1.5, k_pi * (1 - top * top * top) / 3,
                         k_pi * (1 + top * top + std::sqrt(2.0) * (1 - top * top)));
  }
  const auto half_ball = [](Model& model, const Placement& placement) {
    const NodeIndex ball = model.add(kind_of<sphere::Kind>, placement);
    const NodeIndex half = model.add(kind_of<half_space::Kind>, placement);
    return model.combine(BooleanOperator::intersection, half, ball);
  };
  check_body<TestType>(half_ball, 1.2, 2 * k_pi / 3, 3 * k_pi);
}

TEMPLATE_TEST_CASE("Chords give the volume of distorted primitives", "", float, double) {
  Random random(603);
  const struct {
    PrimitiveKind kind;
    double volume;
  } solids[] = {{kind_of<box::Kind>, 8},
                {kind_of<sphere::Kind>, 4 * k_pi / 3},
                {kind_of<cylinder::Kind>, 2 * k_pi},
                {kind_of<cone::Kind>, k_pi / 3}};
  for (int i = 0; i < 8; ++i) {
    const Placement placement = random.placement(random.in_cube(3), 1, 3);
    Model model;
    const NodeIndex root = model.add(solids[i % 4].kind, placement);
    BuiltFrame<TestType> built(model, root);
    const LineSums sums = line_sums(built, placement[3], 1.8, 604);
    CHECK(std::fabs(sums.volume - solids[i % 4].volume * std::fabs(trial::determinant(placement))) <
          4 * sums.volume_error);
  }
}

/// Two primitives, the second shifted in the frame of the first.
auto pair_of(BooleanOperator combination, PrimitiveKind a, PrimitiveKind b,
             const Placement& b_to_a) {
  return [=](Model& model, const Placement& placement) {
    const NodeIndex first = model.add(a, placement);
    const NodeIndex second = model.add(b, concatenate(placement, b_to_a));
    return model.combine(combination, first, second);
  };
}

TEMPLATE_TEST_CASE("Chords give the volume and the area of two overlapping spheres", "", float,
                   double) {
  const double apart = 0.8;
  const double lens = k_pi * (4 + apart) * (2 - apart) * (2 - apart) / 12;
  const double cap = 2 * k_pi * (1 - apart / 2);
  const PrimitiveKind ball = kind_of<sphere::Kind>;
  const Placement shift = trial::moved({0, apart, 0});
  check_body<TestType>(pair_of(BooleanOperator::union_of, ball, ball, shift), 2,
                       8 * k_pi / 3 - lens, 8 * k_pi - 2 * cap);
  check_body<TestType>(pair_of(BooleanOperator::intersection, ball, ball, shift), 2, lens, 2 * cap);
  check_body<TestType>(pair_of(BooleanOperator::difference, ball, ball, shift), 2,
                       4 * k_pi / 3 - lens, 4 * k_pi);
}

TEMPLATE_TEST_CASE("Coincident faces leave neither skin nor hole", "", float, double) {
  const PrimitiveKind box = kind_of<box::Kind>;
  const PrimitiveKind cylinder = kind_of<cylinder::Kind>;
  const double r = 0.5;
  const Placement flush_bore = trial::scaled({r, r, 1});
  check_body<TestType>(pair_of(BooleanOperator::difference, box, cylinder, flush_bore), 1.8,
                       8 - 2 * k_pi * r * r, 24 - 2 * k_pi * r * r + 4 * k_pi * r);
  check_body<TestType>(pair_of(BooleanOperator::union_of, box, cylinder, flush_bore), 1.8, 8, 24);
  check_body<TestType>(pair_of(BooleanOperator::union_of, box, box, trial::moved({2, 0, 0})), 3.5,
                       16, 40);
  check_body<TestType>(pair_of(BooleanOperator::difference, box, box, trial::moved({2, 0, 0})), 1.8,
                       8, 24);
  const Placement half_box = concatenate(trial::moved({0.5, 0, 0}), trial::scaled({0.5, 1, 1}));
  check_body<TestType>(pair_of(BooleanOperator::difference, box, box, half_box), 1.8, 4, 16);
  check_body<TestType>(pair_of(BooleanOperator::intersection, box, box, half_box), 1.8, 4, 16);
}

constexpr int k_skin_rays = 20000;

/// Rays that meet something of what should be nothing: a body without, or in common with, another.
template <class Real>
int skins(BooleanOperator combination, PrimitiveKind kind, const Placement& other_to_body) {
  Random random(605);
  int found = 0;
  for (int trial = 0; trial < k_skin_rays / 50; ++trial) {
    const double size = random.magnitude(1e-4, 1e4);
    const Vector<double> center = random.in_cube(10) * size;
    Model model;
    const NodeIndex root =
        pair_of(combination, kind, kind, other_to_body)(model, random.placement(center, size, 3));
    BuiltFrame<Real> built(model, root);
    for (int ray = 0; ray < 50; ++ray) {
      const Vector<double> aim = center + random.in_cube(size / 2);
      const Vector<double> from = aim - random.direction() * (size * random.magnitude(1, 30));
      found += built.crossings_of(from, glm::normalize(aim - from)).empty() ? 0 : 1;
    }
  }
  return found;
}

TEMPLATE_TEST_CASE("A body turned onto itself vanishes by difference", "", float, double) {
  const BooleanOperator without = BooleanOperator::difference;
  const Placement quarter = trial::turned({0, 0, 1}, k_pi / 2);
  const Placement turn = trial::turned({0, 0, 1}, 0.7);
  // Rays that nearly lie in a face may still see it.
  constexpr int k_grazing = k_skin_rays / 10000;
  CHECK(skins<TestType>(without, kind_of<box::Kind>, quarter) <= k_grazing);
  CHECK(skins<TestType>(without, kind_of<sphere::Kind>, turn) <= k_grazing);
  CHECK(skins<TestType>(without, kind_of<cylinder::Kind>, turn) <= k_grazing);
  CHECK(skins<TestType>(without, kind_of<cone::Kind>, turn) <= k_grazing);
  CHECK(skins<TestType>(BooleanOperator::intersection, kind_of<box::Kind>,
                        trial::moved({2, 0, 0})) <= k_grazing);
}

TEST_CASE("Where the first operand is missed the second is not looked at") {
  const Vector<double> towards(0, 0, 1);
  const auto work_of = [&](BooleanOperator combination, double first_at) {
    Model model;
    const NodeIndex first = model.add(kind_of<sphere::Kind>, trial::moved({first_at, 0, 10}));
    const NodeIndex second = model.add(kind_of<sphere::Kind>, trial::moved({0.5, 0, 10}));
    BuiltFrame<Counted> built(model, model.combine(combination, first, second));
    built.open_extents();
    const auto query = trial::unit_query<Counted>({0, 0, 0}, towards);
    reset_counted_work();
    cross(built.frame, query, built.root(), built.area().crossings);
    return counted_work();
  };
  const auto divisions = [](const Work& work) {
    return work[Operation::divide] + work[Operation::divide_zero];
  };
  // A sphere takes one division.
  CHECK(divisions(work_of(BooleanOperator::difference, 0)) == 2);
  CHECK(divisions(work_of(BooleanOperator::difference, 5)) == 1);
  CHECK(divisions(work_of(BooleanOperator::intersection, 5)) == 1);
  CHECK(divisions(work_of(BooleanOperator::union_of, 5)) == 2);
}

}  // namespace
}  // namespace maquette::firmware
