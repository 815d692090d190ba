#pragma once

#include <cstdint>

#include "firmware/arithmetic/work.hpp"
#include "models/board/kvm02_parameters.hpp"
#include "models/board/mc68000/account.hpp"
#include "models/board/work_cost.hpp"
#include "models/bus/duration.hpp"
#include "models/bus/wide.hpp"

namespace maquette::models {

/// What of an account was not off the board: clocks without wait states, reads (fetches too) and
/// writes of the RAM.
OperationCost ram_use(const mc68000::Account& account);

/// How long a board computes on its program: the clocks of the instructions with the wait states of
/// the RAM, what the host's routines would have cost, and refresh. Accesses off the board are left
/// out, the bus times them.
class ProgramTime {
 public:
  /// Throws as WorkCost.
  explicit ProgramTime(const Kvm02Parameters& parameters);

  /// From the program's start to where its processor has this account. `work` is what the host's
  /// routines did since the last call. Duration::max() when it is longer.
  [[nodiscard]] Duration elapsed(const mc68000::Account& account, const firmware::Work& work);

  /// Clocks besides those of the account, from here on.
  void add(Clocks clocks) { added_milliclocks_ += k_milliclocks * static_cast<Wide>(clocks); }

 private:
  static constexpr std::int64_t k_milliclocks = 1'000;

  WorkCost cost_;
  Clocks read_wait_;
  Clocks write_wait_;
  Wide added_milliclocks_ = 0;  // of the host's routines, and as told
};

}  // namespace maquette::models
