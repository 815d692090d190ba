#pragma once

#include <string>
#include <vector>

#include "sim/accuracy/ladder.hpp"
#include "sim/machine/machine.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// Quanta of the decoupled bus unless others are asked for: from below an access (exact) to above
/// the time of a pixel.
[[nodiscard]] std::vector<std::string> default_quanta();

/// The bus by its lines, by its accesses, decoupled by each quantum (a time with its unit), and
/// ideal.
[[nodiscard]] Ladder bus_ladder(const std::vector<std::string>& quanta);

/// The name of processor_ladder, which machines may be without.
inline constexpr const char* k_processor_ladder = "processor";

/// The boards' program executed instruction by instruction, for one in `share` pixels when that
/// is more than 1; where the package is executed, the same with arithmetic by the host at its exact
/// cost; the work counted, at calibrated costs and the tables'; and the former from a record.
[[nodiscard]] Ladder processor_ladder(int share, models::ArithmeticExecution execution);

/// The picture by the firmware over `float`, as the boards have it, and over `double`.
[[nodiscard]] Ladder number_ladder();

/// How deep the tree of rays may grow, against a depth beyond which no ray has weight.
[[nodiscard]] Ladder depth_ladder(const RayTree& scene);

/// Below which weight no ray is cast, against a weight that no level of the picture can show.
[[nodiscard]] Ladder weight_ladder(const RayTree& scene);

/// How near the roots that give a ray's hits come to the exact ones, against the rounding of the
/// numbers.
[[nodiscard]] Ladder roots_ladder();

/// What the ladders are made of besides the scene.
struct LadderChoices {
  std::vector<std::string> quanta = default_quanta();  ///< of bus_ladder
  int share = 1;                                       ///< of processor_ladder
};

/// The ladders that a scene, on this machine, has something to vary for.
[[nodiscard]] std::vector<Ladder> ladders_of(const Scene& scene, const Machine& machine,
                                             const LadderChoices& choices);

/// The names of all ladders that there are.
[[nodiscard]] std::vector<std::string> ladder_names();

}  // namespace maquette::sim
