#include "models/display/shown_picture.hpp"

namespace maquette::models {

Picture shown_picture(const FrameMemory& memory, const VideoTiming& timing, Instant instant) {
  Picture picture = memory.background();
  for (const PixelWriteRecord& write : memory.log()) {
    if (write.instant > instant) {
      break;
    }
    const int column = static_cast<int>(write.pixel) % picture.width;
    const int row = static_cast<int>(write.pixel) / picture.width;
    const auto scanned = timing.last_scan(column, row, instant);
    if (scanned && write.instant <= *scanned) {
      picture.pixels[write.pixel] = write.rgb;
    }
  }
  return picture;
}

}  // namespace maquette::models
