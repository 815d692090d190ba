#pragma once

#include <tlm_utils/multi_passthrough_target_socket.h>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <systemc>
#include <tlm>
#include <utility>
#include <vector>

#include "models/bus/access_law.hpp"
#include "models/bus/address_map.hpp"
#include "models/bus/burst_progress.hpp"
#include "models/bus/bus_account.hpp"
#include "models/bus/bus_arbiter.hpp"
#include "models/bus/bus_lookahead.hpp"
#include "models/bus/bus_slaves.hpp"
#include "models/bus/bus_transaction.hpp"
#include "models/bus/versabus_parameters.hpp"

namespace maquette::models {

/// What the bus knows of one of its masters.
struct BusMaster {
  std::string name;
  BusMasterPlace place;
  AccessLaw access;
};

/// The VERSAbus backplane: blocking transport.
///
/// Its arbiter (BusArbiter, one per level of abstraction) says who has the bus from when on; the
/// access then goes to its slave (BusSlaves), for as long as AccessLaw says. The bus keeps its own
/// time: BusLookahead says how far it may be ahead of the kernel.
///
/// To use it: make the bus, masters and slaves; attach each, before the simulation starts; let each
/// master call `b_transport` on its socket with a burst, and retire when it has no more, for until
/// then the others wait for what it may ask.
class VersaBus : public sc_core::sc_module {
 public:
  /// Throws std::invalid_argument for parameters that make no bus.
  VersaBus(const sc_core::sc_module_name& name, const VersaBusParameters& parameters);

  /// Binds a master, active from the start, and returns its number, counted from 0. Its
  /// `b_transport` takes a burst (BusTransaction) with the time until its request as delay, blocks,
  /// and returns at the end of the last access with delay 0. An access that ends in a bus error
  /// ends the burst, with an error response. Throws std::invalid_argument when the place is taken
  /// or outside the five levels, or when an access takes no clock.
  int attach_master(tlm::tlm_base_initiator_socket<>& socket, const BusMaster& master);

  /// Binds a slave at a range of addresses; BusSlaves says how it is called. Throws as
  /// AddressMap::add.
  void attach_slave(tlm::tlm_base_target_socket<>& socket, const AddressRange& range) {
    slaves_.attach(socket, range);
  }

  /// The master will request no more, until it is activated again.
  void retire(int master);

  /// A retired master may request again, from the kernel's present instant on.
  void activate(int master);

  /// Every access from now on is shown to `observer`, in the order of time.
  void observe(std::function<void(const BusAccess&)> observer) { observer_ = std::move(observer); }

  [[nodiscard]] BusStatistics statistics() const { return account_.statistics(); }
  [[nodiscard]] const AddressMap& address_map() const { return slaves_.address_map(); }
  [[nodiscard]] const std::string& master_name(int master) const {
    return at(master).description.name;
  }
  [[nodiscard]] const BusMasterPlace& master_place(int master) const {
    return at(master).description.place;
  }

  /// When the request began, or will begin, that the master waits with; nothing while it computes.
  [[nodiscard]] std::optional<Instant> standing_request(int master) const {
    return lookahead_.standing_request(master);
  }

  /// The master whose request has stood for longest; k_nobody when nobody waits.
  [[nodiscard]] int longest_standing() const;

  /// Bytes of one access.
  [[nodiscard]] unsigned word_bytes() const { return word_bytes_; }

 private:
  struct Master {
    Master(BusMaster what, unsigned word_bytes) : description(std::move(what)), burst(word_bytes) {}

    BusMaster description;
    BurstProgress burst;
    sc_core::sc_event completed;
  };

  void b_transport(int id, tlm::tlm_generic_payload& burst, sc_core::sc_time& delay);
  unsigned transport_dbg(int id, tlm::tlm_generic_payload& payload);

  void check_place(const BusMaster& master) const;
  void enter(int id, Instant request);
  void advance();
  void access(const BusGrant& granted);
  void finish_access(const BusAccess& access, tlm::tlm_response_status status);
  void complete(int id, Instant end, tlm::tlm_response_status status);
  [[nodiscard]] Master& at(int id) const { return *masters_[static_cast<std::size_t>(id)]; }

  tlm_utils::multi_passthrough_target_socket<VersaBus> master_sockets_;
  BusSlaves slaves_;
  unsigned word_bytes_;
  std::vector<std::unique_ptr<Master>> masters_;
  BusLookahead lookahead_;
  sc_core::sc_event wake_;
  BusAccount account_;
  std::unique_ptr<BusArbiter> arbiter_;
  std::function<void(const BusAccess&)> observer_;
};

}  // namespace maquette::models
