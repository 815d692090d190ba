#include "sim/picture_module/text_drawing.hpp"

#include <OpenImageIO/imagebufalgo.h>

namespace maquette::sim {

namespace {

/// The file of Debian's fonts-dejavu-core: OpenImageIO 2.5 does not look for names in its folder.
constexpr const char* k_font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

}  // namespace

std::string write_text(OIIO::ImageBuf& picture, const std::string& text, const TextPlace& place) {
  using namespace OIIO::ImageBufAlgo;
  const bool is_done = render_text(picture, place.x, place.y, text, place.size, k_font,
                                   place.colour, TextAlignX::Left, TextAlignY::Baseline, 0, {}, 1);
  return is_done
             ? std::string()
             : "no text without the font DejaVu Sans (fonts-dejavu-core): " + picture.geterror();
}

int text_width(const std::string& text, int size) {
  const OIIO::ROI room = OIIO::ImageBufAlgo::text_size(text, size, k_font);
  return room.defined() ? room.xend : 0;
}

}  // namespace maquette::sim
