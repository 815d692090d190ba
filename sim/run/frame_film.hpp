#pragma once

#include <vector>

#include "models/display/shown_picture.hpp"
#include "models/machine/ccett_machine.hpp"

namespace maquette::sim {

/// How the frame memory was filled: enough to show it at any instant.
struct FrameFilm {
  models::Picture background;
  std::vector<models::PixelWriteRecord> writes;
  models::VideoTiming timing;
  models::Instant start;  ///< of the frame
  models::Duration frame_time;
};

/// That of a model which has kept a log.
FrameFilm film_of(const models::CcettMachine& model);

/// The instants of a film from the frame's start: every `step`, or `pictures` alike where there is
/// no step; the last one is the frame's end. Throws std::invalid_argument for more than 10000.
std::vector<models::Duration> film_instants(models::Duration frame_time, models::Duration step,
                                            int pictures);

/// What the video reader shows at an instant from the frame's start. As fields: the lines alone
/// that it is scanning then, the others black.
models::Picture film_picture(const FrameFilm& film, models::Duration instant, bool as_fields);

}  // namespace maquette::sim
