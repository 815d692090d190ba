#pragma once

#include "firmware/primitives/shell.hpp"
#include "sim/primitives/revolution.hpp"

namespace maquette::sim {

/// What a generatrix sweeps about z, without discs and without thickness.
struct ShellShape {
  using Kind = firmware::shell::Kind;

  RevolutionShape generatrix;
};

/// A shell in the firmware's terms, as generatrix_frame says. The shape must be a checked one.
[[nodiscard]] LocalFrame frame_of(const ShellShape& shape);

}  // namespace maquette::sim
