#pragma once

#include <string>

#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// How a derived column of the table comes from others.
enum class Derivation {
  speed_up,    ///< `of` in the first row of the series over `of` in this row
  efficiency,  ///< speed_up over the ratio of `over` in this row to that in the first row
  ratio        ///< `of` over `over`, a column or a number
};

/// Whether a number may stand for the column `over`.
constexpr bool takes_number(Derivation derivation) {
  switch (derivation) {
    case Derivation::speed_up:
    case Derivation::efficiency:
      return false;
    case Derivation::ratio:
      break;
  }
  return true;
}

/// A column that a study adds to its table. A series are the rows that agree in every varied
/// parameter but `over`; its first row is that of the smallest point number.
struct DerivedColumn {
  std::string name;
  std::string unit;
  std::string sentence;  ///< what it is, for people
  Derivation derivation = Derivation::ratio;
  std::string of;    ///< a column
  std::string over;  ///< a column; of a ratio also a number
  YamlPlace place;   ///< where it was asked for
};

}  // namespace maquette::sim
