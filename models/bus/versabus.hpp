#pragma once

#include <tlm_utils/multi_passthrough_target_socket.h>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <systemc>
#include <tlm>

#include "models/bus/address_map.hpp"
#include "models/bus/bus_account.hpp"
#include "models/bus/bus_engine.hpp"
#include "models/bus/bus_masters.hpp"
#include "models/bus/bus_slaves.hpp"
#include "models/bus/bus_transaction.hpp"
#include "models/bus/line_state.hpp"
#include "models/bus/versabus_parameters.hpp"

namespace maquette::models {

/// The VERSAbus backplane: blocking transport.
///
/// Its masters' bursts (BusMasters) reach its slaves (BusSlaves) by its engine (BusEngine, as its
/// level of abstraction makes it), which says who has the bus from when on.
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
  /// ends the burst, with an error response. Throws as BusMasters::add.
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

  /// The master will request nothing before `instant`, in which it requests, retires, rests or says
  /// another one.
  void promise(int master, Instant instant);

  /// The master requests nothing until whatever it waits for stirs it: another master of this bus,
  /// or a bystander.
  void rest(int master);

  /// A resting master goes on in the kernel's present instant.
  void stir(int master);

  /// The number of one that is no master and may stir some.
  int attach_bystander() { return masters_.lookahead().add_bystander(); }

  /// When the bystander acts next: k_never for not before a master has it act. In that instant it
  /// says so anew, after it has acted.
  void expect(int bystander, Instant instant);

  /// Every access from now on is shown to `observer`, in the order of time.
  void observe(std::function<void(const BusAccess&)> observer) {
    masters_.observe(std::move(observer));
  }

  /// Every line of the bus is shown to `observer`, at a level that has lines (BusLevel::has_lines):
  /// as it is before the simulation starts, and then at every change, of which there may be several
  /// in an instant. To be called before the simulation starts.
  void observe_lines(const LineObserver& observer) { engine_->observe_lines(observer); }

  [[nodiscard]] BusStatistics statistics() const { return account_.statistics(); }
  [[nodiscard]] const AddressMap& address_map() const { return slaves_.address_map(); }
  [[nodiscard]] const std::string& master_name(int master) const { return masters_[master].name; }
  [[nodiscard]] const BusMasterPlace& master_place(int master) const {
    return masters_[master].place;
  }

  /// When the request began, or will begin, that the master waits with; nothing while it computes.
  [[nodiscard]] std::optional<Instant> standing_request(int master) const {
    return masters_.lookahead().standing_request(master);
  }

  /// The master whose request has stood for longest; k_nobody when nobody waits.
  [[nodiscard]] int longest_standing() const;

  /// Bytes of one access.
  [[nodiscard]] unsigned word_bytes() const { return word_bytes_; }

 private:
  void b_transport(int id, tlm::tlm_generic_payload& burst, sc_core::sc_time& delay);
  unsigned transport_dbg(int id, tlm::tlm_generic_payload& payload);

  tlm_utils::multi_passthrough_target_socket<VersaBus> master_sockets_;
  unsigned word_bytes_;
  BusSlaves slaves_;
  BusAccount account_;
  BusMasters masters_;
  std::unique_ptr<BusEngine> engine_;
};

}  // namespace maquette::models
