#include "firmware/arithmetic/counted.hpp"

#include <algorithm>
#include <iterator>
#include <thread>

#include "tests/catch.hpp"
#include "tests/firmware/random_model.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Random;

/// The work of a piece of arithmetic.
template <class Function>
Work work_of(const Function& function) {
  reset_counted_work();
  function();
  return counted_work();
}

struct Count {
  Operation operation;
  std::uint32_t times;
};

/// Whether the work is exactly this.
bool is_exactly(const Work& work, std::initializer_list<Count> counts) {
  Work expected{};
  for (const Count& count : counts) {
    expected[count.operation] = count.times;
  }
  return std::memcmp(&work, &expected, sizeof work) == 0;
}

/// Keeps a result alive.
void use(Counted value) {
  volatile float sink = value.value;
  static_cast<void>(sink);
}

TEST_CASE("An expression counts what stands in it") {
  const Counted a = 3.0F;
  const Counted b = 4.0F;
  const Counted zero = 0.0F;
  CHECK(is_exactly(work_of([&] { use(square_root(a * a + b * b)); }),
                   {{Operation::multiply, 2}, {Operation::add, 1}, {Operation::square_root, 1}}));
  CHECK(is_exactly(work_of([&] { use((a - b) / -b); }),
                   {{Operation::subtract, 1}, {Operation::divide, 1}, {Operation::negate, 1}}));
  CHECK(is_exactly(work_of([&] { use(smaller(a, larger(b, absolute(a)))); }),
                   {{Operation::compare, 2}, {Operation::absolute, 1}}));
  CHECK(is_exactly(work_of([&] { use(a + zero); }), {{Operation::add_zero, 1}}));
  CHECK(is_exactly(work_of([&] { use(-zero + b); }),
                   {{Operation::add_zero, 1}, {Operation::negate, 1}}));
  CHECK(is_exactly(work_of([&] { use(zero - a); }), {{Operation::subtract_zero, 1}}));
  CHECK(is_exactly(work_of([&] { use(a * zero); }), {{Operation::multiply_zero, 1}}));
  CHECK(is_exactly(work_of([&] { use(zero / a); }), {{Operation::divide_zero, 1}}));
  CHECK(is_exactly(work_of([&] { use(a - a); }), {{Operation::subtract, 1}}));
  CHECK(is_exactly(work_of([&] { use(power(a, b)); }), {{Operation::power, 1}}));
  CHECK(is_exactly(work_of([&] { use(from_integer<Counted>(to_integer(a))); }),
                   {{Operation::integer_to_float, 1}, {Operation::float_to_integer, 1}}));
}

TEST_CASE("Assignments count as their operators do") {
  const Counted b = 4.0F;
  Counted a = 3.0F;
  CHECK(is_exactly(work_of([&] {
                     a += b;
                     a -= b;
                     a *= b;
                     a /= b;
                   }),
                   {{Operation::add, 1},
                    {Operation::subtract, 1},
                    {Operation::multiply, 1},
                    {Operation::divide, 1}}));
  CHECK(a.value == 3.0F);
}

TEST_CASE("Vectors count component by component") {
  Random random(1201);
  for (int i = 0; i < 2000; ++i) {
    const auto value = [&random] {
      return Counted(random.coin() ? 0.0F : static_cast<float>(random.uniform(-2, 2)));
    };
    const Vector<Counted> a(value(), value(), value());
    const Vector<Counted> b(value(), value(), value());
    const Counted s = value();
    Vector<Counted> whole[4];
    Vector<Counted> parts[4];
    const Work of_vectors = work_of([&] {
      whole[0] = a + b;
      whole[1] = a - b;
      whole[2] = a * b;
      whole[3] = a * s;
    });
    const Work of_components = work_of([&] {
      parts[0] = {a.x + b.x, a.y + b.y, a.z + b.z};
      parts[1] = {a.x - b.x, a.y - b.y, a.z - b.z};
      parts[2] = {a.x * b.x, a.y * b.y, a.z * b.z};
      parts[3] = {a.x * s, a.y * s, a.z * s};
    });
    REQUIRE(std::memcmp(&of_vectors, &of_components, sizeof of_vectors) == 0);
    REQUIRE(std::memcmp(whole, parts, sizeof whole) == 0);
  }
}

TEST_CASE("A scalar product counts three products and two sums") {
  const Vector<Counted> a(1.0F, 2.0F, 3.0F);
  CHECK(is_exactly(work_of([&] { use(glm::dot(a, a)); }),
                   {{Operation::multiply, 3}, {Operation::add, 2}}));
}

Model lively_model() {
  Model model;
  model.surfaces = {trial::matt_surface({0.7, 0.5, 0.3}), trial::mirror_surface(),
                    trial::glass_surface(1.5, {0.1, 0.2, 0.3})};
  model.surfaces[0].specular = 0.3;
  model.lights = {{{30, 50, 0}, {0.8, 0.8, 0.8}}, {{-30, 20, 10}, {0.3, 0.3, 0.3}}};
  model.ambient = {0.1, 0.1, 0.1};
  model.background = {0.2, 0.3, 0.4};
  return model;
}

