#include <fmt/format.h>

#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"
#include "sim/report/scalar_statistics.hpp"

namespace maquette::sim {

Html statistics_section(const RunResults& results) {
  PageTable table{"Every statistic that is a single value, as stats.json has it",
                  {{"statistic"}, {"value", true}, {"unit"}, {"meaning"}},
                  {}};
  table.is_long = true;
  for (const ScalarStatistic& statistic : scalar_statistics(results.statistics)) {
    if (!statistic.text.empty()) {
      table.rows.push_back({statistic.name, statistic.text,
                            statistic.unit == "1" ? "" : statistic.unit, statistic.sentence});
    }
  }
  return folded(fmt::format("All {} statistics, exact", table.rows.size()), table_element(table));
}

}  // namespace maquette::sim
