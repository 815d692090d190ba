#pragma once

#include <memory>
#include <string_view>

#include "models/bus/bus_account.hpp"
#include "models/bus/bus_arbiter.hpp"

namespace maquette::models {

struct VersaBusParameters;

/// How exactly the bus is simulated. A level is a constant in a file of its own and a row of
/// bus_levels.hpp.
struct BusLevel {
  std::string_view name;      ///< in descriptions
  std::string_view sentence;  ///< what it does with requests, for people
  bool has_quantum;           ///< VersaBusParameters::quantum says something about it
  bool is_exclusive;          ///< one master has the bus at a time

  /// The arbiter of a bus of these parameters. It keeps the account of queues and occupation, by
  /// reference.
  std::unique_ptr<BusArbiter> (*make_arbiter)(const VersaBusParameters& parameters,
                                              BusAccount& account);
};

constexpr bool operator==(const BusLevel& a, const BusLevel& b) { return a.name == b.name; }

}  // namespace maquette::models
