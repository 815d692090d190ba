#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>
#include <array>
#include <cstdint>
#include <memory>
#include <systemc>
#include <tlm>
#include <vector>

#include "models/board/kvm02_parameters.hpp"
#include "models/board/processor.hpp"
#include "models/bus/access_law.hpp"
#include "models/bus/versabus.hpp"
#include "models/unit/errand.hpp"
#include "models/unit/message.hpp"
#include "models/unit/unit_group.hpp"
#include "models/unit/unit_parameters.hpp"
#include "models/unit/unit_statistics.hpp"

namespace maquette::models {

/// The groups of a machine, by kind; null where there are no units of a kind.
using UnitGroups = std::array<std::unique_ptr<UnitGroup>, k_unit_kind_count>;

/// A unit that does one kind of legs, one errand after the other in the order of their arrival. It
/// takes messages into its mailbox, a register behind its RAM with a finite memory, and is a bus
/// master to hand on what it has served: to a unit of the next kind, with all that it has made and
/// all that the next one needs, or back to the board.
///
/// Assumption: its side of the bus is that of a board, clocks and words' gaps included.
class FunctionUnit : public sc_core::sc_module {
 public:
  /// What it finds around it; all is kept by reference.
  struct Site {
    VersaBus& bus;
    std::uint64_t base;  ///< its bus address
    UnitGroup& group;
    const UnitGroups& groups;
    const sc_core::sc_event& start;
    int number;  ///< of the masters: boards, then units
    const HandoverObserver& handovers;
  };

  /// `board` is what its side of the bus is like.
  FunctionUnit(const sc_core::sc_module_name& name, const FunctionUnitParameters& parameters,
               const Kvm02Parameters& board, const Site& site);

  tlm_utils::simple_initiator_socket<FunctionUnit> bus_master;
  tlm_utils::simple_target_socket<FunctionUnit> bus_port;

  /// Bytes of addresses from its own on: its RAM, then its mailbox.
  [[nodiscard]] static std::uint64_t address_bytes(const FunctionUnitParameters& parameters) {
    return static_cast<std::uint64_t>(parameters.ram_bytes) + k_long_bytes;
  }

  /// As a master of its bus.
  [[nodiscard]] const AccessLaw& access_law() const { return access_law_; }

  [[nodiscard]] std::uint64_t mailbox() const { return mailbox_; }
  [[nodiscard]] int number() const { return site_.number; }

  /// Its number on the bus, told before the simulation starts.
  void set_master(int master) { processor_.tell(site_.bus, master); }

  /// As Processor::observe_pauses.
  void observe_pauses(PauseObserver observer) { processor_.observe_pauses(std::move(observer)); }

  /// Keeps a place for an errand, to the beginning of its service.
  void reserve() {
    ++places_taken_;
    ++load_;
  }

  /// Places that were taken before the kernel's present instant.
  [[nodiscard]] int places_taken() const;

  /// Errands that it had before the kernel's present instant, from their grant until they are
  /// handed on.
  [[nodiscard]] int load() const;

  /// Takes an errand whose message has just arrived.
  void take(Errand& errand);

  /// Up to here its states are known, perhaps ahead of the kernel.
  [[nodiscard]] Instant accounted() const { return processor_.accounted(); }

  /// As Kvm02::statistics.
  [[nodiscard]] FunctionUnitStatistics statistics(Instant instant) const;

 private:
  void run();
  [[nodiscard]] Errand& next_errand();
  void hand_on(Errand& errand, std::uint32_t results);
  void send(int to);

  void access(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);

  Site site_;
  AccessLaw access_law_;
  Duration access_time_;
  std::uint64_t mailbox_;
  Processor processor_;
  Message message_;
  std::vector<Errand*> queue_;  // in the order in which they are served
  sc_core::sc_event arrived_;
  sc_core::sc_event granted_;
  PlaceGrant grant_;
  int places_taken_ = 0;
  int load_ = 0;
  Instant last_begin_{-1};  // of a service
  Instant last_end_{-1};    // when what it has served was handed on
  std::int64_t errands_ = 0;
  ErrandWait queued_;
  int longest_queue_ = 0;
};

}  // namespace maquette::models
