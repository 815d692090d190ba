#pragma once

#include <cstdint>

#include "firmware/arithmetic/maquette_ffp/elementary_format.hpp"
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

  static PackageNumber of_bits(std::uint32_t bits) {
    PackageNumber number;
    number.bits = bits;
    return number;
  }
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
class std::numeric_limits<maquette::models::PackageNumber>
    : public maquette::firmware::maquette_ffp::Limits {};

namespace maquette::firmware::elementary {

template <>
struct Format<models::PackageNumber> : maquette_ffp::ElementaryFormat {};

template <>
inline models::PackageNumber power_of_two<models::PackageNumber>(int n) {
  return maquette_ffp::power_of_two<models::PackageNumber>(n);
}

template <>
inline models::PackageNumber split<models::PackageNumber>(models::PackageNumber value,
                                                          int& exponent) {
  return maquette_ffp::split(value, exponent);
}

}  // namespace maquette::firmware::elementary
