#include "models/board/kvm02.hpp"

#include <algorithm>
#include <stdexcept>

#include "models/bus/bus_error.hpp"
#include "models/bus/kernel_time.hpp"
#include "models/bus/memory_cells.hpp"
#include "models/display/frame_memory.hpp"

namespace maquette::models {

namespace {

constexpr std::size_t k_long_bytes = 4;
constexpr std::size_t k_stack_bytes = std::size_t{1} << 20U;  // pixel sources compute on it

void append_long(std::uint32_t value, std::vector<unsigned char>& bytes) {
  std::size_t next = bytes.size();
  bytes.resize(next + k_long_bytes);
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes[next++] = static_cast<unsigned char>(value >> shift);
  }
}

std::uint32_t long_of(const std::vector<unsigned char>& bytes) {
  std::uint32_t value = 0;
  for (std::size_t byte = 0; byte < k_long_bytes; ++byte) {
    value = value << 8U | bytes[byte];
  }
  return value;
}

constexpr int k_most_tries = 100'000;
constexpr const char* k_starved =
    "boards that try to claim a unit keep the one that holds the lock off the bus for ever; "
    "raise allotment.claim.spin";

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
             const BoardSite& site, const BoardShare& share, PixelSource& source,
             const sc_core::sc_event& start)
    : sc_module(name),
      bus_master("bus_master"),
      ram_port("ram_port"),
      parameters_(parameters),
      cost_(parameters),
      clock_(Period::of_frequency(parameters.clock_hz)),
      site_(site),
      share_(share),
      source_(source),
      start_(start),
      master_(
          site.bus.attach_master(bus_master, {this->name(), site.place, access_law(parameters)})),
      ram_(checked_ram_bytes(parameters)) {
  site.bus.attach_slave(ram_port, {this->name(), site.ram_base, ram_.size()});
  ram_port.register_b_transport(this, &Kvm02::access_ram);
  ram_port.register_transport_dbg(this, &Kvm02::debug_ram);
  pixels_.transaction.gap = clock_.times(parameters.word_gap_clocks);
  pixels_.transaction.block = parameters.release == ReleasePolicy::block;
  if (parameters.database == DatabasePlace::shared) {
    cache_.emplace(parameters.database_cache_bytes, site.shared.database_bytes);
    database_.transaction.item_accesses =
        static_cast<std::int64_t>(k_long_bytes / site.bus.word_bytes());
  }
  if (!cache_) {  // nothing but the writes needs the bus: it is given one burst after the other
    pixels_.transaction.follow_up = [this](Instant end) -> std::optional<Duration> {
      settle(pixels_.transaction, end);
      return gather() ? std::optional(computing_) : std::nullopt;
    };
  }
  SC_HAS_PROCESS(Kvm02);
  SC_THREAD(run);
  set_stack_size(k_stack_bytes);
}

// ---- the processor ----

void Kvm02::run() {
  sc_core::wait(start_);
  started_ = true;
  started_at_ = accounted_ = kernel_now();
  compute(source_.preprocessing());
  statistics_.preprocessing = own_time() - started_at_;
  if (share_.claim) {
    while (enter_unit(claim_unit())) {
      write_pixels();
    }
  } else if (enter_unit(share_.first)) {
    write_pixels();
  }
  finish();
}

// False behind the last unit.
bool Kvm02::enter_unit(std::int64_t unit) {
  if (unit >= share_.allotment.units()) {
    return false;
  }
  unit_ = unit;
  next_pixel_ = share_.allotment.first_pixel(unit);
  unit_end_ = share_.allotment.first_pixel(unit + 1);
  return true;
}

// Whether the board has another pixel without claiming one.
bool Kvm02::has_pixel() {
  while (next_pixel_ == unit_end_) {
    if (share_.claim || !enter_unit(unit_ + share_.step)) {
      return false;
    }
  }
  return true;
}

// Synthesises pixels until some are due to be written; false when none is left.
bool Kvm02::gather() {
  pixels_.bytes.clear();
  pixels_.transaction.addresses.clear();
  while (has_pixel()) {
    // A copy: other boards ask for theirs while this one reads a shared database.
    const SynthesizedPixel pixel = source_.pixel(next_pixel_++);
    compute(pixel.work);
    ++statistics_.pixels;
    statistics_.work.add(pixel.work);
    statistics_.work.add(pixel.rays);
    append(pixel);
    if (parameters_.pixel_write == PixelWrite::pixel || !has_pixel() ||
        share_.allotment.position(next_pixel_).row != pixel.row) {
      pixels_.aim(pixels_.transaction.addresses.front());
      return true;
    }
  }
  return false;
}

void Kvm02::write_pixels() {
  while (gather()) {
    transact(pixels_);
  }
}

void Kvm02::append(const SynthesizedPixel& pixel) {
  const std::uint64_t index =
      static_cast<std::uint64_t>(pixel.row) * static_cast<std::uint64_t>(site_.frame.width) +
      pixel.column;
  for (unsigned byte = 0; byte < FrameMemory::k_pixel_bytes; byte += site_.bus.word_bytes()) {
    pixels_.transaction.addresses.push_back(site_.frame.base + FrameMemory::k_pixel_bytes * index +
                                            byte);
  }
  append_long(site_.frame.format.written(pixel.rgb, pixel.depth), pixels_.bytes);
}

