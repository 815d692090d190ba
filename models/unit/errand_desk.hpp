#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <systemc>
#include <vector>

#include "models/board/pixel_dispatcher.hpp"
#include "models/bus/versabus.hpp"
#include "models/unit/errand.hpp"
#include "models/unit/function_unit.hpp"
#include "models/unit/itinerary.hpp"
#include "models/unit/message.hpp"
#include "models/unit/pixel_leg.hpp"
#include "models/unit/unit_group.hpp"

namespace maquette::models {

/// Where a board of a machine with units hands out errands, and takes back what comes.
///
/// The board's processor does what is its own of one pixel after the other, sends messages as a bus
/// master, and writes each pixel that is done. While a pixel waits for a place or is with a unit it
/// goes on with another one, the first that is ready, before it begins a further one; so many as
/// may be in flight. What comes back is written into its RAM by the unit, without its processor.
///
/// Assumption: the board knows of what has come, and of places, without looking; changing over to
/// another pixel costs nothing.
class ErrandDesk {
 public:
  /// What it finds around it; all is kept by reference.
  struct Site {
    VersaBus& bus;
    std::uint64_t mailbox;  ///< bus address in the board's RAM
    const UnitGroups& groups;
    const Itinerary& itinerary;
    LegSource& legs;
    const HandoverObserver& handovers;
  };

  /// `board` is its number. Throws std::invalid_argument for a board with nothing in flight.
  ErrandDesk(int board, const Kvm02Parameters& parameters, int in_flight, const Site& site);

  ErrandDesk(const ErrandDesk&) = delete;
  ErrandDesk& operator=(const ErrandDesk&) = delete;
  ErrandDesk(ErrandDesk&&) = delete;
  ErrandDesk& operator=(ErrandDesk&&) = delete;
  ~ErrandDesk() = default;

  /// Has all pixels of the board made, in its process.
  void run(const DispatchedBoard& board);

  /// How long the board had nothing to do until a unit of a kind had done something: served the
  /// errand with which it went on, or given it a place.
  [[nodiscard]] const std::array<Duration, k_unit_kind_count>& waits() const { return waits_; }

 private:
  void make_ready(Errand& errand);
  [[nodiscard]] Errand& begin(const SynthesizedPixel& pixel);
  void go_on(Errand& errand, const DispatchedBoard& board);
  void send(Errand& errand, Processor& processor);
  void wait_for_units(Processor& processor);

  Site site_;
  int board_;
  Processor* processor_ = nullptr;  // of the board
  PlaceGrant grant_;
  ErrandHome home_;
  Message message_;
  std::vector<std::unique_ptr<Errand>> errands_;  // as many as may be in flight
  std::vector<Errand*> unused_;                   // of these
  std::vector<Errand*> ready_;                    // in the order in which they are gone on with
  sc_core::sc_event something_ready_;
  std::int64_t begun_ = 0;
  std::array<Duration, k_unit_kind_count> waits_{};
};

}  // namespace maquette::models
