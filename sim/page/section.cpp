#include "sim/page/section.hpp"

#include "sim/page/run_sections.hpp"

namespace maquette::sim {

const std::vector<RunSection>& run_sections() {
  static const std::vector<RunSection> sections{
      {"summary", "At a glance", summary_section},
      {"picture", "Picture", picture_section},
      {"time", "Where the time goes", time_section},
      {"units", "Function units", units_section},
      {"bus", "Bus", bus_section},
      {"work", "Rays and work", work_section},
      {"machine", "Machine", machine_section},
      {"memory", "Memory of a board", memory_section},
      {"needs", "What the scene needs", needs_section},
      {"configuration", "Configuration", configuration_section},
      {"statistics", "All statistics", statistics_section},
      {"provenance", "Provenance", provenance_section},
  };
  return sections;
}

}  // namespace maquette::sim
