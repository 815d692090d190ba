#pragma once

#include <cstdint>
#include <random>

/// What instructions compute, from whole numbers that are wide enough for every result.
namespace maquette::tests {

/// A result and the condition codes X N Z V C as bits 4 to 0.
struct Expected {
  std::uint32_t result;
  unsigned codes;
};

inline std::uint64_t mask_of(unsigned bits) { return (std::uint64_t{1} << bits) - 1; }

/// The number that the low bits stand for in two's complement.
inline std::int64_t signed_value(std::uint64_t value, unsigned bits) {
  const std::uint64_t low = value & mask_of(bits);
  const bool negative = (low >> (bits - 1)) != 0;
  return static_cast<std::int64_t>(low) - (negative ? std::int64_t{1} << bits : 0);
}

inline bool fits_signed(std::int64_t value, unsigned bits) {
  return value == signed_value(static_cast<std::uint64_t>(value), bits);
}

/// N and Z of a result.
inline unsigned sign_and_zero(std::uint64_t result, unsigned bits) {
  return (signed_value(result, bits) < 0 ? 8U : 0U) | ((result & mask_of(bits)) == 0 ? 4U : 0U);
}

/// Of exact results, unsigned and signed, in so many bits; X is C.
inline Expected expected_of(std::int64_t exact, std::int64_t exact_signed, unsigned bits) {
  const std::uint64_t result = static_cast<std::uint64_t>(exact) & mask_of(bits);
  const bool carry = exact < 0 || exact > static_cast<std::int64_t>(mask_of(bits));
  return {static_cast<std::uint32_t>(result), (carry ? 17U : 0U) | sign_and_zero(result, bits) |
                                                  (fits_signed(exact_signed, bits) ? 0U : 2U)};
}

inline Expected expected_sum(std::uint64_t a, std::uint64_t b, unsigned carry, unsigned bits) {
  return expected_of(static_cast<std::int64_t>((a & mask_of(bits)) + (b & mask_of(bits)) + carry),
                     signed_value(a, bits) + signed_value(b, bits) + carry, bits);
}

inline Expected expected_difference(std::uint64_t a, std::uint64_t b, unsigned borrow,
                                    unsigned bits) {
  return expected_of(static_cast<std::int64_t>(a & mask_of(bits)) -
                         static_cast<std::int64_t>(b & mask_of(bits)) - borrow,
                     signed_value(a, bits) - signed_value(b, bits) - borrow, bits);
}

/// Replaces the low bits.
inline std::uint32_t replaced(std::uint32_t whole, std::uint64_t low, unsigned bits) {
  return static_cast<std::uint32_t>((whole & ~mask_of(bits)) | (low & mask_of(bits)));
}

/// Operands with many of those where arithmetic turns.
class Operands {
 public:
  explicit Operands(unsigned seed) : random_(seed) {}

  std::uint32_t next() {
    constexpr std::uint32_t turns[] = {0,          1,          0x7f,       0x80,
                                       0xff,       0x7fff,     0x8000,     0xffff,
                                       0x7fffffff, 0x80000000, 0xffff0000, 0xffffffff};
    const std::uint32_t choice = below(24);
    const std::uint32_t value = choice < 12 ? turns[choice] : draw();
    return below(4) == 0 ? value + below(3) - 1 : value;
  }

  std::uint32_t below(std::uint32_t limit) { return draw() % limit; }

 private:
  std::uint32_t draw() { return static_cast<std::uint32_t>(random_()); }

  std::mt19937 random_;
};

constexpr unsigned k_sizes[] = {8, 16, 32};

/// The size field of most instructions.
inline unsigned size_code(unsigned bits) { return bits == 8 ? 0 : (bits == 16 ? 0x40 : 0x80); }

}  // namespace maquette::tests
