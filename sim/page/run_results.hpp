#pragma once

#include <string>
#include <vector>

#include "sim/maps/map_reading.hpp"
#include "sim/page/provenance.hpp"
#include "sim/page/run_files.hpp"
#include "sim/report/statistics.hpp"
#include "sim/scene/description_loader.hpp"

namespace maquette::sim {

/// All that a page tells of one run.
struct RunResults {
  std::string name;  ///< of the run: its directory's
  Statistics statistics;
  Description description;  ///< as it was simulated
  Machine prototype;        ///< the shipped ccett-1984, to tell what differs from it
  Provenance provenance;
  std::string frame_png;
  std::vector<NamedContent> snapshots;  ///< PNG files
  ReadMaps maps;                        ///< of the pixels; none where the run wrote none
};

/// Reads the results of a run; `data_directory` holds the shipped machine. Throws DescriptionError,
/// with the place in the file, for results that are missing or damaged.
[[nodiscard]] RunResults run_results(const RunFiles& files, const std::string& data_directory);

}  // namespace maquette::sim
