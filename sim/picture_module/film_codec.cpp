#include "sim/picture_module/film_codec.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include "sim/picture_module/first_error.hpp"
#include "sim/picture_module/text_drawing.hpp"

namespace maquette::sim {
namespace {

constexpr int k_channels = 3;

OIIO::ImageSpec specification_of(const DrawnPicture& picture) {
  return {picture.width, picture.height, k_channels, OIIO::TypeDesc::UINT8};
}

std::string caption(const std::string& text, DrawnPicture& picture) {
  constexpr int k_size = 18;
  constexpr int k_margin = 8;
  constexpr DrawnColour k_black = {0, 0, 0};
  constexpr DrawnColour k_white = {1, 1, 1};
  OIIO::ImageBuf canvas(specification_of(picture), picture.channels.data());
  const int top = picture.height - k_size - 2 * k_margin;
  OIIO::ImageBufAlgo::fill(canvas, k_black,
                           {0, text_width(text, k_size) + 2 * k_margin, top, picture.height}, 1);
  return write_text(canvas, text,
                    {k_margin, picture.height - k_margin - k_size / 4, k_size, k_white});
}

std::string encode_gif(double pictures_per_s, const NextPicture& next, std::string& bytes) {
  std::vector<unsigned char> file;
  OIIO::Filesystem::IOVecOutput memory(file);
  const auto output = OIIO::ImageOutput::create("gif");
  if (!output || !output->supports("multiimage")) {
    return "OpenImageIO cannot write films as GIF here; a folder is allowed";
  }
  output->set_ioproxy(&memory);
  DrawnPicture picture;
  for (bool is_first = true; next(picture); is_first = false) {
    OIIO::ImageSpec specification = specification_of(picture);
    specification.attribute("FramesPerSecond", static_cast<float>(pictures_per_s));
    const auto mode = is_first ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage;
    if (!output->open("memory.gif", specification, mode) ||
        !output->write_image(OIIO::TypeDesc::UINT8, picture.channels.data())) {
      return "OpenImageIO cannot write GIF: " + first_error(*output);
    }
  }
  output->close();
  bytes.assign(file.begin(), file.end());
  return {};
}

}  // namespace
}  // namespace maquette::sim

extern "C" const maquette::sim::FilmCodec* maquette_film_codec() {
  static const maquette::sim::FilmCodec codec{maquette::sim::caption, maquette::sim::encode_gif};
  return &codec;
}