void Kvm02::finish() {
  site_.bus.retire(master_);
  sc_core::wait(to_sc_time(computing_));
  statistics_.compute += computing_;
  computing_ = Duration::zero();
  accounted_ = kernel_now();
  statistics_.finished = accounted_;
}

// ---- a shared database ----

void Kvm02::compute(const firmware::Work& work) {
  if (!cache_) {
    computing_ += cost_.duration(work);
    return;
  }
  const std::int64_t loads = cache_->misses(work[firmware::Operation::load]);
  const Duration time = cost_.duration(work, loads);
  if (loads == 0) {
    computing_ += time;
  } else {
    read_database(time, loads);
  }
}

// One burst for all loads, whose gaps the bus keeps: the time is cut into one part before each load
// and one after the last; the first parts are a tick longer where it does not divide.
void Kvm02::read_database(Duration computing, std::int64_t loads) {
  const Duration part = computing / (loads + 1);
  const std::int64_t longer = (computing % (loads + 1)).count();
  BusTransaction& transaction = database_.transaction;
  transaction.gap = part;
  transaction.longer_gaps = std::max<std::int64_t>(longer - 1, 0);
  transaction.addresses.clear();
  const auto end = static_cast<std::uint64_t>(site_.shared.database_bytes);
  const unsigned word = site_.bus.word_bytes();
  for (std::int64_t load = 0; load < loads; ++load) {
    for (unsigned byte = 0; byte < k_long_bytes; byte += word) {
      transaction.addresses.push_back(site_.shared.database() + database_offset_);
      database_offset_ += word;
      database_offset_ = database_offset_ < end ? database_offset_ : 0;
    }
  }
  database_.bytes.resize(transaction.addresses.size() * word);
  database_.aim(transaction.addresses.front());
  computing_ += part + (longer > 0 ? k_tick : Duration::zero());
  transact(database_);
  statistics_.database_words += transaction.accesses;
  computing_ = part;
}

// ---- units on demand ----

std::int64_t Kvm02::claim_unit() {
  const Instant begin = own_time();
  for (int tries = 1; !test_and_set(); ++tries) {
    if (tries == k_most_tries) {
      SC_REPORT_ERROR("/maquette/kvm02", k_starved);
    }
    ++statistics_.failed_tries;
    compute(share_.claim->spin_clocks * share_.step);
  }
  compute(share_.claim->read_clocks);
  const std::uint32_t unit = read_shared(site_.shared.next_unit());
  compute(share_.claim->update_clocks);
  write_shared(site_.shared.next_unit(), unit + 1);
  compute(share_.claim->unlock_clocks);
  shared_write_.bytes.assign(site_.bus.word_bytes(), 0);
  shared_write_.aim(site_.shared.lock());
  transact(shared_write_);
  compute(share_.claim->finish_clocks);
  ++statistics_.claims;
  statistics_.claiming += own_time() - begin;
  return unit;
}

// A byte takes a whole word of the bus.
bool Kvm02::test_and_set() {
  shared_read_.transaction.test_and_set = true;
  shared_read_.transaction.modify = clock_.times(share_.claim->modify_clocks);
  shared_read_.bytes.resize(site_.bus.word_bytes());
  shared_read_.aim(site_.shared.lock());
  transact(shared_read_);
  shared_read_.transaction.test_and_set = false;
  return (shared_read_.bytes.front() & SharedWindow::k_taken) == 0;
}

// The words of a long word follow one another without a gap.
std::uint32_t Kvm02::read_shared(std::uint64_t address) {
  shared_read_.bytes.resize(k_long_bytes);
  shared_read_.aim(address);
  transact(shared_read_);
  return long_of(shared_read_.bytes);
}

void Kvm02::write_shared(std::uint64_t address, std::uint32_t value) {
  shared_write_.bytes.clear();
  append_long(value, shared_write_.bytes);
  shared_write_.aim(address);
  transact(shared_write_);
}

// ---- time ----

void Kvm02::compute(Clocks clocks) { computing_ += clock_.times(clocks); }

// Computes for as long as is due, then does the burst.
void Kvm02::transact(BusBurst& burst) {
  BusTransaction& transaction = burst.transaction;
  transaction.runs_ahead = true;
  sc_core::sc_time delay = to_sc_time(computing_);
  bus_master->b_transport(burst.payload, delay);
  require_answer(burst.payload, transaction, name());
  if (!transaction.follow_up) {
    settle(transaction, kernel_now());
  }
}

// Puts a burst that has ended into the board's states.
void Kvm02::settle(const BusTransaction& transaction, Instant end) {
  statistics_.compute += computing_ + transaction.gaps();
  statistics_.wait_grant += transaction.waited;
  statistics_.transfer += transaction.transferred;
  statistics_.words += transaction.accesses;
  if (transaction.longest_wait > statistics_.longest_wait) {
    statistics_.longest_wait = transaction.longest_wait;
    statistics_.longest_wait_request = transaction.longest_wait_request;
  }
  computing_ = Duration::zero();
  accounted_ = end;
}

// The instant that its processor has reached.
Instant Kvm02::own_time() const { return accounted_ + computing_; }

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

unsigned Kvm02::debug_ram(tlm::tlm_generic_payload& payload) { return access_cells(ram_, payload); }

}  // namespace maquette::models
