#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "firmware/arithmetic/work.hpp"
#include "models/machine/machine_parameters.hpp"

namespace maquette::sim {

/// How far a figure can be trusted: read in the source named, measured on an instruction-level
/// processor, stated widely without a source seen, or inferred from other figures. Descriptions
/// write R, M, W, I.
enum class ConfidenceMark { read, measured, stated, inferred };

/// Where the cost of one operation comes from.
struct CostSource {
  std::string text;
  ConfidenceMark mark = ConfidenceMark::inferred;
};

/// Where the costs of a processor come from: the names of its tables, and each of their figures.
struct CostTables {
  std::string arithmetic;
  std::string program;
  std::array<CostSource, firmware::k_operation_count> sources;
};

/// What counted work costs: what a sample of pixels took whose program was executed, where boards
/// can execute it, or what the tables say.
enum class CostOrigin { calibrated, tables };

/// A checked machine description (models/machines/*.yaml with its tables of models/arithmetic/ and
/// models/program/).
struct Machine {
  std::string name;
  models::MachineParameters parameters;  ///< boards are placed
  CostTables tables;                     ///< of the boards
  /// Of the units of a kind that have costs of their own.
  std::array<CostTables, models::k_unit_kind_count> unit_tables;
  CostOrigin cost_origin = CostOrigin::calibrated;
  std::int64_t stack_bytes = 16384;    ///< reserved in a board's RAM
  int crossing_capacity = 1024;        ///< of the work area for ray crossings
  int ray_capacity = 32;               ///< of the work area for rays that wait
  std::int64_t system_bytes = 8192;    ///< monitor and vectors at the bottom of RAM
  bool allow_memory_overflow = false;  ///< simulate although the scene does not fit
};

}  // namespace maquette::sim
