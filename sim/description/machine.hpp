#pragma once

#include <cstdint>
#include <string>

#include "models/machine_parameters.hpp"

namespace maquette::sim {

/// A checked machine description (models/machines/*.yaml with its table of models/arithmetic/).
struct Machine {
  std::string name;
  models::MachineParameters parameters;  ///< boards are placed
  std::string arithmetic_name;
  std::int64_t stack_bytes = 4096;            ///< reserved in a board's RAM
  int crossing_capacity = 256;                ///< of the work area for ray crossings
  int ray_capacity = 32;                      ///< of the work area for rays that wait
  std::int64_t system_bytes = 8192;           ///< monitor and vectors at the bottom of RAM
  bool allow_memory_overflow = false;         ///< simulate although the scene does not fit
};

}  // namespace maquette::sim
