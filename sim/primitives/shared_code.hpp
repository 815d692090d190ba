#pragma once

#include "firmware/polynomials/real_roots.hpp"
#include "sim/primitives/board_call.hpp"

/// Code of the board's program that several primitives call.
namespace maquette::sim {

/// Of what isolates and refines the real roots of polynomials.
inline constexpr CodeName k_root_code[] = {"bisect",       "real_roots::", "laguerre::",
                                           "bernstein::",  "roots_of",     "polynomial_of",
                                           "sign_changes", "sign_of"};

/// Of chains of plane cubics.
inline constexpr CodeName k_plane_cubic_code[] = {
    "curve_point", "nearest_parameter", "value_at", "change_at", "polygon_of", "times_derivative"};

/// Of what puts hits in order.
inline constexpr CodeName k_hit_order_code[] = {"sort"};

/// How deep the isolation of roots calls itself.
inline constexpr int k_isolation_depth = firmware::real_roots::k_bisection_limit<float> + 1;

}  // namespace maquette::sim
