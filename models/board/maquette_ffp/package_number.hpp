#pragma once

#include <cstdint>
#include <limits>

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/arithmetic/maquette_ffp/format.hpp"

namespace maquette::models {

/// What a host thread's `PackageNumber`s have taken so far.
struct PackageMeter {
  std::uint64_t calls = 0;
  std::uint64_t cycles = 0;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

/// This thread's meter, because operators have no place for a parameter.
PackageMeter& package_meter();

/// A number type of the firmware whose arithmetic is done by the package, executed on an MC68000.
/// Constants and conversions of integers cost nothing.
struct PackageNumber {
  std::uint32_t bits;  // of the FFP format

  PackageNumber() = default;
  PackageNumber(float value)  // NOLINT(google-explicit-constructor)
      : bits(firmware::maquette_ffp::to_ffp(value)) {}
  PackageNumber(int value)  // NOLINT(google-explicit-constructor)
      : PackageNumber(static_cast<float>(value)) {}
};

inline float value_of(PackageNumber number) {
  return firmware::maquette_ffp::from_ffp(number.bits);
}

PackageNumber operator+(PackageNumber a, PackageNumber b);
PackageNumber operator-(PackageNumber a, PackageNumber b);
PackageNumber operator*(PackageNumber a, PackageNumber b);
PackageNumber operator/(PackageNumber a, PackageNumber b);
PackageNumber operator-(PackageNumber a);
bool operator<(PackageNumber a, PackageNumber b);
bool operator<=(PackageNumber a, PackageNumber b);

inline bool operator>(PackageNumber a, PackageNumber b) { return b < a; }
inline bool operator>=(PackageNumber a, PackageNumber b) { return b <= a; }
inline PackageNumber& operator*=(PackageNumber& a, PackageNumber b) { return a = a * b; }

PackageNumber square_root(PackageNumber a);
std::int32_t to_integer(PackageNumber a);

}  // namespace maquette::models

template <>
class std::numeric_limits<maquette::models::PackageNumber> : public std::numeric_limits<float> {
 public:
  static maquette::models::PackageNumber min() { return 0x1p-65F; }
  static maquette::models::PackageNumber max() { return 0x1p63F; }
};

namespace maquette::firmware::elementary {

/// As many terms as a float needs, whose mantissa this is.
template <>
struct Format<models::PackageNumber> : Format<float> {
  static constexpr int bias = 64;
};

template <>
inline models::PackageNumber power_of_two<models::PackageNumber>(int n) {
  models::PackageNumber result;
  result.bits = 0x80000000U | static_cast<std::uint32_t>(n + 65);
  return result;
}

template <>
inline models::PackageNumber split<models::PackageNumber>(models::PackageNumber value,
                                                          int& exponent) {
  exponent = static_cast<int>(value.bits & 0x7fU) - 65;
  models::PackageNumber mantissa;
  mantissa.bits = (value.bits & 0xffffff00U) | 65U;
  if (mantissa > constant<models::PackageNumber>(1.41421356237309504880)) {
    mantissa *= constant<models::PackageNumber>(0.5);
    ++exponent;
  }
  return mantissa;
}

}  // namespace maquette::firmware::elementary
