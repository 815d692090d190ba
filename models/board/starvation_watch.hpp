#pragma once

#include <cstdint>

#include "models/board/processor.hpp"
#include "models/bus/versabus.hpp"

namespace maquette::models {

/// Notices that boards which try to take the lock of the units keep the one that holds it off the
/// bus for ever: no unit is claimed any more however often they try.
class StarvationWatch {
 public:
  /// `next_unit` is the address of the counter of units. Bus and processor are kept by reference.
  StarvationWatch(const VersaBus& bus, Processor& processor, std::uint64_t next_unit)
      : bus_(bus), processor_(processor), next_unit_(next_unit) {}

  /// A try of this board has failed. Reports starvation with the name of the board that starves.
  void count_failure();

  /// One has not.
  void count_success() { failures_ = 0; }

 private:
  const VersaBus& bus_;
  Processor& processor_;
  std::uint64_t next_unit_;
  int failures_ = 0;  // since the last look
  std::uint32_t unit_ = 0;
};

}  // namespace maquette::models
