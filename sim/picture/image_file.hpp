#pragma once

#include <string>

#include "models/display/depth_map.hpp"
#include "models/display/picture.hpp"

namespace maquette::sim {

/// The picture as the bytes of a PNG file: 24 bits per pixel, nothing besides the pixels, the same
/// bytes for the same picture. Throws std::invalid_argument when `pixels` has not the stated size,
/// or the picture is empty.
std::string encode_png(const models::Picture& picture);

/// The picture in the bytes of a PNG file of three 8-bit channels. `name` is that of the file, for
/// the error message. Throws DescriptionError.
models::Picture decode_png(const std::string& bytes, const std::string& name);

/// The depths, whole, as the bytes of a PNG file of one 16-bit channel, black is near; the same as
/// for a picture.
std::string encode_depths(const models::DepthMap& depths);

/// The depths in the bytes of such a file. Throws DescriptionError.
models::DepthMap decode_depths(const std::string& bytes, const std::string& name);

}  // namespace maquette::sim
