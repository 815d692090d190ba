#pragma once

/// How many steps of Laguerre's method each root of an intersection takes (paper, section IV.2.4),
/// where work is counted.
namespace maquette::firmware {

/// No root takes more.
inline constexpr int k_root_step_limit = 64;

template <class Real>
struct RootSteps {
  /// Takes down a root that was refined in so many steps. Only `Counted` does.
  [[gnu::always_inline]] static constexpr void note(int /*steps*/) {}
};

}  // namespace maquette::firmware
