#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "firmware/synthesize.hpp"
#include "models/display/picture.hpp"
#include "sim/database/picture_format.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// What may not have been meant. It stops no run and changes no picture.
struct SceneWarning {
  std::string path;  ///< of what it is about, as in an override; empty: of the scene as a whole
  std::string text;
};

using Warn = std::function<void(const SceneWarning& warning)>;

/// What the frame says before its pixels are synthesised: lights that opaque matter encloses, no
/// light at all, no body within the view.
[[nodiscard]] std::vector<SceneWarning> frame_warnings(
    const Scene& scene, const firmware::Frame<firmware::Counted>& frame);

/// A frame that is likely to take the boards a day or more, in seconds.
[[nodiscard]] std::optional<SceneWarning> time_warning(double likely_s);

/// What the finished picture says where it shows nothing but background and black: that no pixel
/// meets a body, or that nothing is lit.
[[nodiscard]] std::optional<SceneWarning> picture_warning(const Scene& scene,
                                                          const PictureFormat& format,
                                                          std::uint32_t background,
                                                          const models::Picture& picture);

}  // namespace maquette::sim
