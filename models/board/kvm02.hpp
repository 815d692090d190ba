#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>
#include <cstdint>
#include <optional>
#include <systemc>
#include <tlm>
#include <vector>

#include "models/board/board_share.hpp"
#include "models/board/board_statistics.hpp"
#include "models/board/database_reader.hpp"
#include "models/board/instruction_processor.hpp"
#include "models/board/kvm02_parameters.hpp"
#include "models/board/own_pixels.hpp"
#include "models/board/pixel_dispatcher.hpp"
#include "models/board/pixel_meter.hpp"
#include "models/board/pixel_source.hpp"
#include "models/board/pixel_writer.hpp"
#include "models/board/processor.hpp"
#include "models/board/program_setup.hpp"
#include "models/board/shared_memory.hpp"
#include "models/board/unit_claims.hpp"
#include "models/bus/access_law.hpp"
#include "models/bus/instant.hpp"
#include "models/bus/versabus.hpp"

namespace maquette::models {

/// What a board finds on its bus.
struct BoardSite {
  VersaBus& bus;
  FrameWindow frame;
  SharedWindow shared;
  std::optional<OwnPixels> own_pixels = {};  ///< when the board keeps the pixels that it owns
};

/// A KVM02 board (M68KVM02): a processor that spends the time of its work and writes its pixels as
/// a bus master, or keeps them, and 128 KiB of RAM with a second port on the bus. Whoever makes it
/// binds both sockets and tells the board its number on the bus.
///
/// Assumption: nobody uses the second port while the board computes, so the two do not conflict.
class Kvm02 : public sc_core::sc_module {
 public:
  /// Once `start` is notified the board takes its share of the pixels of `source`. Bus, allotment,
  /// source and start are kept by reference. Throws std::invalid_argument for parameters that make
  /// no board.
  Kvm02(const sc_core::sc_module_name& name, const Kvm02Parameters& parameters,
        const BoardSite& site, const BoardShare& share, PixelSource& source,
        const sc_core::sc_event& start);

  tlm_utils::simple_initiator_socket<Kvm02> bus_master;
  tlm_utils::simple_target_socket<Kvm02> ram_port;

  /// As a master of its bus.
  [[nodiscard]] AccessLaw access_law() const;
  [[nodiscard]] std::uint64_t ram_bytes() const { return ram_.size(); }
  [[nodiscard]] const std::vector<unsigned char>& ram() const { return ram_; }

  /// Has it execute a program, whose RAM so far is `resident`, in place of taking its pixels from
  /// the source, which is asked for them all the same: for what they are to be and what they cost
  /// the firmware. The slots are kept by reference. Before the simulation starts.
  void execute(const ProgramEntry& entry, const HostRoutines& host_routines,
               const std::vector<RamPart>& resident, ProgramSlots& slots);

  /// Has its pixels made by `dispatcher`, which is lent what the board has. It writes each pixel as
  /// soon as it is made. Before the simulation starts.
  void dispatch(PixelDispatcher dispatcher);

  /// What each of its pixels took is shown to `observer` when it is written, as of the board with a
  /// number. Before the simulation starts.
  void observe_pixels(int board, const PixelObserver& observer) {
    pixel_meter_.emplace(board, observer);
  }

  /// As Processor::observe_pauses.
  void observe_pauses(PauseObserver observer) { processor_.observe_pauses(std::move(observer)); }

  /// Its number on the bus, told before the simulation starts.
  void set_master(int master) { master_ = master; }

  /// When it ended its last work, if it has.
  [[nodiscard]] std::optional<Instant> finished() const { return processor_.finished(); }

  [[nodiscard]] std::int64_t pixels_taken() const { return pixels_; }

  /// Up to here its states are known, perhaps ahead of the kernel.
  [[nodiscard]] Instant accounted() const { return processor_.accounted(); }

  /// States from the start of the frame up to `instant`, not before `accounted()`. A board that has
  /// not finished counts as computing until its next request and as waiting from then on.
  [[nodiscard]] BoardStatistics statistics(Instant instant) const;

 private:
  void run();
  void make_pixels();
  void run_dispatcher();
  [[nodiscard]] const SynthesizedPixel& take();
  [[nodiscard]] SynthesizedPixel synthesize();
  [[nodiscard]] bool gather();
  [[nodiscard]] bool is_due(int row);
  void compute(const firmware::Work& work);
  void tell_written();
  void write_pixels();
  void keep_pixels(const OwnPixels& own_pixels);
  void finish();
  void run_program();
  void check_written(std::uint64_t address, std::uint32_t value);
  void take_pixel(std::int64_t number, std::uint32_t bytes);

  void access_ram(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned debug_ram(tlm::tlm_generic_payload& payload);

  Kvm02Parameters parameters_;
  VersaBus& bus_;
  int master_ = k_nobody;
  BoardShare share_;
  PixelSource& source_;
  const sc_core::sc_event& start_;
  std::vector<unsigned char> ram_;

  Processor processor_;
  ShareCursor cursor_;
  PixelWriter writer_;
  std::optional<UnitClaims> claims_;        // of units on demand
  std::optional<DatabaseReader> database_;  // of a shared one

  PixelDispatcher dispatcher_;  // of a board that shares its pixels' process out

  std::optional<OwnPixels> own_pixels_;    // of a board that keeps them
  std::optional<PixelMeter> pixel_meter_;  // of one whose pixels are observed

  // Of a board that executes its program.
  FrameWindow frame_;
  SharedWindow shared_;
  ProgramEntry entry_{};
  HostRoutines host_routines_;
  ProgramSlots* slots_ = nullptr;
  std::optional<InstructionProcessor> executing_;
  std::optional<BoardProgram> program_;  // while it runs
  std::uint32_t first_word_ = 0;         // of the pixel that is being written

  Duration preprocessing_{};
  std::int64_t pixels_ = 0;
  WorkTotals work_;
};

}  // namespace maquette::models
