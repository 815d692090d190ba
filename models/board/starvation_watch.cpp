#include "models/board/starvation_watch.hpp"

#include <systemc>

namespace maquette::models {

namespace {

constexpr int k_failures_between_looks = 10'000;

}  // namespace

void StarvationWatch::count_failure() {
  if (++failures_ < k_failures_between_looks) {
    return;
  }
  failures_ = 0;
  const std::uint32_t unit = processor_.peek_long(next_unit_);
  const int starving = bus_.longest_standing();
  if (unit == unit_ && starving != k_nobody) {
    const std::string message =
        bus_.master_name(starving) +
        " starves: boards that try to claim a unit keep it off the bus for ever, and the one that "
        "holds the lock; raise allotment.claim.spin or take another bus.arbitration";
    SC_REPORT_ERROR("/maquette/kvm02", message.c_str());
  }
  unit_ = unit;
}

}  // namespace maquette::models
