#include "models/display/shown_picture.hpp"

namespace maquette::models {

Picture shown_picture(const Picture& background, const std::vector<PixelWriteRecord>& log,
                      const VideoTiming& timing, Instant instant) {
  Picture picture = background;
  for (const PixelWriteRecord& write : log) {
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

Picture shown_picture(const FrameMemory& memory, const VideoTiming& timing, Instant instant) {
  return shown_picture(memory.background(), memory.log(), timing, instant);
}

}  // namespace maquette::models
