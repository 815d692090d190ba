#pragma once

#include "models/bus/instant.hpp"

namespace maquette::models {

/// Who has the bus next, and from when on.
struct BusGrant {
  int master;
  Instant request;
  Instant decision;  ///< its arbitration begins; the grant itself when it needed none
  Instant grant;
  bool kept = false;    ///< until the decision, the master of the access before kept the bus
  Duration handover{};  ///< of the time from decision to grant: another master had the bus before
};

}  // namespace maquette::models
