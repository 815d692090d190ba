#include "sim/picture_module/map_drawing.hpp"

#include <OpenImageIO/color.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>

#include "sim/picture_module/text_drawing.hpp"

namespace maquette::sim {
namespace {

constexpr int k_margin = 16;
constexpr int k_title_size = 18;
constexpr int k_text_size = 13;
constexpr int k_top = 92;  // of the map: title, subtitle and unit stand above
constexpr int k_bar_width = 18;
constexpr int k_least_bar_height = 200;
constexpr int k_gap = 8;
constexpr int k_wanted_width = 640;
constexpr int k_wanted_height = 480;
constexpr int k_channels = 3;
constexpr DrawnColour k_paper = {1, 1, 1};
constexpr DrawnColour k_ink = {0.1F, 0.1F, 0.1F};
constexpr DrawnColour k_unknown = {0.85F, 0.85F, 0.85F};

/// Colours that people with any kind of colour vision tell apart (Okabe and Ito, "Color Universal
/// Design", 2008).
constexpr DrawnColour k_named[] = {{0.F, 0.447F, 0.698F},    {0.902F, 0.624F, 0.F},
                                   {0.F, 0.620F, 0.451F},    {0.8F, 0.475F, 0.655F},
                                   {0.337F, 0.706F, 0.914F}, {0.835F, 0.369F, 0.F},
                                   {0.941F, 0.894F, 0.259F}, {0.F, 0.F, 0.F}};

OIIO::ImageSpec specification(int width, int height, int channels) {
  return {width, height, channels, OIIO::TypeDesc::FLOAT};
}

/// A small map is drawn larger, in whole pixels.
int zoom_of(const MapDrawing& drawing) {
  return std::max(1, std::min(k_wanted_width / drawing.width, k_wanted_height / drawing.height));
}

DrawnColour named_colour(float value) {
  return k_named[static_cast<std::size_t>(value) % std::size(k_named)];
}

/// The colours of values, as files have them (the library has them linear), which lie between 0
/// and 1.
OIIO::ImageBuf coloured(int width, int height, std::vector<float>& shares) {
  const OIIO::ImageBuf source(specification(width, height, 1), shares.data());
  OIIO::ImageBuf linear = OIIO::ImageBufAlgo::color_map(source, 0, "viridis", {}, 1);
  for (OIIO::ImageBuf::Iterator<float> pixel(linear); !pixel.done(); ++pixel) {
    for (int channel = 0; channel < k_channels; ++channel) {
      pixel[channel] = OIIO::linear_to_sRGB(static_cast<float>(pixel[channel]));
    }
  }
  return linear;
}

OIIO::ImageBuf coloured_map(const MapDrawing& drawing, int zoom) {
  const int width = drawing.width * zoom;
  const int height = drawing.height * zoom;
  const auto value_at = [&](int x, int y) {
    return drawing
        .values[static_cast<std::size_t>(y / zoom) * static_cast<std::size_t>(drawing.width) +
                static_cast<std::size_t>(x / zoom)];
  };
  std::vector<float> shares;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float value = value_at(x, y);
      const float range = drawing.high - drawing.low;
      shares.push_back(std::isnan(value) || !(range > 0) ? 0 : (value - drawing.low) / range);
    }
  }
  OIIO::ImageBuf picture = coloured(width, height, shares);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (const float value = value_at(x, y); std::isnan(value)) {
        picture.setpixel(x, y, k_unknown);
      } else if (!drawing.names.empty()) {
        picture.setpixel(x, y, named_colour(value));
      }
    }
  }
  return picture;
}

/// What stands beside the map, and where.
struct Side {
  int x;
  int height;
};

