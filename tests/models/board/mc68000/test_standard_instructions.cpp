#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

constexpr unsigned k_cases = 20'000;

/// What an instruction of two operands computes, with the condition codes as they were before.
using Law = Expected (*)(std::uint32_t destination, std::uint32_t source, unsigned codes,
                         unsigned bits);

Expected sum(std::uint32_t destination, std::uint32_t source, unsigned /*codes*/, unsigned bits) {
  return expected_sum(destination, source, 0, bits);
}

Expected difference(std::uint32_t destination, std::uint32_t source, unsigned /*codes*/,
                    unsigned bits) {
  return expected_difference(destination, source, 0, bits);
}

Expected logical(std::uint32_t result, unsigned codes, unsigned bits) {
  return {static_cast<std::uint32_t>(result & mask_of(bits)),
          (codes & 16U) | sign_and_zero(result, bits)};
}

Expected conjunction(std::uint32_t destination, std::uint32_t source, unsigned codes,
                     unsigned bits) {
  return logical(destination & source, codes, bits);
}

Expected disjunction(std::uint32_t destination, std::uint32_t source, unsigned codes,
                     unsigned bits) {
  return logical(destination | source, codes, bits);
}

Expected exclusion(std::uint32_t destination, std::uint32_t source, unsigned codes, unsigned bits) {
  return logical(destination ^ source, codes, bits);
}

void check_to_register(unsigned pattern, Law law) {
  SmallBoard board;
  Operands operands(pattern);
  for (unsigned count = 0; count < k_cases; ++count) {
    const unsigned bits = k_sizes[count % 3];
    const std::uint32_t destination = operands.next();
    const std::uint32_t source = operands.next();
    const unsigned codes = operands.below(32);
    board.set_codes(codes);
    board.d(3) = destination;
    board.d(5) = source;
    board.execute({pattern | 3U << 9U | size_code(bits) | 5U});
    const Expected expected = law(destination, source, codes, bits);
    REQUIRE(board.d(3) == replaced(destination, expected.result, bits));
    REQUIRE(board.d(5) == source);
    REQUIRE(board.codes() == expected.codes);
  }
}

void check_to_memory(unsigned pattern, Law law) {
  SmallBoard board;
  Operands operands(pattern);
  constexpr std::uint32_t address = 0x4000;
  for (unsigned count = 0; count < k_cases; ++count) {
    const unsigned bits = k_sizes[count % 3];
    const std::uint32_t destination = operands.next();
    const std::uint32_t source = operands.next();
    const unsigned codes = operands.below(32);
    board.set_codes(codes);
    board.poke(address, bits / 8, destination);
    board.a(2) = address;
    board.d(1) = source;
    board.execute({pattern | 1U << 9U | 0x100U | size_code(bits) | 0x12U});
    const Expected expected = law(destination, source, codes, bits);
    REQUIRE(board.peek(address, bits / 8) == expected.result);
    REQUIRE(board.codes() == expected.codes);
  }
}

TEST_CASE("ADD gives the exact sum and its codes") {
  check_to_register(0xd000, sum);
  check_to_memory(0xd000, sum);
}

TEST_CASE("SUB gives the exact difference and its codes") {
  check_to_register(0x9000, difference);
  check_to_memory(0x9000, difference);
}

TEST_CASE("AND, OR and EOR work bit by bit, keep X and clear V and C") {
  check_to_register(0xc000, conjunction);
  check_to_memory(0xc000, conjunction);
  check_to_register(0x8000, disjunction);
  check_to_memory(0x8000, disjunction);
  check_to_memory(0xb000, exclusion);
}

TEST_CASE("CMP changes nothing but N, Z, V and C") {
  SmallBoard board;
  Operands operands(1);
  for (unsigned count = 0; count < k_cases; ++count) {
    const unsigned bits = k_sizes[count % 3];
    const std::uint32_t destination = operands.next();
    const std::uint32_t source = operands.next();
    const unsigned codes = operands.below(32);
    board.set_codes(codes);
    board.d(0) = destination;
    board.d(7) = source;
    board.execute({0xb000U | size_code(bits) | 7U});
    const Expected expected = expected_difference(destination, source, 0, bits);
    REQUIRE(board.d(0) == destination);
    REQUIRE(board.codes() == ((codes & 16U) | (expected.codes & 15U)));
  }
}

TEST_CASE("all sums and differences of two bytes") {
  SmallBoard board;
  for (unsigned pair = 0; pair < 0x10000; ++pair) {
    board.d(0) = pair >> 8U;
    board.d(1) = pair & 0xffU;
    board.execute({0xd001});
    const Expected sum_of_pair = expected_sum(pair >> 8U, pair & 0xffU, 0, 8);
    REQUIRE((board.d(0) << 8U | board.codes()) == (sum_of_pair.result << 8U | sum_of_pair.codes));
    board.d(0) = pair >> 8U;
    board.execute({0x9001});
    const Expected rest = expected_difference(pair >> 8U, pair & 0xffU, 0, 8);
    REQUIRE((board.d(0) << 8U | board.codes()) == (rest.result << 8U | rest.codes));
  }
}

}  // namespace
