#include "sim/accuracy/ladders.hpp"

namespace maquette::sim {

Ladder number_ladder() {
  return {"number",
          "number type of the firmware, without the machine",
          ErrorMeasure::picture,
          {{"double", {}, LevelKind::double_picture}, {"float", {}, LevelKind::float_picture}},
          0};
}

}  // namespace maquette::sim
