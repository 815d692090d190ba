#include "sim/record/record_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "sim/picture/picture_module.hpp"
#include "sim/record/leg_channels.hpp"
#include "sim/record/record_image.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

const ExrCodec& codec() {
  static const ExrCodec& loaded =
      *reinterpret_cast<const ExrCodec* (*)()>(picture_module_function(k_exr_codec_function))();
  return loaded;
}

}  // namespace

std::string encode_record(const RecordedFrame& frame) {
  std::string bytes;
  const std::string error = codec().encode(record_image(frame), bytes);
  if (!error.empty()) {
    throw std::runtime_error(error);
  }
  return bytes;
}

RecordedFrame decode_record(const std::string& bytes, const std::string& name) {
  ExrImage image = blank_record_image();
  std::string error = codec().decode(bytes, image);
  if (error.empty() && has_legs(image)) {
    error = expect_legs(image);
    error = error.empty() ? codec().decode(bytes, image) : error;
  }
  if (!error.empty()) {
    throw DescriptionError(name + ": " + error);
  }
  return frame_of(image, name);
}

void check_record(const RecordKey& wanted, const RecordKey& found, const std::string& name) {
  if (found.format.width != wanted.format.width || found.format.height != wanted.format.height) {
    throw DescriptionError(fmt::format(
        "{}: a record of {} x {} pixels; allowed: one of {} x {}, as the frame memory has them",
        name, found.format.width, found.format.height, wanted.format.width, wanted.format.height));
  }
  if (found.format.has_depth != wanted.format.has_depth) {
    throw DescriptionError(fmt::format("{}: a record {} depths; allowed: one {}", name,
                                       found.format.has_depth ? "with" : "without",
                                       wanted.format.has_depth ? "with" : "without"));
  }
  if (found.firmware != wanted.firmware) {
    throw DescriptionError(fmt::format("{}: made by firmware {}; allowed: {}, that of this program",
                                       name, found.firmware, wanted.firmware));
  }
  if (found.scene_sha1 != wanted.scene_sha1) {
    throw DescriptionError(fmt::format(
        "{}: a record of another scene, with database {}; allowed: {}, that of this one", name,
        found.scene_sha1, wanted.scene_sha1));
  }
}

}  // namespace maquette::sim
