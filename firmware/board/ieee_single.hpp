#pragma once

#include "firmware/board/number.hpp"

/// The numbers of a board's program in IEEE single precision, where they are a float's bits.
namespace maquette::firmware {

using BoardNumber = Number<IeeeSingleFormat>;

template <>
struct elementary::Format<BoardNumber> : elementary::Format<float> {};

}  // namespace maquette::firmware
