#pragma once

#include <tlm_utils/multi_passthrough_initiator_socket.h>
#include <cstdint>
#include <tlm>

#include "models/bus/access_law.hpp"
#include "models/bus/address_map.hpp"
#include "models/bus/burst_progress.hpp"

namespace maquette::models {

/// How an access went.
struct AccessResult {
  Duration duration;    ///< from the strobe to the release of the bus
  Duration slave_time;  ///< to the first acknowledge; the timeout's, if there is none
  tlm::tlm_response_status status;
};

/// The slaves of a bus, and one access to them: a transfer, or a test-and-set cycle.
///
/// Slaves are called with the offset of the data strobe as TLM delay (exactly: BusStrobe) and the
/// address relative to their base; they add their access time to the delay and must not wait. An
/// access that nobody answers, or not within the timeout, is a bus error: it lasts for the timeout.
/// With the timeout off a missing slave ends it as a fast one would.
class BusSlaves {
 public:
  /// A `timeout` of zero is off.
  explicit BusSlaves(Duration timeout) : sockets_("slave_sockets"), timeout_(timeout) {
    repeated_.set_command(tlm::TLM_WRITE_COMMAND);
  }

  /// Binds a slave at a range of addresses. Throws as AddressMap::add.
  void attach(tlm::tlm_base_target_socket<>& socket, const AddressRange& range);

  /// Does the access of a burst that is next, with its data strobe at `strobe`, by the law of its
  /// master.
  AccessResult access(BurstProgress& burst, const AccessLaw& law, Instant strobe);

  /// Does so many more accesses as the burst's last one, which was answered, in one go. Does
  /// nothing and returns false unless they all are of its slave, and that one is steady.
  bool repeat(BurstProgress& burst, std::int64_t times);

  /// Has a slave do a transfer, of an address relative to its base.
  void transport(int slave, tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    sockets_[slave]->b_transport(payload, delay);
  }

  /// Passes a debug transport on.
  unsigned transport_dbg(tlm::tlm_generic_payload& payload);

  [[nodiscard]] Duration timeout() const { return timeout_; }
  [[nodiscard]] const AddressMap& address_map() const { return address_map_; }

 private:
  AccessResult transfer(BurstProgress& burst, const AccessLaw& law, Instant strobe,
                        tlm::tlm_command command);
  void write(int slave, BurstProgress& burst, std::int64_t first, std::int64_t accesses);
  AccessResult test_and_set(BurstProgress& burst, const AccessLaw& law, Instant strobe);

  tlm_utils::multi_passthrough_initiator_socket<BusSlaves> sockets_;
  AddressMap address_map_;
  Duration timeout_;
  tlm::tlm_generic_payload repeated_;
};

}  // namespace maquette::models
