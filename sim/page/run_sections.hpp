#pragma once

#include "sim/page/html.hpp"
#include "sim/page/run_results.hpp"

/// The sections of a run's page, each in a file of its name.
namespace maquette::sim {

[[nodiscard]] Html summary_section(const RunResults& results);
[[nodiscard]] Html picture_section(const RunResults& results);
[[nodiscard]] Html time_section(const RunResults& results);
[[nodiscard]] Html units_section(const RunResults& results);
[[nodiscard]] Html bus_section(const RunResults& results);
[[nodiscard]] Html work_section(const RunResults& results);
[[nodiscard]] Html machine_section(const RunResults& results);
[[nodiscard]] Html memory_section(const RunResults& results);
[[nodiscard]] Html needs_section(const RunResults& results);
[[nodiscard]] Html configuration_section(const RunResults& results);
[[nodiscard]] Html statistics_section(const RunResults& results);
[[nodiscard]] Html provenance_section(const RunResults& results);

}  // namespace maquette::sim
