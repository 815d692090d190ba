#include "models/kvm02.hpp"

#include <algorithm>
#include <stdexcept>

#include "models/bus_error.hpp"
#include "models/frame_memory.hpp"
#include "models/kernel_time.hpp"

namespace maquette::models {

namespace {

constexpr std::size_t k_stack_bytes = std::size_t{1} << 20U;  // pixel sources compute on it

AccessLaw access_law(const Kvm02Parameters& parameters) {
  return {Period::of_frequency(parameters.clock_hz), parameters.access_clocks,
          parameters.access_slack};
}

std::size_t checked_ram_bytes(const Kvm02Parameters& parameters) {
  if (parameters.ram_bytes <= 0) {
    throw std::invalid_argument("a board must have RAM");
  }
  if (parameters.word_gap_clocks < 0 || parameters.dual_port_access < Duration::zero()) {
    throw std::invalid_argument("times of a board must not be negative");
  }
  return static_cast<std::size_t>(parameters.ram_bytes);
}

}  // namespace

Kvm02::Kvm02(const sc_core::sc_module_name& name, const Kvm02Parameters& parameters,
             const BusMasterPlace& place, VersaBus& bus, std::uint64_t ram_base,
             const FrameWindow& frame, const BoardShare& share, PixelSource& source,
             const sc_core::sc_event& start)
    : sc_module(name),
      bus_master("bus_master"),
      ram_port("ram_port"),
      parameters_(parameters),
      cost_(parameters),
      word_gap_(access_law(parameters).clock.times(parameters.word_gap_clocks)),
      bus_(bus),
      frame_(frame),
      share_(share),
      source_(source),
      start_(start),
      master_(bus.attach_master(bus_master, {this->name(), place, access_law(parameters)})),
      ram_(checked_ram_bytes(parameters)) {
  bus.attach_slave(ram_port, {this->name(), ram_base, ram_.size()});
  ram_port.register_b_transport(this, &Kvm02::access_ram);
  ram_port.register_transport_dbg(this, &Kvm02::debug_ram);
  transaction_.gap = word_gap_;
  transaction_.block = parameters.release == ReleasePolicy::block;
  transaction_.runs_ahead = true;
  payload_.set_extension(&transaction_);
  payload_.set_command(tlm::TLM_WRITE_COMMAND);
  SC_HAS_PROCESS(Kvm02);
  SC_THREAD(run);
  set_stack_size(k_stack_bytes);
}

// ---- the processor ----

void Kvm02::run() {
  sc_core::wait(start_);
  started_ = true;
  started_at_ = accounted_ = kernel_now();
  statistics_.preprocessing = cost_.duration(source_.preprocessing());
  computing_ = statistics_.preprocessing;
  for (std::int64_t unit = share_.first; unit < share_.allotment.units(); unit += share_.step) {
    take_unit(unit);
  }
  finish();
}

void Kvm02::take_unit(std::int64_t unit) {
  const std::int64_t end = share_.allotment.first_pixel(unit + 1);
  for (std::int64_t index = share_.allotment.first_pixel(unit); index < end; ++index) {
    take(source_.pixel(index));
  }
}

void Kvm02::take(const SynthesizedPixel& pixel) {
  if (!bytes_.empty() && pixel.row != row_) {
    write_pixels();
  }
  computing_ += cost_.duration(pixel.work);
  ++statistics_.pixels;
  statistics_.work.add(pixel.work);
  statistics_.work.add(pixel.rays);
  append(pixel);
  if (parameters_.pixel_write == PixelWrite::pixel) {
    write_pixels();
  }
}

void Kvm02::append(const SynthesizedPixel& pixel) {
  row_ = pixel.row;
  const std::uint64_t index =
      static_cast<std::uint64_t>(pixel.row) * static_cast<std::uint64_t>(frame_.width) +
      pixel.column;
  for (unsigned byte = 0; byte < FrameMemory::k_pixel_bytes; byte += bus_.word_bytes()) {
    transaction_.addresses.push_back(frame_.base + FrameMemory::k_pixel_bytes * index + byte);
  }
  bytes_.push_back(static_cast<unsigned char>(pixel.rgb >> 16U));
  bytes_.push_back(static_cast<unsigned char>(pixel.rgb >> 8U));
  bytes_.push_back(static_cast<unsigned char>(pixel.rgb));
  bytes_.push_back(0);
}

void Kvm02::write_pixels() {
  payload_.set_address(transaction_.addresses.front());
  payload_.set_data_ptr(bytes_.data());
  payload_.set_data_length(static_cast<unsigned>(bytes_.size()));
  payload_.set_streaming_width(static_cast<unsigned>(bytes_.size()));
  sc_core::sc_time delay = to_sc_time(computing_);
  bus_master->b_transport(payload_, delay);
  require_answer(payload_, transaction_, name());
  statistics_.compute += computing_ + word_gap_ * (transaction_.accesses - 1);
  statistics_.wait_grant += transaction_.waited;
  statistics_.transfer += transaction_.transferred;
  statistics_.words += transaction_.accesses;
  if (transaction_.longest_wait > statistics_.longest_wait) {
    statistics_.longest_wait = transaction_.longest_wait;
    statistics_.longest_wait_request = transaction_.longest_wait_request;
  }
  computing_ = Duration::zero();
  accounted_ = kernel_now();
  bytes_.clear();
  transaction_.addresses.clear();
}

void Kvm02::finish() {
  if (!bytes_.empty()) {
    write_pixels();
  }
  bus_.retire(master_);
  sc_core::wait(to_sc_time(computing_));
  statistics_.compute += computing_;
  computing_ = Duration::zero();
  accounted_ = kernel_now();
  statistics_.finished = accounted_;
}

BoardStatistics Kvm02::statistics(Instant instant) const {
  BoardStatistics statistics = statistics_;
  if (!started_) {
    return statistics;
  }
  if (statistics.compute + statistics.wait_grant + statistics.transfer !=
      accounted_ - started_at_) {
    throw std::logic_error(std::string(name()) + ": states do not sum to the elapsed time");
  }
  const Duration rest = instant - accounted_;
  if (statistics.finished) {
    statistics.idle = rest;
  } else {
    const Duration computed = std::min(rest, computing_);
    statistics.compute += computed;
    statistics.wait_grant += rest - computed;
  }
  return statistics;
}

// ---- the RAM's second port ----

void Kvm02::access_ram(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  debug_ram(payload);
  delay += to_sc_time(parameters_.dual_port_access);
}

unsigned Kvm02::debug_ram(tlm::tlm_generic_payload& payload) {
  const std::uint64_t address = payload.get_address();
  const std::uint64_t bytes = payload.get_data_length();
  if (address >= ram_.size() || bytes > ram_.size() - address) {
    payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    return 0;
  }
  unsigned char* ram = ram_.data() + address;
  unsigned char* data = payload.get_data_ptr();
  if (payload.is_read()) {
    std::copy_n(ram, bytes, data);
  } else {
    std::copy_n(data, bytes, ram);
  }
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
  return static_cast<unsigned>(bytes);
}

}  // namespace maquette::models
