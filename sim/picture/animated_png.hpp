#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace maquette::sim {

/// A chunk of a PNG file: its length, its type of four letters, its data and its check sum.
[[nodiscard]] std::string png_chunk(std::string_view type, std::string_view data);

/// PNG files of one size and format as one animated PNG that begins again at its end (the APNG
/// extension of PNG, third edition); readers that do not know it show the first. Throws
/// std::runtime_error where they are of different formats, or none.
[[nodiscard]] std::string animated_png(const std::vector<std::string>& pictures,
                                       double pictures_per_s);

}  // namespace maquette::sim
