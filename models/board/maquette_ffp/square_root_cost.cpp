#include "models/board/maquette_ffp/routine_cost.hpp"

namespace maquette::models {

using namespace routine_cost;

namespace {

// A quarter of the radicand, its root of 15 bits, and the divisions that give 32 bits of it.
struct Root {
  std::uint32_t radicand = 0;
  std::uint32_t first = 0;
  std::uint32_t high = 0;
  std::uint32_t low = 0;
  std::uint32_t remainder = 0;
};

RoutineCost next(std::uint32_t bits) {
  const bool carries = low(bits) == 0xff00U;
  return words(1) + k_immediate + branch(carries) + (carries ? k_long_add : RoutineCost{}) +
         words(1) + k_return;
}

RoutineCost doubtful(const Root& root) {
  const bool exact = (root.first * root.low + root.remainder) == root.first * root.low;
  const std::uint32_t half = low(root.low) | 0x80U;
  const std::uint32_t difference = 2 * root.first - root.high;
  RoutineCost cost = words(5) + multiplication(root.first) + words(1) + branch(exact) +
                     (exact ? RoutineCost{} : k_long_add) + words(4) +
                     signed_multiplication(difference) + long_shift(2) + k_long + words(1) +
                     long_shift(1) + k_immediate + words(1) + multiplication(half) + words(1) +
                     shift(1) + words(3) + multiplication(half) + k_long;
  const std::uint64_t excess =
      (std::uint64_t{root.radicand} * 4 - std::uint64_t{root.high} * root.high) << 15U;
  const std::uint64_t product = std::uint64_t{root.high} * half;
  const std::uint32_t square = half * half >> 17U;
  const RoutineCost down = words(4) + k_return;
  const RoutineCost up = words(3) + k_taken + next(root.high << 16U | root.low);
  cost += branch(excess < product);
  if (excess < product) {
    return cost + down;
  }
  const std::uint64_t left = excess - product;
  cost += words(2) + branch(left >> 16U != 0);
  if (left >> 16U != 0) {
    return cost + up;
  }
  return cost + words(2) + branch(left <= square) + (left <= square ? down : up);
}

RoutineCost rounded(const Root& root) {
  const std::uint32_t byte = root.low & 0xffU;
  const RoutineCost cost = words(1) + branch(byte >= 0x80U);
  if (byte < 0x80U) {
    return cost + words(2) + k_return;
  }
  const bool is_doubtful = byte < 0x84U;
  return cost + words(1) + branch(is_doubtful) +
         (is_doubtful ? doubtful(root) : next(root.high << 16U | root.low));
}

// The line that gives the first root, at an even exponent or an odd one.
RoutineCost line(bool odd, std::uint32_t high_word, std::uint32_t& value) {
  if (odd) {
    value = high_word + high_word / 2 + high_word / 8 + 9895;
    return long_shift(3) + words(3) + shift(1) + words(1) + shift(2) + words(1) + k_immediate;
  }
  value = high_word + high_word / 8 + high_word / 16 + 13582;
  return long_shift(2) + words(3) + shift(3) + words(1) + shift(1) + words(1) + k_immediate;
}

}  // namespace

RoutineCost square_root_cost(std::uint32_t d7) {
  const bool special = negative(d7) || (d7 & 0xffU) == 0;
  RoutineCost cost = words(1) + branch(special);
  if (negative(d7)) {
    return cost + k_taken + words(1) + k_return;
  }
  if (d7 == 0) {
    return cost + k_not_taken + words(1) + k_not_taken + words(1) + k_return;
  }
  if (special) {
    cost += k_not_taken + words(1) + k_taken;
  }
  const bool odd = (exponent(d7) & 1U) != 0;
  Root root;
  root.radicand = mantissa(d7) >> (odd ? 3U : 2U);
  std::uint32_t value = 0;
  cost += words(1) + k_immediate + shift(1) + branch(odd) + line(odd, high(root.radicand), value);
  cost += words(1) + division(root.radicand, value) + words(1) + shift(1);
  root.first = (value + root.radicand / value) / 2;
  const std::uint32_t remainder = root.radicand % root.first << 16U;
  root.high = root.first + root.radicand / root.first;
  root.low = remainder / root.first;
  root.remainder = remainder % root.first;
  cost +=
      division(root.radicand, root.first) + words(2) + division(remainder, root.first) + words(3);
  return cost + rounded(root);
}

}  // namespace maquette::models
