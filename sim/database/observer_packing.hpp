#pragma once

#include "firmware/database.hpp"
#include "sim/database/picture_format.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// The observer as the boards get it (paper, section V.2.3.1.1: the screen with its matrix), not
/// yet rounded. Pixels are square: where the picture's shape is not the screen's, it shows more.
[[nodiscard]] firmware::Observer<double> observer_of(const View& view, const PictureFormat& format);

}  // namespace maquette::sim
