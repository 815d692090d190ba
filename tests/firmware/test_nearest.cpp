#include "firmware/nearest.hpp"

#include "tests/catch.hpp"
#include "tests/firmware/random_model.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Random;
using trial::RandomTree;

/// A union, in halves, of solids and of bodies combined at random; `glass` is the share of solids
/// of glass.
RandomTree random_union(Random& random, int bodies, double glass) {
  Model model;
  const SurfaceIndex clear = model.add(trial::glass_surface(1.5, {0.1, 0.2, 0.3}));
  std::vector<NodeIndex> nodes;
  for (int i = 0; i < bodies; ++i) {
    const Vector<double> center = Vector<double>(0, 0, 8) + random.in_cube(3);
    const auto solid = [&] {
      const auto kind = static_cast<PrimitiveKind>(1 + random.below(4));
      const SurfaceIndex surface = random.uniform() < glass ? clear : SurfaceIndex{0};
      const Vector<double> place = center + random.in_cube(0.2);
      return model.add(kind, random.placement(place, random.uniform(0.4, 1.6), 3), surface, 0.4);
    };
    NodeIndex node = solid();
    if (random.below(3) == 0) {
      node = model.combine(static_cast<BooleanOperator>(random.below(3)), node, solid());
    }
    nodes.push_back(node);
  }
  while (nodes.size() > 1) {
    std::vector<NodeIndex> halves;
    for (std::size_t i = 0; i + 1 < nodes.size(); i += 2) {
      halves.push_back(model.combine(BooleanOperator::union_of, nodes[i], nodes[i + 1]));
    }
    if (nodes.size() % 2 == 1) {
      halves.push_back(nodes.back());
    }
    nodes = halves;
  }
  return {std::move(model), nodes.front()};
}

TEMPLATE_TEST_CASE("Boxes and the nearer child first find the same first thing ahead", "", float,
                   double) {
  using Real = TestType;
  Random random(2101);
  int found = 0;
  int inside = 0;
  for (int i = 0; i < 60; ++i) {
    const RandomTree tree = random_union(random, 2 + random.below(60), (i % 3) * 0.5);
    BuiltFrame<Real> built(tree.model, tree.root);
    for (int k = 0; k < 200; ++k) {
      const Vector<double> origin = Vector<double>(0, 0, 8) + random.in_cube(4);
      Vector<double> direction = random.direction();
      if (random.below(4) == 0) {
        direction = {0, 0, random.coin() ? 1 : -1};
      }
      const RayQuery<Real> query = trial::unit_query<Real>(origin, direction);
      built.frame.database.needs.large_unions = false;
      const std::vector<Crossing<Real>> all = built.crossings_of(query);
      built.frame.database.needs.large_unions = true;
      const Crossing<Real>* some = built.area().crossings;
      const std::int32_t count = cross_scene(built.frame, query, built.area().crossings);
      SurfaceIndex before_all = k_void;
      SurfaceIndex before_some = k_void;
      const auto all_count = static_cast<std::int32_t>(all.size());
      const std::int32_t a = first_ahead(all.data(), all_count, before_all);
      const std::int32_t b = first_ahead(some, count, before_some);
      CAPTURE(i, k);
      REQUIRE((a < all_count) == (b < count));
      REQUIRE(before_all == before_some);
      inside += before_all == k_void ? 0 : 1;
      if (a < all_count) {
        const Crossing<Real>& expected = all[static_cast<std::size_t>(a)];
        ++found;
        REQUIRE(some[b].distance == expected.distance);
        REQUIRE(some[b].leaf == expected.leaf);
        REQUIRE(some[b].face == expected.face);
        REQUIRE(some[b].medium == expected.medium);
      }
    }
  }
  CHECK(found > 2000);
  CHECK(inside > 200);
}

TEMPLATE_TEST_CASE("Pictures with shadows and glass do not depend on how unions are walked", "",
                   float, double) {
  Random random(2102);
  int lit = 0;
  for (int i = 0; i < 12; ++i) {
    RandomTree tree = random_union(random, 40, (i % 3) * 0.4);
    tree.model.lights.push_back({{6, 9, -3}, {1, 1, 1}});
    tree.model.ambient = {0.1, 0.1, 0.1};
    BuiltFrame<TestType> built(tree.model, tree.root);
    for (std::int16_t row = 0; row < tree.model.rows; row += 2) {
      for (std::int16_t column = 0; column < tree.model.columns; column += 2) {
        built.frame.database.needs.large_unions = false;
        const Pixel expected = built.pixel(column, row);
        built.frame.database.needs.large_unions = true;
        CAPTURE(i, column, row);
        REQUIRE(built.pixel(column, row).rgb == expected.rgb);
        lit += expected.rgb != 0 ? 1 : 0;
      }
    }
    REQUIRE(built.guards_are_whole());
  }
  CHECK(lit > 1000);
}

TEST_CASE("A ray in opaque matter sees the end of all that overlaps") {
  Model model;
  const auto ball = [&model](double depth, double radius) {
    return model.add(kind_of<sphere::Kind>, concatenate(trial::moved({0, 0, depth}),
                                                        trial::scaled(Vector<double>(radius))));
  };
  const NodeIndex around = ball(0, 2);
  const NodeIndex chain = model.combine(BooleanOperator::union_of, ball(2.5, 1), ball(4, 1));
  BuiltFrame<double> built(model, model.combine(BooleanOperator::union_of, around, chain));
  built.frame.database.needs.large_unions = true;
  const RayQuery<double> query = trial::unit_query<double>({0, 0, 0}, {0, 0, 1});
  const Crossing<double>* crossings = built.area().crossings;
  const std::int32_t count = cross_scene(built.frame, query, built.area().crossings);
  REQUIRE(count == 2);
  CHECK(crossings[1].distance == Approx(5));
}

TEST_CASE("What lies behind the first opaque body costs nothing") {
  Model model;
  NodeIndex row = model.add(kind_of<sphere::Kind>, trial::moved({0, 0, 5}));
  for (int i = 1; i < 40; ++i) {
    row = model.combine(BooleanOperator::union_of, row,
                        model.add(kind_of<sphere::Kind>, trial::moved({0, 0, 5.0 + 3 * i})));
  }
  BuiltFrame<double> built(model, row);
  const RayQuery<double> query = trial::unit_query<double>({0, 0, 0}, {0, 0, 1});
  built.frame.database.needs.large_unions = false;
  CHECK(cross_scene(built.frame, query, built.area().crossings) == 80);
  built.frame.database.needs.large_unions = true;
  CHECK(cross_scene(built.frame, query, built.area().crossings) == 2);
}

}  // namespace
}  // namespace maquette::firmware
