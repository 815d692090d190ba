#pragma once

#include <string>

#include "sim/scene/scene.hpp"

namespace maquette::benchmark {

/// A scene in POV-Ray's language, each body as POV-Ray has it natively: of the projections the
/// perspective, of the primitives half-spaces, boxes, spheres, cylinders, cones, tori, revolutions.
/// Throws std::invalid_argument for another one.
[[nodiscard]] std::string povray_text(const sim::Scene& scene, int width, int height);

}  // namespace maquette::benchmark
