#include "sim/accuracy/rungs.hpp"

namespace maquette::sim {

Rung number_rung() {
  return {"number",
          "number type of the firmware, without the machine",
          ErrorMeasure::picture,
          {{"double", {}, LevelKind::double_picture}, {"float", {}, LevelKind::float_picture}},
          0};
}

}  // namespace maquette::sim
