#include "sim/fields/dimension.hpp"

namespace maquette::sim {

const std::vector<RealUnit>& units(RealDimension dimension) {
  static const std::vector<RealUnit> number{{"", 0}};
  static const std::vector<RealUnit> fraction{{"", 0}, {"%", -2}};
  static const std::vector<RealUnit> frequency{{"Hz", 0}, {"kHz", 3}, {"MHz", 6}, {"GHz", 9}};
  static const std::vector<RealUnit> angle{{"deg", 0}};
  switch (dimension) {
    case RealDimension::fraction:
      return fraction;
    case RealDimension::frequency:
      return frequency;
    case RealDimension::angle:
      return angle;
    case RealDimension::number:
      break;
  }
  return number;
}

const std::vector<WholeUnit>& units(WholeDimension dimension) {
  static const std::vector<WholeUnit> count{{"", 1, ""}};
  static const std::vector<WholeUnit> time{{"ps", 1, ""},
                                           {"ns", 1'000, ""},
                                           {"us", 1'000'000, ""},
                                           {"ms", 1'000'000'000, ""},
                                           {"s", 1'000'000'000'000, ""},
                                           {"min", 60'000'000'000'000, ""}};
  static const std::vector<WholeUnit> memory{{"B", 1, ""}, {"KiB", 1024, ""}, {"MiB", 1048576, ""}};
  static const std::vector<WholeUnit> clocks{{"clocks", 1, "clock"}};
  static const std::vector<WholeUnit> bits{{"bits", 1, "bit"}};
  static const std::vector<WholeUnit> pixels{{"pixels", 1, "pixel"}};
  static const std::vector<WholeUnit> lines{{"lines", 1, "line"}};
  switch (dimension) {
    case WholeDimension::time:
      return time;
    case WholeDimension::memory:
      return memory;
    case WholeDimension::clocks:
      return clocks;
    case WholeDimension::bits:
      return bits;
    case WholeDimension::pixels:
      return pixels;
    case WholeDimension::lines:
      return lines;
    case WholeDimension::count:
      break;
  }
  return count;
}

}  // namespace maquette::sim
