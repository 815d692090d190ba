#include "firmware/preprocess.hpp"

#include "tests/catch.hpp"
#include "tests/firmware/random_model.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Random;

/// The same tree twice, once with extents that shut nothing out.
template <class Real>
struct TreePair {
  TreePair(const Model& model, NodeIndex root) : shut(model, root), open(model, root) {
    open.open_extents();
  }
  BuiltFrame<Real> shut;
  BuiltFrame<Real> open;
};

template <class Real>
bool are_same(const std::vector<Crossing<Real>>& a, const std::vector<Crossing<Real>>& b) {
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i) {
    same = a[i].distance == b[i].distance && a[i].leaf == b[i].leaf && a[i].medium == b[i].medium;
  }
  return same;
}

TEMPLATE_TEST_CASE("No secondary ray that meets a tree fails its spheres", "", float, double) {
  Random random(701);
  int met = 0;
  int lost = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const double size = random.magnitude(1e-3, 1e3);
    const Vector<double> center = random.in_cube(10) * size;
    const auto tree = trial::random_tree(random, Model{}, 1 + random.below(9), center, size);
    TreePair<TestType> pair(tree.model, tree.root);
    for (int ray = 0; ray < 60; ++ray) {
      const Vector<double> aim = center + random.in_cube(size);
      const Vector<double> from = aim - random.direction() * (size * random.magnitude(0.1, 1e3));
      const Vector<double> direction = glm::normalize(aim - from);
      const auto reference = pair.open.crossings_of(from, direction);
      met += reference.empty() ? 0 : 1;
      lost += are_same(reference, pair.shut.crossings_of(from, direction)) ? 0 : 1;
    }
  }
  CHECK(met > 4000);
  CHECK(lost == 0);
}

/// Primary rays that meet something, and those of them that rectangles keep from it.
struct RectangleTally {
  int met = 0;
  int lost = 0;
};

template <class Real>
void look_through(TreePair<Real>& pair, const Model& model, RectangleTally& tally) {
  for (std::int16_t row = 0; row < model.rows; row = static_cast<std::int16_t>(row + 3)) {
    for (std::int16_t column = 0; column < model.columns; ++column) {
      const auto query = primary_ray(pair.open.frame.database, column, row);
      const auto reference = pair.open.crossings_of(query);
      tally.met += reference.empty() ? 0 : 1;
      tally.lost += are_same(reference, pair.shut.crossings_of(query)) ? 0 : 1;
    }
  }
}

TEMPLATE_TEST_CASE("No primary ray that meets a tree fails its rectangles", "", float, double) {
  Random random(702);
  RectangleTally tally;
  for (int trial = 0; trial < 300; ++trial) {
    const double size = random.magnitude(1e-3, 1e3);
    const Vector<double> center =
        Vector<double>(random.uniform(-2, 2), random.uniform(-2, 2), random.magnitude(0.5, 20)) *
        size;
    const auto tree = trial::random_tree(random, Model{}, 1 + random.below(9), center, size);
    TreePair<TestType> pair(tree.model, tree.root);
    look_through(pair, tree.model, tally);
  }
  CHECK(tally.met > 4000);
  CHECK(tally.lost == 0);
}

TEMPLATE_TEST_CASE("No ray of a parallel view that meets a tree fails its rectangles", "", float,
                   double) {
  Random random(703);
  RectangleTally tally;
  for (int trial = 0; trial < 300; ++trial) {
    const double size = random.magnitude(1e-3, 1e3);
    const Vector<double> center =
        Vector<double>(random.uniform(-2, 2), random.uniform(-2, 2), random.magnitude(0.5, 20)) *
        size;
    Model model;
    model.needs.parallel_view = true;
    model.field = size * random.uniform(2, 6);
    const auto tree = trial::random_tree(random, model, 1 + random.below(9), center, size);
    TreePair<TestType> pair(tree.model, tree.root);
    look_through(pair, tree.model, tally);
  }
  CHECK(tally.met > 4000);
  CHECK(tally.lost == 0);
}

