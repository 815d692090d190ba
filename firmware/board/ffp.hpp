#pragma once

#include "firmware/arithmetic/maquette_ffp/elementary_format.hpp"
#include "firmware/board/number.hpp"

/// The numbers of a board's program in the FFP format (maquette_ffp/).
namespace maquette::firmware {

using BoardNumber = Number<FfpFormat>;

namespace elementary {

template <>
struct Format<BoardNumber> : maquette_ffp::ElementaryFormat {};

template <>
inline BoardNumber power_of_two<BoardNumber>(int n) {
  return maquette_ffp::power_of_two<BoardNumber>(n);
}

template <>
inline BoardNumber split<BoardNumber>(BoardNumber value, int& exponent) {
  return maquette_ffp::split(value, exponent);
}

}  // namespace elementary

}  // namespace maquette::firmware

template <>
class std::numeric_limits<maquette::firmware::BoardNumber>
    : public maquette::firmware::maquette_ffp::Limits {};