TEST_CASE("Pixels have the same bits counted or not, and the same work each time") {
  Random random(1202);
  for (int trial = 0; trial < 25; ++trial) {
    const auto tree =
        trial::random_tree(random, lively_model(), 1 + random.below(8), {0, 0, 20}, 10);
    BuiltFrame<float> plain(tree.model, tree.root);
    BuiltFrame<Counted> counted(tree.model, tree.root);
    for (std::int16_t row = 0; row < tree.model.rows; row = static_cast<std::int16_t>(row + 5)) {
      for (std::int16_t column = 0; column < tree.model.columns;
           column = static_cast<std::int16_t>(column + 3)) {
        Sight<float> plain_sight;
        Sight<Counted> counted_sight;
        const Color<float> a = luminance(
            plain.frame, primary_ray(plain.frame.database, column, row), plain.area(), plain_sight);
        const Color<Counted> b =
            luminance(counted.frame, primary_ray(counted.frame.database, column, row),
                      counted.area(), counted_sight);
        REQUIRE(std::memcmp(&a, &b, sizeof a) == 0);
        const Work once = work_of([&] { counted.pixel(column, row); });
        const Work again = work_of([&] { counted.pixel(column, row); });
        REQUIRE(std::memcmp(&once, &again, sizeof once) == 0);
      }
    }
  }
}

TEST_CASE("Every thread counts for itself") {
  reset_counted_work();
  const Counted a = 2.0F;
  use(a + a);
  Work of_thread{};
  std::thread other([&of_thread, a] {
    use(a * a);
    of_thread = counted_work();
  });
  other.join();
  CHECK(is_exactly(of_thread, {{Operation::multiply, 1}}));
  CHECK(is_exactly(counted_work(), {{Operation::add, 1}}));
}

/// The counts of a cell of this thread's meter.
Work in_cell(RayKind ray, Function function) {
  Work work{};
  const std::uint32_t wanted =
      static_cast<std::uint32_t>(ray) * k_function_count + static_cast<std::uint32_t>(function);
  counted_meter.for_each_cell([&](std::uint32_t cell, const std::uint64_t* counts) {
    if (cell == wanted) {
      std::copy_n(counts, k_operation_count, std::begin(work.counts));
    }
  });
  return work;
}

TEST_CASE("Work belongs to the innermost function and ray in whose block it is done") {
  reset_counted_work();
  const Counted a = 2.0F;
  {
    const InFunction<Counted> outer(Function::photometry);
    use(a + a);
    {
      const InRay<Counted> ray(shadow_of(1));
      const InFunction<Counted> inner(Function::extents);
      use(a * a);
    }
    use(a - a);
  }
  use(a / a);
  CHECK(is_exactly(in_cell(RayKind::primary, Function::photometry),
                   {{Operation::add, 1}, {Operation::subtract, 1}}));
  CHECK(is_exactly(in_cell(shadow_of(1), Function::extents), {{Operation::multiply, 1}}));
  CHECK(is_exactly(in_cell(RayKind::primary, Function::pixel), {{Operation::divide, 1}}));
  CHECK(is_exactly(counted_work(), {{Operation::add, 1},
                                    {Operation::subtract, 1},
                                    {Operation::multiply, 1},
                                    {Operation::divide, 1}}));
}

TEST_CASE("Roots are told by their steps in intersections alone, until a reset") {
  reset_counted_work();
  RootSteps<Counted>::note(3);
  {
    const InRay<Counted> ray(RayKind::reflected);
    const InFunction<Counted> intersection(Function::intersection);
    RootSteps<Counted>::note(k_root_step_limit);
    RootSteps<Counted>::note(2);
    RootSteps<Counted>::note(2);
    const InFunction<Counted> points(Function::points);
    RootSteps<Counted>::note(2);
  }
  CHECK(counted_meter.intersection_roots[2] == 2);
  CHECK(counted_meter.intersection_roots[3] == 0);
  CHECK(counted_meter.intersection_roots[k_root_step_limit] == 1);
  CHECK(counted_meter.root_steps_end == k_root_step_limit + 1);
  reset_counted_work();
  for (const std::uint32_t roots : counted_meter.intersection_roots) {
    CHECK(roots == 0);
  }
}

TEST_CASE("A reset empties every cell, and lights without an own place share the last") {
  reset_counted_work();
  const Counted a = 2.0F;
  for (int light = 0; light < 2 * k_told_lights; ++light) {
    const InRay<Counted> ray(shadow_of(light));
    use(a + a);
  }
  CHECK(is_exactly(in_cell(shadow_of(0), Function::pixel), {{Operation::add, 1}}));
  CHECK(is_exactly(in_cell(shadow_of(k_told_lights), Function::pixel),
                   {{Operation::add, 1 + k_told_lights}}));
  reset_counted_work();
  CHECK(is_exactly(counted_work(), {}));
  CHECK(is_exactly(in_cell(shadow_of(0), Function::pixel), {}));
}

}  // namespace

TEST_CASE("Counts go beyond 32 bits, which a pixel's must not") {
  reset_counted_work();
  charge<Counted>(Operation::node, 0xFFFFFFFF);
  CHECK(counted_work()[Operation::node] == 0xFFFFFFFF);
  charge<Counted>(Operation::node);
  CHECK(long_counted_work()[Operation::node] == std::uint64_t{1} << 32U);
  CHECK_THROWS_WITH(counted_work(),
                    Catch::Matchers::ContainsSubstring("takes 4294967296 of `node`") &&
                        Catch::Matchers::ContainsSubstring("smaller ray_tree.depth"));
  reset_counted_work();
  CHECK(is_exactly(counted_work(), {}));
}

}  // namespace maquette::firmware
