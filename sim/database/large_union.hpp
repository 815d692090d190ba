#pragma once

#include <cstddef>

#include "sim/database/object_tree.hpp"

namespace maquette::sim {

/// Boxes pay for what they save only where many bodies stand behind one another, of which a ray
/// then sees the first: measured on random unions of spheres and boxes, whose board time and host
/// time boxes lower from 4 and 2 bodies on a line on. Between, neither loses more than a fifth.
inline constexpr double k_bodies_on_a_line = 2.75;

/// Fewer are not worth the code for it, which takes as much of a board's RAM as some of them.
inline constexpr std::size_t k_fewest_in_boxes = 256;

/// From so many on the host is faster with boxes also where bodies are scattered: they are smaller
/// than what rectangles of pixels, and the spheres around large nodes, tell apart. Boards, which do
/// not hold so many, would be so only from ten times as many on, and lose up to half there.
inline constexpr std::size_t k_always_in_boxes = 1024;

/// Whether the boxes of a scene's unions shall be tested, nearest first.
[[nodiscard]] bool takes_boxes(const ObjectTree& tree);

}  // namespace maquette::sim
