#pragma once

#include <cstdint>

/// The legs of a pixel's process: parts of it that are done in one go, and that a machine may share
/// out between its boards and units of one function. A marker stands where one begins; it is
/// nothing but for `Counted`, and there only when somebody listens.
namespace maquette::firmware {

/// The stages of a pixel's process, by which machines with function units share it out.
enum class Stage : std::uint8_t {
  board,         ///< what only the board that has the pixel does: its rays, its colour
  extents,       ///< rays compared with rectangles, spheres and boxes, and the way to leaves
  intersection,  ///< of rays with primitives
  combination,   ///< of segments by Boolean operators
  photometry     ///< visible points with their normals, luminance, directions of secondary rays
};

/// What is handed over for a part of the process, in words of 32 bits: numbers, indices, and small
/// fields together in one. Whoever does it keeps nothing, so that anybody may go on with it.
struct LegMessages {
  int given;      ///< to whoever begins it
  int returned;   ///< by whoever ends it, at least
  int asked = 0;  ///< by whoever needs another stage meanwhile: what it asks for and its own state
  int resumed = 0;  ///< to whoever goes on after that: that state and the answer
};

/// Whoever wants to know the legs of a pixel: what is called with `self`.
struct LegListener {
  void* self;
  /// A part of a stage begins, within the one that was begun before. `primitive` is the kind of
  /// one, of an intersection.
  void (*begin)(void* self, Stage stage, int primitive, const LegMessages& messages);
  /// Words that the innermost part returns besides.
  void (*returns_also)(void* self, int words);
  /// The innermost part ends.
  void (*end)(void* self);
};

/// From here to the end of the block work is that of a stage. `messages` gives LegMessages when it
/// is called.
template <class Real>
struct [[maybe_unused]] InLeg {
  template <class Messages>
  [[gnu::always_inline]] constexpr InLeg(Stage /*stage*/, const Messages& /*messages*/,
                                         int /*primitive*/ = 0) {}
};

/// Declares words that the innermost part of the process returns besides.
template <class Real>
[[gnu::always_inline]] constexpr void returns_also(int /*words*/) {}

}  // namespace maquette::firmware