TEST_CASE("Rectangles and spheres are tight around a single body") {
  Model model;
  model.columns = 64;
  model.rows = 64;
  const NodeIndex box = model.add(kind_of<box::Kind>, trial::moved({0, 0, 9}));
  const NodeIndex ball = model.add(kind_of<sphere::Kind>, trial::moved({0, 0, 9}));
  BuiltFrame<double> built(model, model.combine(BooleanOperator::union_of, box, ball));
  // The near face is 8 away: half of it is 1/8 of a screen that is 1 high, thus 8 pixels.
  const Rectangle& rectangle = built.frame.prepared.extents[box].rectangle;
  CHECK(rectangle.first_column >= 31 - 8 - 2);
  CHECK(rectangle.end_column <= 32 + 8 + 2);
  CHECK(rectangle.first_row >= 31 - 8 - 2);
  CHECK(rectangle.end_row <= 32 + 8 + 2);
  CHECK(built.frame.prepared.extents[ball].sphere.radius == Approx(1));
  CHECK(built.frame.prepared.extents[box].sphere.radius == Approx(std::sqrt(3.0)));
}

TEST_CASE("Operators narrow extents: a difference to its first operand, an intersection to both") {
  Model model;
  const NodeIndex wall = model.add(kind_of<box::Kind>, trial::moved({-1, 0, 9}));
  const NodeIndex ball = model.add(kind_of<sphere::Kind>, trial::moved({1, 0, 9}));
  const NodeIndex ground = model.add(kind_of<half_space::Kind>, trial::unmoved());
  model.combine(BooleanOperator::difference, wall, ball);
  model.combine(BooleanOperator::intersection, wall, ball);
  model.combine(BooleanOperator::union_of, wall, ball);
  model.combine(BooleanOperator::intersection, ground, ball);
  model.combine(BooleanOperator::union_of, ground, ball);
  BuiltFrame<double> built(model, wall);
  const Extent<double>* extents = built.frame.prepared.extents;
  const Extent<double>& difference = extents[3];
  const Extent<double>& intersection = extents[4];
  const Extent<double>& sum = extents[5];
  CHECK(difference.sphere.radius == extents[wall].sphere.radius);
  CHECK(difference.rectangle.end_column == extents[wall].rectangle.end_column);
  CHECK(intersection.box.low.x == Approx(0).margin(1e-9));
  CHECK(intersection.box.high.x == Approx(0).margin(1e-9));
  CHECK(intersection.sphere.radius <= extents[ball].sphere.radius);
  CHECK(intersection.rectangle.first_column == extents[ball].rectangle.first_column);
  CHECK(intersection.rectangle.end_column == extents[wall].rectangle.end_column);
  CHECK(sum.box.low.x == Approx(-2));
  CHECK(sum.box.high.x == Approx(2));
  CHECK(extents[6].bounded);
  CHECK(extents[6].sphere.radius == extents[ball].sphere.radius);
  CHECK_FALSE(extents[7].bounded);
}

TEST_CASE("The useful zone is the root's rectangle: no pixel outside of it sees a body") {
  Random random(703);
  for (int trial = 0; trial < 40; ++trial) {
    const auto tree = trial::random_tree(random, Model{}, 5, {0, 0, 30}, 10);
    TreePair<float> pair(tree.model, tree.root);
    const Rectangle zone = pair.shut.frame.prepared.useful_zone;
    for (std::int16_t row = 0; row < tree.model.rows; ++row) {
      for (std::int16_t column = 0; column < tree.model.columns; ++column) {
        const auto query = primary_ray(pair.open.frame.database, column, row);
        REQUIRE((zone.contains(column, row) || pair.open.crossings_of(query).empty()));
      }
    }
  }
}

}  // namespace
}  // namespace maquette::firmware
