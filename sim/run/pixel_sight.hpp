#pragma once

#include "firmware/ray_tree.hpp"
#include "models/board/pixel_rectangle.hpp"
#include "sim/maps/pixel_facts.hpp"

namespace maquette::sim {

/// What is seen through the centre of a pixel, and how deep the tree of its rays is. Of a scene
/// with several rays per pixel, the tree of the ray through the centre.
PixelSight pixel_sight(const firmware::Frame<float>& frame, const firmware::WorkArea<float>& area,
                       const models::PixelPosition& position);

}  // namespace maquette::sim
