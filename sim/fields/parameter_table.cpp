#include "sim/fields/parameter_table.hpp"

#include <algorithm>

namespace maquette::sim {

std::vector<ParameterRow> with_defaults(std::vector<ParameterRow> rows,
                                        const std::vector<ParameterRow>& defaults) {
  for (ParameterRow& row : rows) {
    const auto found =
        std::find_if(defaults.begin(), defaults.end(),
                     [&](const ParameterRow& other) { return other.path == row.path; });
    if (found != defaults.end() && !row.required) {
      row.default_value = found->value;
    }
  }
  return rows;
}

}  // namespace maquette::sim
