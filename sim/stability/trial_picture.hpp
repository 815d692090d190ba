#pragma once

#include <cstdint>
#include <vector>

#include "sim/database/picture_format.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// A picture that the plain firmware makes, without machine and time.
struct TrialPicture {
  std::vector<std::uint32_t> pixels;  ///< 0xRRGGBB; 0 where the luminance is no colour
  int unsound = 0;  ///< pixels with a luminance that is negative, infinite or not a number
};

/// Every `stride`th pixel of every `stride`th row of a prepared scene.
template <class Real>
[[nodiscard]] TrialPicture trial_picture(const PreparedScene<Real>& prepared, int stride = 1);

template <class Real>
[[nodiscard]] TrialPicture trial_picture(const Scene& scene, const PictureFormat& format) {
  return trial_picture(PreparedScene<Real>(packed_scene<Real>(scene, format)));
}

/// By how many levels of 255 the components of two colours 0xRRGGBB differ at most.
[[nodiscard]] int largest_difference(std::uint32_t a, std::uint32_t b);

/// The pixels of which a component differs by more than `levels` of 255.
[[nodiscard]] int differing_pixels(const TrialPicture& a, const TrialPicture& b, int levels);

}  // namespace maquette::sim
