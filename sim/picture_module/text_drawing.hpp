#pragma once

#include <OpenImageIO/imagebuf.h>

#include <array>
#include <string>

namespace maquette::sim {

using DrawnColour = std::array<float, 3>;

/// Where a text stands: the left end of its base line, the letters' height in pixels, their colour.
struct TextPlace {
  int x;
  int y;
  int size;
  DrawnColour colour;
};

/// Writes a text into a picture of three channels; returns what went wrong. The font is DejaVu
/// Sans, which whoever has gnuplot has.
std::string write_text(OIIO::ImageBuf& picture, const std::string& text, const TextPlace& place);

/// How wide a text is, in pixels.
int text_width(const std::string& text, int size);

}  // namespace maquette::sim
