#pragma once

#include <type_traits>

namespace maquette::firmware {

/// The parameters of a trial solid, which has them as doubles and as floats, in one of the two.
template <class Real, class Solid>
const Real* parameters_of(const Solid& solid) {
  if constexpr (std::is_same_v<Real, double>) {
    return solid.parameters.data();
  } else {
    return solid.as_float.data();
  }
}

}  // namespace maquette::firmware
