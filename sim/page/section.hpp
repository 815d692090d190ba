#pragma once

#include <string>
#include <vector>

#include "sim/page/html.hpp"
#include "sim/page/run_results.hpp"

namespace maquette::sim {

/// A section of a page, as the list at its beginning names it.
struct Section {
  std::string id;
  std::string title;
  Html content;
};

/// What a page tells of a run, part by part; nothing is shown where the content is empty.
struct RunSection {
  const char* id;
  const char* title;
  Html (*content)(const RunResults& results);
};

/// All sections of a run, in their order: adding one is a file and a row.
[[nodiscard]] const std::vector<RunSection>& run_sections();

}  // namespace maquette::sim
