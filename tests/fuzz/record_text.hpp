#pragma once

#include <string>
#include <vector>

#include "sim/picture_module/exr_codec.hpp"
#include "sim/record/recorded_frame.hpp"

/// Records as texts that a fuzzer can change: what the container of a record compresses, in plain
/// bytes.
namespace maquette::fuzz {

/// A line `window` with the sides of the picture and the data window, `NAME VALUE` of each
/// attribute, an empty line, and the counts of the channels one after the other, in four bytes
/// each. The data window is also what the useful zone says, if that comes later.
[[nodiscard]] std::string text_of(const sim::ExrImage& image);

/// The picture of any text, with the channels and attributes of a record, as decoding a file may
/// give it. What is missing is zero or empty; windows beyond a few pixels are made small.
[[nodiscard]] sim::ExrImage image_of(const std::string& text);

/// A few frames of some pixels.
[[nodiscard]] std::vector<sim::RecordedFrame> small_frames();

}  // namespace maquette::fuzz
