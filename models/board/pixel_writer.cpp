#include "models/board/pixel_writer.hpp"

#include "models/board/long_word.hpp"
#include "models/display/frame_memory.hpp"

namespace maquette::models {

void PixelWriter::clear() {
  burst_.bytes.clear();
  burst_.transaction.addresses.clear();
}

void PixelWriter::append(const SynthesizedPixel& pixel) {
  const std::uint64_t index =
      static_cast<std::uint64_t>(pixel.row) * static_cast<std::uint64_t>(frame_.width) +
      pixel.column;
  for (unsigned byte = 0; byte < FrameMemory::k_pixel_bytes; byte += word_bytes_) {
    burst_.transaction.addresses.push_back(frame_.base + FrameMemory::k_pixel_bytes * index + byte);
  }
  append_long(frame_.format.written(pixel.rgb, pixel.depth), burst_.bytes);
}

void PixelWriter::aim() { burst_.aim(burst_.transaction.addresses.front()); }

}  // namespace maquette::models
