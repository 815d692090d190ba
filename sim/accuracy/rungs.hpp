#pragma once

#include <string>
#include <vector>

#include "sim/accuracy/rung.hpp"
#include "sim/description/scene.hpp"

namespace maquette::sim {

/// Quanta of the decoupled bus unless others are asked for: from below an access (exact) to above
/// the time of a pixel.
[[nodiscard]] std::vector<std::string> default_quanta();

/// The bus exact, decoupled by each quantum (a time with its unit), and ideal.
[[nodiscard]] Rung bus_rung(const std::vector<std::string>& quanta);

/// The picture by the firmware over `float`, as the boards have it, and over `double`.
[[nodiscard]] Rung number_rung();

/// How deep the tree of rays may grow, against a depth beyond which no ray has weight.
[[nodiscard]] Rung depth_rung(const RayTree& scene);

/// Below which weight no ray is cast, against a weight that no level of the picture can show.
[[nodiscard]] Rung weight_rung(const RayTree& scene);

/// How near the roots that give a ray's hits come to the exact ones, against the rounding of the
/// numbers.
[[nodiscard]] Rung roots_rung();

/// The rungs that a scene has something to vary for.
[[nodiscard]] std::vector<Rung> rungs_of(const Scene& scene,
                                         const std::vector<std::string>& quanta);

/// The names of all rungs that there are.
[[nodiscard]] std::vector<std::string> rung_names();

}  // namespace maquette::sim
