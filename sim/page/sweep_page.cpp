#include "sim/page/sweep_page.hpp"

#include "sim/page/page.hpp"
#include "sim/page/point_section.hpp"
#include "sim/page/study_elements.hpp"

namespace maquette::sim {

std::string sweep_page(const std::filesystem::path& directory) {
  return page(study_name(directory) + ": a sweep",
              with_plots({{"points", "Points",
                           csv_element("Points of the sweep", directory / "table.csv", true)},
                          {"point", "A point", point_section(directory)}},
                         {directory / "plots"}));
}

}  // namespace maquette::sim