std::string draw_scale(const MapDrawing& drawing, const Side& side, OIIO::ImageBuf& canvas) {
  std::vector<float> shares;
  for (int y = 0; y < side.height; ++y) {
    const auto share = static_cast<float>(side.height - 1 - y);
    shares.insert(shares.end(), k_bar_width, share / static_cast<float>(side.height - 1));
  }
  OIIO::ImageBufAlgo::paste(canvas, side.x, k_top, 0, 0, coloured(k_bar_width, side.height, shares),
                            {}, 1);
  std::string error =
      write_text(canvas, drawing.unit, {side.x, k_top - k_gap - 4, k_text_size, k_ink});
  for (const MapTick& tick : drawing.ticks) {
    const float range = drawing.high - drawing.low;
    const float share = range > 0 ? (tick.value - drawing.low) / range : 0;
    const int y =
        k_top + static_cast<int>(std::lround((1 - share) * static_cast<float>(side.height - 1)));
    const int right = side.x + k_bar_width;
    OIIO::ImageBufAlgo::fill(canvas, k_ink, {right, right + 4, y, y + 1}, 1);
    error += write_text(canvas, tick.label, {right + k_gap, y + 5, k_text_size, k_ink});
  }
  return error;
}

std::string draw_legend(const MapDrawing& drawing, const Side& side, OIIO::ImageBuf& canvas) {
  constexpr int k_line = 22;
  std::string error;
  for (std::size_t name = 0; name < drawing.names.size(); ++name) {
    const int y = k_top + static_cast<int>(name) * k_line;
    OIIO::ImageBufAlgo::fill(canvas, named_colour(static_cast<float>(name)),
                             {side.x, side.x + k_bar_width, y, y + k_bar_width}, 1);
    error += write_text(canvas, drawing.names[name],
                        {side.x + k_bar_width + k_gap, y + k_text_size, k_text_size, k_ink});
  }
  return error;
}

int side_width(const MapDrawing& drawing) {
  int width = text_width(drawing.unit, k_text_size);
  for (const MapTick& tick : drawing.ticks) {
    width = std::max(width, k_bar_width + k_gap + text_width(tick.label, k_text_size));
  }
  for (const std::string& name : drawing.names) {
    width = std::max(width, k_bar_width + k_gap + text_width(name, k_text_size));
  }
  return width;
}

std::string draw(const MapDrawing& drawing, DrawnPicture& drawn) {
  const int zoom = zoom_of(drawing);
  const OIIO::ImageBuf picture = coloured_map(drawing, zoom);
  const Side side{k_margin + drawing.width * zoom + k_margin,
                  std::max(drawing.height * zoom, k_least_bar_height)};
  const int width =
      k_margin +
      std::max({side.x - k_margin + side_width(drawing), text_width(drawing.title, k_title_size),
                text_width(drawing.subtitle, k_text_size)}) +
      k_margin;
  const int height = k_top + side.height + k_margin;
  OIIO::ImageBuf canvas(specification(width, height, k_channels));
  OIIO::ImageBufAlgo::fill(canvas, k_paper, {}, 1);
  OIIO::ImageBufAlgo::paste(canvas, k_margin, k_top, 0, 0, picture, {}, 1);
  std::string error =
      write_text(canvas, drawing.title, {k_margin, k_margin + k_title_size, k_title_size, k_ink});
  error += write_text(canvas, drawing.subtitle,
                      {k_margin, k_margin + k_title_size + 22, k_text_size, k_ink});
  error += drawing.names.empty() ? draw_scale(drawing, side, canvas)
                                 : draw_legend(drawing, side, canvas);
  if (!error.empty()) {
    return error.substr(0, error.find('\n'));
  }
  drawn.width = width;
  drawn.height = height;
  drawn.channels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                        k_channels);
  canvas.get_pixels({}, OIIO::TypeDesc::UINT8, drawn.channels.data());
  return {};
}

}  // namespace
}  // namespace maquette::sim

extern "C" const maquette::sim::MapCodec* maquette_map_codec() {
  static const maquette::sim::MapCodec codec{maquette::sim::draw};
  return &codec;
}
