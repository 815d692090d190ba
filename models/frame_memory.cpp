#include "models/frame_memory.hpp"

#include <algorithm>
#include <stdexcept>

#include "models/bus_transaction.hpp"
#include "models/kernel_time.hpp"

namespace maquette::models {

namespace {

constexpr int k_component_bits = 8;
constexpr std::uint32_t k_full_component = 0xFF;
constexpr std::uint8_t k_once_each = 0x11;
constexpr std::uint8_t k_full_count = 0xF;

std::uint32_t component_mask(int bits) {
  if (bits < 1 || bits > k_component_bits) {
    throw std::invalid_argument("a component of the frame memory has 1 to 8 bits");
  }
  return (k_full_component << (k_component_bits - bits)) & k_full_component;
}

std::uint32_t mask_of_planes(const FrameMemoryParameters& parameters) {
  return component_mask(parameters.red_bits) << 16U | component_mask(parameters.green_bits) << 8U |
         component_mask(parameters.blue_bits);
}

// The video converters' full scale is the plane's full code.
std::uint32_t full_scale(std::uint32_t component, int bits) {
  const std::uint32_t highest = (1U << static_cast<unsigned>(bits)) - 1;
  const std::uint32_t code = component >> static_cast<unsigned>(k_component_bits - bits);
  return (code * k_full_component + highest / 2) / highest;
}

unsigned component_shift(std::uint64_t byte) { return 16U - 8U * static_cast<unsigned>(byte); }

}  // namespace

FrameMemory::FrameMemory(const sc_core::sc_module_name& name,
                         const FrameMemoryParameters& parameters, const VideoTiming& timing,
                         std::uint32_t background, bool keep_log)
    : sc_module(name),
      bus_port("bus_port"),
      parameters_(parameters),
      plane_mask_(mask_of_planes(parameters)),
      background_(background & plane_mask_),
      unhindered_(to_sc_time(parameters.access_time)) {
  if (parameters.access_time < Duration::zero()) {
    throw std::invalid_argument("the access time of the frame memory must not be negative");
  }
  if (parameters.video_priority) {
    slots_.emplace(timing, parameters);
  }
  const auto pixels =
      static_cast<std::size_t>(parameters.width) * static_cast<std::size_t>(parameters.height);
  stored_.assign(pixels, background_);
  write_counts_.assign(pixels, 0);
  if (keep_log) {
    log_.emplace();
  }
  bus_port.register_b_transport(this, &FrameMemory::b_transport);
  bus_port.register_transport_dbg(this, &FrameMemory::transport_dbg);
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
  const Instant begun = slots_ ? slots_->earliest_access(asked) : asked;
  const Instant done = begun + parameters_.access_time;
  delay += begun == asked ? unhindered_ : to_sc_time(done - asked);
  const std::uint64_t address = payload.get_address();
  const unsigned bytes = payload.get_data_length();
  if (payload.is_read()) {
    read(address, payload.get_data_ptr(), bytes);
    return;
  }
  write(address, payload.get_data_ptr(), bytes);
  count_write(address, bytes);
  if (log_) {
    for (auto pixel = address / k_pixel_bytes; pixel * k_pixel_bytes < address + bytes; ++pixel) {
      log_->push_back({done, static_cast<std::uint32_t>(pixel),
                       shown(stored_[static_cast<std::size_t>(pixel)])});
    }
  }
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
    if (byte < 3) {
      const unsigned shift = component_shift(byte);
      const std::uint32_t component = static_cast<std::uint32_t>(data[offset]) << shift;
      stored_[pixel] = (stored_[pixel] & ~(k_full_component << shift)) | (component & plane_mask_);
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
    data[offset] = byte < 3 ? static_cast<unsigned char>(stored_[pixel] >> component_shift(byte))
                            : static_cast<unsigned char>(0);
  }
}

std::uint32_t FrameMemory::shown(std::uint32_t stored) const {
  return full_scale(stored >> 16U & k_full_component, parameters_.red_bits) << 16U |
         full_scale(stored >> 8U & k_full_component, parameters_.green_bits) << 8U |
         full_scale(stored & k_full_component, parameters_.blue_bits);
}

Picture FrameMemory::picture() const {
  Picture picture{parameters_.width, parameters_.height, {}};
  picture.pixels.resize(stored_.size());
  std::transform(stored_.begin(), stored_.end(), picture.pixels.begin(),
                 [this](std::uint32_t stored) { return shown(stored); });
  return picture;
}

Picture FrameMemory::background() const {
  return {parameters_.width, parameters_.height,
          std::vector<std::uint32_t>(stored_.size(), shown(background_))};
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

bool FrameMemory::written_once(int column, int row) const {
  return write_counts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(parameters_.width) +
                       static_cast<std::size_t>(column)] == k_once_each;
}

bool FrameMemory::untouched(int column, int row) const {
  return write_counts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(parameters_.width) +
                       static_cast<std::size_t>(column)] == 0;
}

}  // namespace maquette::models
