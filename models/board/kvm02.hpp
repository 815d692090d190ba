#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>
#include <cstdint>
#include <optional>
#include <systemc>
#include <tlm>
#include <vector>

#include "models/board/allotment.hpp"
#include "models/board/allotment_parameters.hpp"
#include "models/board/board_statistics.hpp"
#include "models/board/database_cache.hpp"
#include "models/board/kvm02_parameters.hpp"
#include "models/board/pixel_source.hpp"
#include "models/board/shared_memory.hpp"
#include "models/board/work_cost.hpp"
#include "models/bus/bus_burst.hpp"
#include "models/bus/instant.hpp"
#include "models/bus/versabus.hpp"
#include "models/bus/versabus_parameters.hpp"
#include "models/display/pixel_format.hpp"

namespace maquette::models {

/// Where boards find the frame memory: bus address of its first byte, pixels per row, their bytes.
struct FrameWindow {
  std::uint64_t base;
  int width;
  PixelFormat format;
};

/// Which units of the allotment a board takes: first, first + step, first + 2 step, ..., or those
/// that it claims.
struct BoardShare {
  const PixelAllotment& allotment;
  std::int64_t first;
  std::int64_t step;
  std::optional<ClaimParameters> claim;
};

/// Where a board sits on its bus, and what it finds there.
struct BoardSite {
  VersaBus& bus;
  BusMasterPlace place;
  std::uint64_t ram_base;  ///< of its own RAM
  FrameWindow frame;
  SharedWindow shared;
};

/// A KVM02 board (M68KVM02): a processor that spends the time of its work and writes its pixels as
/// a bus master, and 128 KiB of RAM with a second port on the bus.
///
/// It runs ahead of the kernel on its private memory: the kernel sees only its bus transactions.
/// A shared database is read as often as the work says, spread evenly over the time of the work.
/// Assumption: the reads go through the database in order, since only their number matters.
///
/// Assumption: nobody uses the second port while the board computes, so the two do not conflict.
class Kvm02 : public sc_core::sc_module {
 public:
  /// Attaches the board to the bus of its site, as a master and as a slave. Once `start` is
  /// notified it takes its share of the pixels of `source`. Bus, allotment, source and start are
  /// kept by reference.
  Kvm02(const sc_core::sc_module_name& name, const Kvm02Parameters& parameters,
        const BoardSite& site, const BoardShare& share, PixelSource& source,
        const sc_core::sc_event& start);

  tlm_utils::simple_initiator_socket<Kvm02> bus_master;
  tlm_utils::simple_target_socket<Kvm02> ram_port;

  [[nodiscard]] int master() const { return master_; }

  /// When it ended its last work, if it has.
  [[nodiscard]] std::optional<Instant> finished() const { return statistics_.finished; }

  [[nodiscard]] std::int64_t pixels_taken() const { return statistics_.pixels; }

  /// Up to here its states are known, perhaps ahead of the kernel.
  [[nodiscard]] Instant accounted() const { return accounted_; }

  /// States from the start of the frame up to `instant`, not before `accounted()`. A board that has
  /// not finished counts as computing until its next request and as waiting from then on.
  [[nodiscard]] BoardStatistics statistics(Instant instant) const;

 private:
  void run();
  [[nodiscard]] bool enter_unit(std::int64_t unit);
  [[nodiscard]] bool has_pixel();
  [[nodiscard]] bool gather();
  void append(const SynthesizedPixel& pixel);
  void write_pixels();
  void finish();

  [[nodiscard]] std::int64_t claim_unit();
  [[nodiscard]] bool test_and_set();
  [[nodiscard]] std::uint32_t read_shared(std::uint64_t address);
  void write_shared(std::uint64_t address, std::uint32_t value);

  void compute(const firmware::Work& work);
  void read_database(Duration computing, std::int64_t loads);
  void compute(Clocks clocks);
  void transact(BusBurst& burst);
  void settle(const BusTransaction& transaction, Instant end);
  [[nodiscard]] Instant own_time() const;

  void access_ram(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned debug_ram(tlm::tlm_generic_payload& payload);

  Kvm02Parameters parameters_;
  WorkCost cost_;
  Period clock_;
  BoardSite site_;
  BoardShare share_;
  PixelSource& source_;
  const sc_core::sc_event& start_;
  int master_;
  std::vector<unsigned char> ram_;
  std::optional<DatabaseCache> cache_;  // of a shared database
  std::uint64_t database_offset_ = 0;   // of the next read

  Instant accounted_{};   // up to here the states are known
  Duration computing_{};  // since then, before the next request
  std::int64_t unit_ = 0;
  std::int64_t next_pixel_ = 0;  // of the unit
  std::int64_t unit_end_ = 0;
  BusBurst pixels_{tlm::TLM_WRITE_COMMAND};
  BusBurst database_{tlm::TLM_READ_COMMAND};
  BusBurst shared_read_{tlm::TLM_READ_COMMAND};
  BusBurst shared_write_{tlm::TLM_WRITE_COMMAND};
  bool started_ = false;
  Instant started_at_{};
  BoardStatistics statistics_;
};

}  // namespace maquette::models
