#pragma once

#include <cstdint>

/// The functions of the process and the kinds of rays, by which work is told apart (paper, section
/// V.2.3.1.2). A marker stands in each function of the firmware that begins one; it is nothing but
/// for `Counted`, which then counts in another place.
namespace maquette::firmware {

enum class Function : std::uint8_t {
  pixel,           ///< the ray through a pixel, its colour and its depth
  preparation,     ///< conversions, lights, surfaces and depths before the first pixel
  concatenation,   ///< frames of the primitives, there and back
  boxes,           ///< around the nodes
  rectangles,      ///< around the projected boxes
  spheres,         ///< around the nodes
  extents,         ///< rays compared with rectangles, boxes and spheres
  classification,  ///< the way through the tree, segments of rays in and out of primitives
  combination,     ///< of segments by Boolean operators
  points,          ///< points brought to the surface they lie on, with their normals
  photometry,      ///< luminance, Fresnel, directions of secondary rays
  intersection     ///< of rays with primitives of kind 0; those of the other kinds follow
};

/// So many are no intersection; one for each kind of primitive follows them.
inline constexpr int k_fixed_function_count = static_cast<int>(Function::intersection);

/// What is told of each of these: keys of stats.json.
inline constexpr const char* k_function_names[k_fixed_function_count] = {
    "pixel",   "preparation",    "concatenation", "boxes",  "rectangles", "spheres",
    "extents", "classification", "combination",   "points", "photometry"};

/// The kind of a ray; of those towards lights each light has its own, from `shadow` on.
enum class RayKind : std::uint8_t { primary, reflected, refracted, shadow };

/// So many kinds there are, as many as a word has bits.
inline constexpr int k_ray_kind_limit = 64;

/// So many lights are told apart; the last of them stands for all that follow it.
inline constexpr int k_told_lights = k_ray_kind_limit - static_cast<int>(RayKind::shadow);

constexpr RayKind shadow_of(int light) {
  return static_cast<RayKind>(static_cast<int>(RayKind::shadow) +
                              (light < k_told_lights ? light : k_told_lights - 1));
}

/// From here to the end of the block work is that of a function.
template <class Real>
struct [[maybe_unused]] InFunction {
  [[gnu::always_inline]] constexpr explicit InFunction(Function /*function*/) {}
};

/// From here to the end of the block work is that of a ray of this kind.
template <class Real>
struct [[maybe_unused]] InRay {
  [[gnu::always_inline]] constexpr explicit InRay(RayKind /*kind*/) {}
};

/// Remembers towards which light the next shadow rays are; only `Counted` asks.
template <class Real>
struct LightAsked {
  static constexpr void put(int /*light*/) {}
  static constexpr RayKind shadow_ray() { return RayKind::shadow; }
};

/// Remembers of which kind the rays are that wait on the stack; only `Counted` asks.
template <class Real>
struct WaitingRays {
  static constexpr void put(std::int32_t /*place*/, RayKind /*kind*/) {}
  static constexpr RayKind at(std::int32_t /*place*/) { return RayKind::primary; }
};

}  // namespace maquette::firmware
