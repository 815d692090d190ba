#pragma once

#include <tlm_utils/simple_target_socket.h>
#include <cstdint>
#include <functional>
#include <optional>
#include <systemc>
#include <tlm>
#include <utility>
#include <vector>

#include "models/bus/instant.hpp"
#include "models/display/depth_map.hpp"
#include "models/display/frame_memory_parameters.hpp"
#include "models/display/memory_access.hpp"
#include "models/display/picture.hpp"
#include "models/display/pixel_format.hpp"
#include "models/display/video_slots.hpp"
#include "models/display/video_timing.hpp"

namespace maquette::models {

/// One write into the frame memory: when it was done, and what the pixel was from then on.
struct PixelWriteRecord {
  Instant instant;
  std::uint32_t pixel;  ///< in row-major order
  std::uint32_t rgb;    ///< as picture gives it
};

/// The frame memory: planes of red, green and blue bits, perhaps of depth, a bus port and a video
/// port. On the bus, pixel p of the row-major order is the four bytes from 4 p on (PixelFormat).
///
/// Assumption: with several bus ports the memory is interleaved so that they do not delay one
/// another; the video reader's slots delay each of them.
///
/// Where it compares depths, the colour of a pixel waits until its depth has come, which is read
/// and compared first: colour and depth are kept unless what is there is nearer. Assumption:
/// reading it takes another access; there is one place to wait in, so that the words of two pixels
/// must not mix, for which whoever builds the machine cares.
///
/// Where boards keep the pixels that they own it is what the video reader gathers from them, and
/// has no bus ports. Assumption: the reader has a bus of its own to their RAMs, as Fuchs and
/// Johnson's (paper, [16]), and there dynamic RAMs with a serial port (in Texas Instruments' patent
/// EP 0107010 of 1982), so that a pixel is shown as soon as it is written and no slot delays
/// anybody.
///
/// Assumption: before the frame the video port clears the memory to the background during one
/// field, at no cost to the boards. A write is done at the end of its memory access.
class FrameMemory : public sc_core::sc_module {
 public:
  static constexpr unsigned k_pixel_bytes = 4;

  /// Throws std::invalid_argument as PixelFormat, VideoTiming and VideoSlots, and for depths that
  /// are to be compared and have no planes. `background` is
  /// 0xRRGGBB. `keep_log` remembers every write.
  FrameMemory(const sc_core::sc_module_name& name, const FrameMemoryParameters& parameters,
              const VideoTiming& timing, std::uint32_t background, bool keep_log);

  sc_core::sc_vector<tlm_utils::simple_target_socket<FrameMemory>> bus_ports;

  [[nodiscard]] std::uint64_t size_bytes() const { return stored_.size() * k_pixel_bytes; }

  /// What the memory holds at the end.
  [[nodiscard]] Picture picture() const;

  /// The depths it holds at the end; 0 without depth planes. The background is farthest.
  [[nodiscard]] DepthMap depths() const;

  /// What it held at `instant`. Throws std::logic_error when no log was kept.
  [[nodiscard]] Picture picture_at(Instant instant) const;

  /// What it held before the first write.
  [[nodiscard]] Picture background() const;

  /// Every write in the order of time. Throws std::logic_error when no log was kept.
  [[nodiscard]] const std::vector<PixelWriteRecord>& log() const;

  /// A board that owns a pixel has written it: `written` as PixelFormat has it, from `instant` on.
  /// In the order of time.
  void keep(int column, int row, std::uint32_t written, Instant instant);

  /// Every access to the planes from now on is shown to `observer` when it is known, in the order
  /// in which those of one port follow one another.
  void observe(std::function<void(const MemoryAccess&)> observer) {
    observers_.push_back(std::move(observer));
  }

  [[nodiscard]] const FrameMemoryParameters& parameters() const { return parameters_; }

  /// Whether every byte of the pixel has been written exactly once / not at all.
  [[nodiscard]] bool written_once(int column, int row) const {
    return write_counts_[place_of(column, row)] == k_once_each;
  }
  [[nodiscard]] bool untouched(int column, int row) const {
    return write_counts_[place_of(column, row)] == 0;
  }

 private:
  static constexpr std::uint8_t k_once_each = 0x11;

  [[nodiscard]] std::size_t place_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(parameters_.width) +
           static_cast<std::size_t>(column);
  }
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned transport_dbg(tlm::tlm_generic_payload& payload);
  [[nodiscard]] bool accept(tlm::tlm_generic_payload& payload) const;
  void remember(const PixelWriteRecord& write);
  [[nodiscard]] Instant access_end(Instant asked) const;
  [[nodiscard]] Instant end_of(const tlm::tlm_generic_payload& payload, Instant asked) const;
  void take(std::uint64_t address, const unsigned char* data, unsigned bytes, Instant done);
  void write(std::uint64_t address, const unsigned char* data, unsigned bytes);
  void write_unless_farther(std::uint64_t address, const unsigned char* data, unsigned bytes);
  void count_write(std::uint64_t address, unsigned bytes);
  void read(std::uint64_t address, unsigned char* data, unsigned bytes) const;

  FrameMemoryParameters parameters_;
  std::optional<VideoSlots> slots_;
  PixelFormat format_;
  std::uint32_t background_;
  std::vector<std::uint32_t> stored_;       // as PixelFormat, bits without a plane zero
  std::uint32_t waiting_ = 0;               // colour of the pixel whose depth is compared next
  std::vector<std::uint8_t> write_counts_;  // of red-green and blue, saturating, a nibble each
  std::optional<std::vector<PixelWriteRecord>> log_;
  std::vector<std::function<void(const MemoryAccess&)>> observers_;
};

}  // namespace maquette::models
