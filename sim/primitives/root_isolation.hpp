#pragma once

#include "firmware/polynomials/real_roots.hpp"
#include "sim/primitives/board_call.hpp"

namespace maquette::sim {

/// What isolates the real roots of polynomials, for the primitives that do.
inline constexpr Recursion k_root_isolation{"real_roots::isolate",
                                            firmware::real_roots::k_bisection_limit<float> + 1};

}  // namespace maquette::sim
