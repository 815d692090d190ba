#pragma once

#include <string>
#include <vector>

#include "sim/page/html.hpp"

namespace maquette::sim {

/// A place and a size in a drawing, in pixels of the page.
struct Box {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// A rectangle; the style sheet knows the class.
[[nodiscard]] Html drawn_box(const Box& box, const std::string& kind);

/// A line of text that begins at a point, on its base line.
[[nodiscard]] Html drawn_text(double x, double y, const std::string& plain,
                              const std::string& kind = "");

/// A straight line.
[[nodiscard]] Html drawn_line(double from_x, double from_y, double to_x, double to_y);

/// A box with lines of text in it, the first as its name.
[[nodiscard]] Html labelled_box(const Box& box, const std::string& kind,
                                const std::vector<std::string>& lines);

/// A drawing of that size; `description` is for those who do not see it.
[[nodiscard]] Html drawing(double width, double height, const std::string& description,
                           const Html& content);

}  // namespace maquette::sim
