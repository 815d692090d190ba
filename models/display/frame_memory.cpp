#include "models/display/frame_memory.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "models/bus/bus_transaction.hpp"
#include "models/bus/kernel_time.hpp"

namespace maquette::models {

namespace {

constexpr std::uint32_t k_byte = 0xFF;
constexpr std::uint16_t k_farthest = 0xFFFF;
constexpr std::uint8_t k_full_count = 0xF;

// The first byte of a pixel is the highest of its four.
unsigned byte_shift(std::uint64_t byte) {
  return 8U * (FrameMemory::k_pixel_bytes - 1 - static_cast<unsigned>(byte));
}

/// Whether the last byte of a pixel is among these, with which its depth is complete.
bool holds_depth(std::uint64_t address, unsigned bytes) {
  return address % FrameMemory::k_pixel_bytes + bytes >= FrameMemory::k_pixel_bytes;
}

}  // namespace

FrameMemory::FrameMemory(const sc_core::sc_module_name& name,
                         const FrameMemoryParameters& parameters, const VideoTiming& timing,
                         std::uint32_t background, bool keep_log)
    : sc_module(name),
      bus_ports("bus_port"),
      parameters_(parameters),
      format_(parameters),
      background_(format_.written(background, k_farthest) & format_.kept()) {
  if (parameters.access_time < Duration::zero()) {
    throw std::invalid_argument("the access time of the frame memory must not be negative");
  }
  if (compares_depth(parameters) && parameters.depth_bits == 0) {
    throw std::invalid_argument("depths that are compared need depth planes");
  }
  if (has_video_slots(parameters)) {
    slots_.emplace(timing, parameters);
  }
  const auto pixels =
      static_cast<std::size_t>(parameters.width) * static_cast<std::size_t>(parameters.height);
  stored_.assign(pixels, background_);
  write_counts_.assign(pixels, 0);
  if (keep_log) {
    log_.emplace();
  }
  if (parameters.ports < 1) {
    throw std::invalid_argument("the frame memory has at least one bus port");
  }
  bus_ports.init(is_distributed(parameters) ? 0 : static_cast<std::size_t>(parameters.ports));
  for (auto& port : bus_ports) {
    port.register_b_transport(this, &FrameMemory::b_transport);
    port.register_transport_dbg(this, &FrameMemory::transport_dbg);
  }
}

bool FrameMemory::accept(tlm::tlm_generic_payload& payload) const {
  const std::uint64_t address = payload.get_address();
  const unsigned bytes = payload.get_data_length();
  if (address >= size_bytes() || bytes > size_bytes() - address) {
    payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    return false;
  }
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
  return true;
}

void FrameMemory::b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  if (!accept(payload)) {
    return;
  }
  const auto* strobe = payload.get_extension<BusStrobe>();
  const Instant asked = strobe != nullptr ? strobe->instant : kernel_now() + to_duration(delay);
  const Instant done = end_of(payload, asked);
  delay += to_sc_time(done - asked);
  const std::uint64_t address = payload.get_address();
  const unsigned bytes = payload.get_data_length();
  if (payload.is_read()) {
    read(address, payload.get_data_ptr(), bytes);
    return;
  }
  take(address, payload.get_data_ptr(), bytes, done);
}

void FrameMemory::keep(int column, int row, std::uint32_t written, Instant instant) {
  const std::uint64_t pixel =
      static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(parameters_.width) +
      static_cast<std::uint64_t>(column);
  std::array<unsigned char, k_pixel_bytes> bytes{};
  for (unsigned byte = 0; byte < k_pixel_bytes; ++byte) {
    bytes[byte] = static_cast<unsigned char>(written >> byte_shift(byte));
  }
  take(pixel * k_pixel_bytes, bytes.data(), k_pixel_bytes, instant);
}

void FrameMemory::take(std::uint64_t address, const unsigned char* data, unsigned bytes,
                       Instant done) {
  if (compares_depth(parameters_)) {
    write_unless_farther(address, data, bytes);
  } else {
    write(address, data, bytes);
  }
  count_write(address, bytes);
  if (log_) {
    for (auto pixel = address / k_pixel_bytes; pixel * k_pixel_bytes < address + bytes; ++pixel) {
      remember({done, static_cast<std::uint32_t>(pixel),
                format_.colour(stored_[static_cast<std::size_t>(pixel)])});
    }
  }
}

Instant FrameMemory::access_end(Instant asked) const {
  const Instant begun = slots_ ? slots_->earliest_access(asked) : asked;
  for (const auto& observer : observers_) {
    observer({asked, begun});
  }
  return begun + parameters_.access_time;
}

