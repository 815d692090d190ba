#pragma once

#include <memory>
#include <string_view>

namespace maquette::models {

class BusEngine;
struct BusParts;
struct VersaBusParameters;

/// How exactly the bus is simulated. A level is a constant in a file of its own and a row of
/// bus_levels.hpp.
struct BusLevel {
  std::string_view name;      ///< in descriptions
  std::string_view sentence;  ///< what it does with requests, for people
  bool has_quantum;           ///< VersaBusParameters::quantum says something about it
  bool is_exclusive;          ///< one master has the bus at a time
  bool has_lines;             ///< there is something to see for VersaBus::observe_lines

  /// The engine of a bus of these parameters, within the module under construction.
  std::unique_ptr<BusEngine> (*make_engine)(const VersaBusParameters& parameters,
                                            const BusParts& parts);
};

constexpr bool operator==(const BusLevel& a, const BusLevel& b) { return a.name == b.name; }

}  // namespace maquette::models
