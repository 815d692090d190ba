#pragma once

#include <tlm_utils/multi_passthrough_initiator_socket.h>
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
#include "models/bus/arbitration.hpp"
#include "models/bus/bus_account.hpp"
#include "models/bus/bus_arbiter.hpp"
#include "models/bus/bus_transaction.hpp"
#include "models/bus/versabus_parameters.hpp"

namespace maquette::models {

/// What the bus knows of one of its masters.
struct BusMaster {
  std::string name;
  BusMasterPlace place;
  AccessLaw access;
};

/// The VERSAbus backplane: blocking transport. Its arbiter (BusArbiter, one per level of
/// abstraction) says who has the bus from when on; an access then lasts as AccessLaw says.
///
/// The bus keeps its own time. While every active master stands with a request it resolves accesses
/// ahead of the kernel, up to the first end of a transaction that its master does not follow up:
/// nothing unknown can come in between.
/// While some master computes unknown to the bus, and the arbiter heeds such masters, only instants
/// before the kernel's are decided and the bus wakes itself one tick after the next one.
///
/// A read-modify-write cycle is one access that lasts as long as its read, the processor's change
/// and its write together; the bus is not released in between, whoever asks (MC68000 TAS).
///
/// Slaves are called with the offset of the data strobe as TLM delay (exactly: BusStrobe) and the
/// address relative to their base; they add their access time to the delay and must not wait. An
/// access that nobody answers, or not within the timeout, is a bus error: it lasts for the timeout
/// and ends the burst with an error response. With the timeout off a missing slave ends it as a
/// fast one would.
class VersaBus : public sc_core::sc_module {
 public:
  /// Throws std::invalid_argument for parameters that make no bus.
  VersaBus(const sc_core::sc_module_name& name, const VersaBusParameters& parameters);

  /// Binds a master, active from the start, and returns its number. Its `b_transport` takes a burst
  /// (BusTransaction) with the time until its request as delay, blocks, and returns at the end of
  /// the last access with delay 0. Throws std::invalid_argument when the place is taken or outside
  /// the five levels.
  int attach_master(tlm::tlm_base_initiator_socket<>& socket, const BusMaster& master);

  /// Binds a slave at a range of addresses. Throws as AddressMap::add.
  void attach_slave(tlm::tlm_base_target_socket<>& socket, const AddressRange& range);

  /// The master will request no more, until it is activated again.
  void retire(int master);

  /// A retired master may request again, from the kernel's present instant on.
  void activate(int master);

  /// Every access from now on is shown to `observer`, in the order of time.
  void observe(std::function<void(const BusAccess&)> observer) { observer_ = std::move(observer); }

  [[nodiscard]] BusStatistics statistics() const { return account_.statistics(); }
  [[nodiscard]] const AddressMap& address_map() const { return address_map_; }
  [[nodiscard]] const std::string& master_name(int master) const;
  [[nodiscard]] const BusMasterPlace& master_place(int master) const {
    return at(master).description.place;
  }

  /// When the request began, or will begin, that the master waits with; nothing while it computes.
  [[nodiscard]] std::optional<Instant> standing_request(int master) const;
  [[nodiscard]] unsigned word_bytes() const { return word_bytes_; }

 private:
  enum class State { computing, requesting, retired };

  struct Master {
    explicit Master(BusMaster what) : description(std::move(what)) {}

    BusMaster description;
    State state = State::computing;
    Instant request{};      // of the access that is next
    bool promised = false;  // to post or retire in the instant `completed_at`
    Instant completed_at{};
    tlm::tlm_generic_payload* burst = nullptr;
    BusTransaction* transaction = nullptr;
    BusTransaction plain;       // stands in for a payload's missing extension
    std::int64_t accesses = 0;  // of the burst
    BusStrobe strobe;           // before the payload, which frees its extensions
    tlm::tlm_generic_payload access;
    sc_core::sc_event completed;
  };

  struct AccessResult {
    Duration duration;
    Duration slave_time;  // to the first acknowledge
    tlm::tlm_response_status status;
  };

  void b_transport(int id, tlm::tlm_generic_payload& burst, sc_core::sc_time& delay);
  unsigned transport_dbg(int id, tlm::tlm_generic_payload& payload);

  void post(int id, tlm::tlm_generic_payload& burst, Instant request);
  void begin(int id, tlm::tlm_generic_payload& burst, Instant request);
  void enter(int id, Instant request);
  void leave_computing(int id, State next);
  void advance();
  void transfer(const BusGrant& granted);
  AccessResult access_slave(Master& master, std::uint64_t address, Instant strobe);
  AccessResult test_and_set(Master& master, std::uint64_t address, Instant strobe);
  [[nodiscard]] std::uint32_t word_of(const Master& master) const;
  static void answer(BusTransaction& transaction, const BusAccess& access);
  void finish_access(const BusAccess& access, tlm::tlm_response_status status);
  void complete(int id, Instant end, tlm::tlm_response_status status);
  [[nodiscard]] std::uint64_t next_address(const Master& master) const;
  [[nodiscard]] Master& at(int id) const { return *masters_[static_cast<std::size_t>(id)]; }

  tlm_utils::multi_passthrough_target_socket<VersaBus> master_sockets_;
  tlm_utils::multi_passthrough_initiator_socket<VersaBus> slave_sockets_;
  AddressMap address_map_;

  unsigned word_bytes_;
  Duration timeout_;

  std::vector<std::unique_ptr<Master>> masters_;
  int computing_ = 0;   // active masters without a request
  int unpromised_ = 0;  // those of them that may post at any instant
  Instant last_decision_{-1};
  sc_core::sc_event wake_;

  BusAccount account_;
  std::unique_ptr<BusArbiter> arbiter_;
  std::function<void(const BusAccess&)> observer_;
};

}  // namespace maquette::models
