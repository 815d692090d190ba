#include "sim/page/drawing.hpp"

#include <fmt/format.h>

namespace maquette::sim {
namespace {

std::string number(double value) { return fmt::format("{:g}", value); }

}  // namespace

Html drawn_box(const Box& box, const std::string& kind) {
  return void_element("rect", {{"class", kind},
                               {"x", number(box.x)},
                               {"y", number(box.y)},
                               {"width", number(box.width)},
                               {"height", number(box.height)}});
}

Html drawn_text(double x, double y, const std::string& plain, const std::string& kind) {
  return element("text", {{"class", kind}, {"x", number(x)}, {"y", number(y)}}, text(plain));
}

Html drawn_line(double from_x, double from_y, double to_x, double to_y) {
  return void_element(
      "line",
      {{"x1", number(from_x)}, {"y1", number(from_y)}, {"x2", number(to_x)}, {"y2", number(to_y)}});
}

Html labelled_box(const Box& box, const std::string& kind, const std::vector<std::string>& lines) {
  constexpr double k_margin = 8;
  constexpr double k_line_height = 16;
  Html content = drawn_box(box, kind);
  double y = box.y + k_line_height + 2;
  for (const std::string& line : lines) {
    content += drawn_text(box.x + k_margin, y, line, &line == &lines.front() ? "name" : "");
    y += k_line_height;
  }
  return content;
}

Html drawing(double width, double height, const std::string& description, const Html& content) {
  return element(
      "div",
      {{"class", "wide"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", description}},
      element("svg",
              {{"xmlns", "http://www.w3.org/2000/svg"},
               {"role", "img"},
               {"aria-label", description},
               {"width", number(width)},
               {"height", number(height)},
               {"viewBox", fmt::format("0 0 {:g} {:g}", width, height)}},
              content));
}

}  // namespace maquette::sim
