#include "sim/page/run_page.hpp"

#include "sim/page/page.hpp"
#include "sim/page/run_results.hpp"
#include "sim/page/section.hpp"

namespace maquette::sim {

std::string run_page(const RunFiles& files, const std::string& data_directory) {
  const RunResults results = run_results(files, data_directory);
  std::vector<Section> sections;
  for (const RunSection& section : run_sections()) {
    const Html content = section.content(results);
    if (!content.markup.empty()) {
      sections.push_back({section.id, section.title, content});
    }
  }
  return page(results.name + ": " + results.description.scene.name + " on " +
                  results.description.machine.name,
              sections);
}

}  // namespace maquette::sim
