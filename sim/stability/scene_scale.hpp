#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.hpp"
#include "sim/stability/shipped_scenes.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// The scene in a world that is so many times larger: eye, lights, absorption lengths and all. Its
/// picture is the same.
[[nodiscard]] Scene scaled(Scene scene, double scale);

/// Pictures of a scene scaled from 1e-5 to 1e5 against its own: the most pixels that differ by more
/// than one level, and by any at powers of two, which round nothing.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> scale_rows(const ShippedScene& shipped, int width);

}  // namespace maquette::sim