Instant FrameMemory::end_of(const tlm::tlm_generic_payload& payload, Instant asked) const {
  const bool compares = compares_depth(parameters_) && payload.is_write() &&
                        holds_depth(payload.get_address(), payload.get_data_length());
  return access_end(compares ? access_end(asked) : asked);
}

// One backplane may be ahead of another.
void FrameMemory::remember(const PixelWriteRecord& write) {
  const auto after = std::find_if(
      log_->rbegin(), log_->rend(),
      [&write](const PixelWriteRecord& other) { return other.instant <= write.instant; });
  log_->insert(after.base(), write);
}

unsigned FrameMemory::transport_dbg(tlm::tlm_generic_payload& payload) {
  if (!accept(payload)) {
    return 0;
  }
  if (payload.is_read()) {
    read(payload.get_address(), payload.get_data_ptr(), payload.get_data_length());
  } else {
    write(payload.get_address(), payload.get_data_ptr(), payload.get_data_length());
  }
  return payload.get_data_length();
}

void FrameMemory::write(std::uint64_t address, const unsigned char* data, unsigned bytes) {
  for (unsigned offset = 0; offset < bytes; ++offset) {
    const auto pixel = static_cast<std::size_t>((address + offset) / k_pixel_bytes);
    const std::uint64_t byte = (address + offset) % k_pixel_bytes;
    const unsigned shift = byte_shift(byte);
    const std::uint32_t written = static_cast<std::uint32_t>(data[offset]) << shift;
    stored_[pixel] = (stored_[pixel] & ~(k_byte << shift)) | (written & format_.kept());
  }
}

void FrameMemory::write_unless_farther(std::uint64_t address, const unsigned char* data,
                                       unsigned bytes) {
  for (unsigned offset = 0; offset < bytes; ++offset) {
    const std::uint64_t byte = (address + offset) % k_pixel_bytes;
    const unsigned shift = byte_shift(byte);
    waiting_ = (waiting_ & ~(k_byte << shift)) | static_cast<std::uint32_t>(data[offset]) << shift;
    if (byte == k_pixel_bytes - 1) {
      std::uint32_t& stored = stored_[static_cast<std::size_t>((address + offset) / k_pixel_bytes)];
      const std::uint32_t kept = waiting_ & format_.kept();
      stored = format_.depth(kept) <= format_.depth(stored) ? kept : stored;
    }
  }
}

void FrameMemory::count_write(std::uint64_t address, unsigned bytes) {
  for (std::uint64_t half = address / 2; half < (address + bytes + 1) / 2; ++half) {
    std::uint8_t& counts = write_counts_[static_cast<std::size_t>(half / 2)];
    const unsigned shift = half % 2 == 0 ? 0 : 4;
    if (((counts >> shift) & k_full_count) != k_full_count) {
      counts = static_cast<std::uint8_t>(counts + (1U << shift));
    }
  }
}

void FrameMemory::read(std::uint64_t address, unsigned char* data, unsigned bytes) const {
  for (unsigned offset = 0; offset < bytes; ++offset) {
    const auto pixel = static_cast<std::size_t>((address + offset) / k_pixel_bytes);
    const std::uint64_t byte = (address + offset) % k_pixel_bytes;
    data[offset] = static_cast<unsigned char>(stored_[pixel] >> byte_shift(byte));
  }
}

Picture FrameMemory::picture() const {
  Picture picture{parameters_.width, parameters_.height, {}};
  picture.pixels.resize(stored_.size());
  std::transform(stored_.begin(), stored_.end(), picture.pixels.begin(),
                 [this](std::uint32_t stored) { return format_.colour(stored); });
  return picture;
}

DepthMap FrameMemory::depths() const {
  DepthMap depths{parameters_.width, parameters_.height, {}};
  depths.values.resize(stored_.size());
  std::transform(stored_.begin(), stored_.end(), depths.values.begin(),
                 [this](std::uint32_t stored) { return format_.depth(stored); });
  return depths;
}

Picture FrameMemory::background() const {
  return {parameters_.width, parameters_.height,
          std::vector<std::uint32_t>(stored_.size(), format_.colour(background_))};
}

Picture FrameMemory::picture_at(Instant instant) const {
  Picture picture = background();
  for (const PixelWriteRecord& write : log()) {
    if (write.instant > instant) {
      break;
    }
    picture.pixels[write.pixel] = write.rgb;
  }
  return picture;
}

const std::vector<PixelWriteRecord>& FrameMemory::log() const {
  if (!log_) {
    throw std::logic_error("the frame memory kept no log of its writes");
  }
  return *log_;
}

}  // namespace maquette::models
