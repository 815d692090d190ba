#include "sim/page/assets.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"

namespace maquette::sim {

Html provenance_section(const RunResults& results) {
  const Provenance& provenance = results.provenance;
  PageTable inputs{"Files that were read", {{"file"}, {"SHA-1"}}, {}};
  for (const InputDigest& input : provenance.inputs) {
    inputs.rows.push_back({input.path, input.sha1});
  }
  return definitions(
             {{"Program", "maquette " + provenance.version + ", revision " + provenance.revision},
              {"Command", command_line(provenance)},
              {"Again",
               "maquette run config.yaml, which is among the results, gives the same "
               "bytes"}}) +
         table_element(inputs) +
         folded("Licence of Chart.js, which draws the plots",
                element("pre", asset("chart_licence.txt")));
}

}  // namespace maquette::sim
