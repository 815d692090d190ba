#pragma once

#include <string>

#include "sim/picture_module/exr_codec.hpp"
#include "sim/record/recorded_frame.hpp"

/// Recorded frames as pictures of many channels, which is what a record's file holds compressed.
namespace maquette::sim {

/// The attribute of a record's header that holds record_digest.
inline constexpr const char* k_record_digest = "maquetteDigest";

/// The channels and attributes that a record has, empty: what decoding asks for.
[[nodiscard]] ExrImage blank_record_image();

/// A digest over header and counts. The counts of a channel go in as their sum and one that weighs
/// them by their place, since the file's compression has a check of its own for each block of them.
[[nodiscard]] std::string record_digest(const ExrImage& image);

/// The frame as a picture with its digest.
[[nodiscard]] ExrImage record_image(const RecordedFrame& frame);

/// The frame in a picture that has the channels and attributes of blank_record_image, each channel
/// with a value for every pixel of the data window. `name` is that of the file, for messages.
/// Throws DescriptionError for a picture that is no record, or is damaged.
[[nodiscard]] RecordedFrame frame_of(const ExrImage& image, const std::string& name);

}  // namespace maquette::sim
