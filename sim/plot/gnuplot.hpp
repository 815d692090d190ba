#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace maquette::sim {

/// A point of a plot.
struct PlotPoint {
  double x = 0;
  double y = 0;
};

/// A text as a gnuplot string: nothing in it is executed or substituted.
[[nodiscard]] std::string gnuplot_text(const std::string& text);

/// A number for tics and legends: four digits, or those before the point when they are more.
[[nodiscard]] std::string gnuplot_number(double value);

/// A data block `$name` with one row for each list of numbers.
[[nodiscard]] std::string gnuplot_data(const std::string& name,
                                       const std::vector<std::vector<double>>& rows);
[[nodiscard]] std::string gnuplot_data(const std::string& name,
                                       const std::vector<PlotPoint>& points);

/// The text in lines of at most `width` letters, unless a word is longer.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t width);

/// A whole script: settings, then `plot` drawn to `name`.png and `name`.svg.
[[nodiscard]] std::string gnuplot_script(const std::string& name, const std::string& settings,
                                         const std::string& plot);

/// Runs gnuplot on a script and puts `name`.gp, .png and .svg into the directory, which it makes.
/// Throws std::runtime_error when gnuplot can not be run or does not like the script.
void draw(const std::filesystem::path& directory, const std::string& name,
          const std::string& script);

}  // namespace maquette::sim
