#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <systemc>
#include <utility>
#include <vector>

#include "models/board/allotment.hpp"
#include "models/board/kvm02.hpp"
#include "models/board/pixel_source.hpp"
#include "models/board/shared_memory.hpp"
#include "models/bus/versabus.hpp"
#include "models/display/frame_memory.hpp"
#include "models/display/video_reader.hpp"
#include "models/display/video_timing.hpp"
#include "models/machine/host.hpp"
#include "models/machine/machine_addresses.hpp"
#include "models/machine/machine_parameters.hpp"
#include "models/machine/machine_statistics.hpp"
#include "models/machine/machine_units.hpp"

namespace maquette::models {

/// A part of an image.
struct ImageRange {
  std::size_t first;
  std::size_t end;
};

/// What a frame is made of, besides the machine and its pixels.
struct FrameSetup {
  PixelRectangle useful_zone;    ///< every pixel of it is written once, no other is
  std::uint32_t background = 0;  ///< 0xRRGGBB, of the pixels outside
  std::vector<std::vector<unsigned char>> images;  ///< code and database by board; empty: none
  std::uint32_t image_address = 0;                 ///< of their first byte, in a board's RAM
  std::uint32_t pixel_address = 0;  ///< in a board's RAM, of its own pixels, when it keeps them
  /// The parts of the images that the host loads; all, when not given.
  std::optional<std::vector<ImageRange>> loaded;
  std::optional<ProgramSetup> program;                   ///< when boards execute theirs
  std::vector<unsigned char> shared_database;            ///< when boards have no copies
  std::optional<std::vector<ImageRange>> shared_loaded;  ///< of that, as `loaded`
  LegSource* legs = nullptr;        ///< of the source's pixels; of a machine with units
  std::uint32_t reply_address = 0;  ///< in a board's RAM, of what units hand back
  std::vector<std::vector<unsigned char>> unit_images;  ///< database by unit; empty: none
  std::vector<std::vector<ImageRange>> unit_loaded;     ///< by unit, as `loaded`; empty: all
  bool keep_log = false;  ///< of the writes, for pictures at an instant
};

/// The CCETT prototype: KVM02 boards, host and frame memory on a VERSAbus, or on as many backplanes
/// as the frame memory has ports, board b on backplane b mod ports. Elaborated by its
/// constructor, which alone binds sockets: modules do not bind themselves. A plain `sc_start` runs
/// it until all boards are done, since nothing in it is periodic.
class CcettMachine : public sc_core::sc_module {
 public:
  /// `source` is kept by reference; it has the pixels of the PixelAllotment that parameters and
  /// useful zone make. Throws
  /// std::invalid_argument for parameters that make no machine, or images that do not fit the
  /// boards.
  CcettMachine(const sc_core::sc_module_name& name, const MachineParameters& parameters,
               PixelSource& source, const FrameSetup& setup);

  /// Exact for a machine that has finished, also on a kernel that ran longer; of a run that was
  /// interrupted, up to the furthest instant that its bus has reached.
  [[nodiscard]] MachineStatistics statistics() const;

  /// Asserts that each pixel of the useful zone has been written exactly once and no other pixel at
  /// all. Throws std::logic_error that names the first pixel that breaks it.
  void verify_frame() const;

  /// When the boards started, if the host has loaded them: the frame's instant 0.
  [[nodiscard]] std::optional<Instant> started() const { return host_->statistics().finished; }

  /// How many pixels the boards have taken so far.
  [[nodiscard]] std::int64_t pixels_taken() const;

  /// When the last board was done, if all are.
  [[nodiscard]] std::optional<Instant> finished() const;

  /// Every access from now on is shown to `observer`, with the number of the board, of a function
  /// unit after them, or of the host at the end as its master; in the order of time on each
  /// backplane.
  void observe_bus(const std::function<void(const BusAccess&)>& observer);

  /// Every line of the backplanes is shown to `observer`, with the number of its backplane, as
  /// VersaBus::observe_lines does.
  void observe_lines(const std::function<void(std::size_t backplane, const LineState&)>& observer);

  /// Elaborates the video reader for a span of the frame, or until all boards are done. Once,
  /// before the simulation starts.
  VideoReader& watch_video(Duration from, Duration to);

  /// Every access to the planes of the frame memory is shown to `observer`, as
  /// FrameMemory::observe does.
  void observe_memory(std::function<void(const MemoryAccess&)> observer) {
    frame_memory_.observe(std::move(observer));
  }

  /// What each pixel took is shown to `observer` when it is written, in the order of each board.
  /// Before the simulation starts.
  void observe_pixels(const PixelObserver& observer);

  /// When a board or a function unit has nothing to do for a while is shown to `observer`, with its
  /// number as in observe_bus. Before the simulation starts.
  void observe_pauses(
      const std::function<void(std::size_t master, bool pauses, Instant from)>& observer);

  /// What boards and function units hand over to one another is shown to `observer`, with numbers
  /// as in observe_bus. Before the simulation starts.
  void observe_handovers(const HandoverObserver& observer);

  [[nodiscard]] const Kvm02& board(std::size_t number) const { return *boards_[number]; }
  [[nodiscard]] const FrameMemory& frame_memory() const { return frame_memory_; }
  [[nodiscard]] const VideoTiming& video_timing() const { return timing_; }
  [[nodiscard]] std::size_t backplanes() const { return buses_.size(); }
  [[nodiscard]] const VersaBus& bus(std::size_t backplane = 0) const { return *buses_[backplane]; }

 private:
  // In the order in which they bind their sockets, which numbers masters: the boards of each bus,
  // then the host. A board's number on its bus is returned.
  std::vector<Backplane> make_buses(const MachineParameters& parameters,
                                    const MachineAddresses& addresses);
  void make_shared_memory(const MachineParameters& parameters, const MachineAddresses& addresses,
                          std::size_t bytes);
  int make_board(std::size_t index, const MachineParameters& parameters,
                 const MachineAddresses& addresses, VersaBus& bus, PixelSource& source);
  void make_units(const MachineParameters& parameters, const MachineAddresses& addresses,
                  const FrameSetup& setup, Backplane& backplane);
  void make_host(const MachineParameters& parameters, std::vector<Backplane> backplanes);

  [[nodiscard]] Instant furthest_known() const;
  [[nodiscard]] std::size_t last_master() const;

  VideoParameters video_;
  PixelRectangle zone_;
  PixelAllotment allotment_;
  sc_core::sc_event start_;            // of the boards, by the host
  std::optional<ProgramSlots> slots_;  // of the boards' programs
  VideoTiming timing_;
  std::vector<std::unique_ptr<VersaBus>> buses_;
  FrameMemory frame_memory_;
  std::optional<PixelStore> own_pixels_;  // of boards that keep them
  std::optional<SharedMemory> shared_memory_;
  std::vector<std::unique_ptr<Kvm02>> boards_;
  std::optional<MachineUnits> units_;  // of a machine that has some
  std::unique_ptr<Host> host_;
  std::unique_ptr<VideoReader> video_reader_;
};

}  // namespace maquette::models
