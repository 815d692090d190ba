#include "sim/record/function_work.hpp"

#include <random>

#include "firmware/arithmetic/counted.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

FunctionWork random_work(std::mt19937& random, std::size_t ray_kinds) {
  FunctionWork work;
  work.reach(ray_kinds);
  for (FunctionWork::Counts& cell : work.cells) {
    cell[random() % cell.size()] = random() % 3;
  }
  for (std::uint64_t& roots : work.intersection_roots) {
    roots = random() % 3;
  }
  work.extents[random() % work.extents.size()].hits = random();
  return work;
}

}  // namespace

TEST_CASE("Work is read as it was written, for any number of kinds of rays") {
  std::mt19937 random(411);
  for (std::size_t kinds = 1; kinds <= firmware::k_ray_kind_count; ++kinds) {
    const FunctionWork work = random_work(random, kinds);
    FunctionWork read;
    REQUIRE(read_numbers(numbers_of(work), read));
    CHECK(numbers_of(read) == numbers_of(work));
    CHECK(read.ray_kinds() <= kinds);
  }
}

TEST_CASE("Numbers of more kinds of rays than there are, or out of order, are none") {
  FunctionWork work;
  work.reach(firmware::k_ray_kind_count);
  work.cells.back().back() = 1;
  std::vector<std::uint64_t> numbers = numbers_of(work);
  FunctionWork read;
  REQUIRE(read_numbers(numbers, read));
  CHECK(read.cells.back().back() == 1);
  ++numbers.front();
  CHECK_FALSE(read_numbers(numbers, read));
  CHECK_FALSE(read_numbers({~std::uint64_t{0}, 1}, read));
  CHECK_FALSE(read_numbers({5, 1, 4, 1}, read));
  CHECK_FALSE(read_numbers({5}, read));
}

TEST_CASE("Sums reach as far as the farther of both") {
  std::mt19937 random(7);
  const FunctionWork few = random_work(random, 2);
  const FunctionWork many = random_work(random, 40);
  FunctionWork one = few;
  one.add(many);
  FunctionWork other = many;
  other.add(few);
  CHECK(numbers_of(one) == numbers_of(other));
  CHECK(one.ray_kinds() == 40);
}

TEST_CASE("Each of sixty lights has work of its own") {
  firmware::reset_counted_work();
  for (int light = 0; light < 60; ++light) {
    const firmware::InRay<firmware::Counted> ray(firmware::shadow_of(light));
    firmware::counting::count(firmware::Operation::light, static_cast<std::uint32_t>(1 + light));
  }
  FunctionWork work;
  work.add(firmware::counted_meter);
  firmware::reset_counted_work();
  const auto function = static_cast<std::size_t>(firmware::Function::pixel);
  for (int light = 0; light < 60; ++light) {
    const auto kind = static_cast<std::size_t>(firmware::shadow_of(light));
    CHECK(work.cells[FunctionWork::cell(kind, function)][static_cast<std::size_t>(
              firmware::Operation::light)] == static_cast<std::uint64_t>(1 + light));
  }
}

}  // namespace maquette::sim
