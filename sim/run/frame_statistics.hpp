#pragma once

#include "firmware/arithmetic/work.hpp"
#include "models/board/allotment.hpp"
#include "models/machine/machine_statistics.hpp"
#include "sim/machine/machine.hpp"
#include "sim/report/statistics.hpp"

namespace maquette::sim {

/// The statistics of a run from those of the models. Bus figures are those of the boards during the
/// frame; the host's loading before it shows in the load time. Throws std::logic_error when a
/// board's states do not sum to the frame time; as checked_sum for what is summed over boards.
Statistics frame_statistics(const models::MachineStatistics& model, const Machine& machine,
                            const models::PixelRectangle& useful_zone,
                            const firmware::Work& preprocessing);

}  // namespace maquette::sim
