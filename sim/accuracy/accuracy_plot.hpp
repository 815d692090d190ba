#pragma once

#include <string>
#include <vector>

#include "sim/accuracy/ladder_result.hpp"

namespace maquette::sim {

/// A plot of one ladder, by the name of its files.
struct AccuracyPlot {
  std::string name;
  std::string script;  ///< of gnuplot
};

/// Error over host time for each ladder, and over simulated time where the levels have one. An
/// error of zero, which a logarithmic axis cannot hold, stands below all others at a tic of its
/// own.
[[nodiscard]] std::vector<AccuracyPlot> accuracy_plots(const std::vector<LadderResult>& results);

}  // namespace maquette::sim
