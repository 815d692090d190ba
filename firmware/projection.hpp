#pragma once

#include "firmware/database.hpp"

/// How the scene comes onto the screen. The paper's observer sees it in perspective; a parallel
/// view has rays along z of the screen frame, which start where its x and y are those of a pixel.
namespace maquette::firmware {

enum class Projection : std::uint8_t { perspective, parallel };

/// Whether the program is linked for the projection of its scene. That of a board is: functions in
/// which it matters have others in their place (board/synthesis_parallel.cpp), so that a view in
/// perspective neither holds nor asks for them.
template <class Real>
inline constexpr bool k_is_linked_for_projection = false;

/// Whether the view is parallel, as far as the program does not know it beforehand.
template <class Real>
constexpr bool is_parallel(const Database<Real>& database) {
  if constexpr (k_is_linked_for_projection<Real>) {
    return false;
  } else {
    return database.needs.parallel_view;
  }
}

}  // namespace maquette::firmware
