#include "sim/record/leg_channels.hpp"
#include "sim/record/record_image.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/record_text.hpp"

namespace maquette::fuzz {

namespace {

/// Every pixel of the zone is in the picture and stands where its place in the list says.
void hold_zone(const sim::RecordedFrame& frame) {
  const models::PixelRectangle& zone = frame.useful_zone;
  require(zone.width >= 0 && zone.height >= 0, "a useful zone has a negative side");
  require(frame.pixels.size() == static_cast<std::size_t>(zone.pixels()),
          "a record has not the pixels of its useful zone");
  for (const models::SynthesizedPixel& pixel : frame.pixels) {
    require(pixel.column < frame.key.format.width && pixel.row < frame.key.format.height,
            "a pixel of a record is outside of the picture");
    require(&frame.at({pixel.column, pixel.row}) == &pixel, "a pixel is not at its position");
  }
}

}  // namespace

void try_record(const std::string& input) {
  sim::ExrImage image = image_of(input);
  // A digest that is wrong is found as such; behind it everything has to be checked for itself.
  static_cast<void>(sim::record_digest(image));
  if (image.attributes[sim::k_record_digest] == "right") {
    image.attributes[sim::k_leg_words] = sim::leg_digest(image);
    image.attributes[sim::k_record_digest] = sim::record_digest(image);
  }
  try {
    const sim::RecordedFrame frame = sim::frame_of(image, "record.exr");
    hold_zone(frame);
    const sim::ExrImage written = sim::record_image(frame);
    try {
      const sim::RecordedFrame again = sim::frame_of(written, "written.exr");
      require(text_of(sim::record_image(again)) == text_of(written),
              "a record is another one when it is written again");
    } catch (const sim::DescriptionError& error) {
      throw BrokenLaw(std::string{"a record that was written is refused: "} + error.what());
    }
  } catch (const sim::DescriptionError&) {
    return;
  }
}

std::vector<std::string> record_seeds() {
  std::vector<std::string> seeds;
  for (const sim::RecordedFrame& frame : small_frames()) {
    sim::ExrImage image = sim::record_image(frame);
    seeds.push_back(text_of(image));
    image.attributes[sim::k_record_digest] = "right";
    seeds.push_back(text_of(image));
  }
  return seeds;
}

}  // namespace maquette::fuzz
