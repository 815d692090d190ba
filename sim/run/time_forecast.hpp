#pragma once

#include <functional>

#include "models/board/board_share.hpp"
#include "models/machine/ccett_machine.hpp"
#include "sim/machine/machine.hpp"
#include "sim/record/recorded_frame.hpp"

namespace maquette::sim {

/// The work of the pixel at a position.
using WorkAt = std::function<firmware::Work(const models::PixelPosition& position)>;

/// How long a board is likely to compute, in seconds, as some pixels that are spread over the zone
/// tell.
[[nodiscard]] double likely_computing_s(const Machine& machine, const models::PixelRectangle& zone,
                                        const firmware::Work& preprocessing, const WorkAt& work);

/// Whether that is a quarter of the longest simulated time or more; then the whole frame is worth a
/// look before it is simulated.
[[nodiscard]] bool may_take_long(double likely_s);

/// Throws DescriptionError when a board would compute on this frame for more than the longest
/// simulated time, which says the board and how long.
void require_computing_time(const Machine& machine, const RecordedFrame& frame);

/// Throws DescriptionError when the host would load, or the bus transfer the pixels, for more than
/// the longest simulated time, which says how long.
void require_transfer_time(const Machine& machine, const models::FrameSetup& setup);

}  // namespace maquette::sim
