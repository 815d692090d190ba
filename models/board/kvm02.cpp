#include "models/board/kvm02.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "models/bus/kernel_time.hpp"
#include "models/bus/memory_cells.hpp"
#include "models/display/frame_memory.hpp"

namespace maquette::models {

namespace {

constexpr std::size_t k_stack_bytes = std::size_t{1} << 20U;  // pixel sources compute on it

/// Of two words, with the time between them that they have on the bus as well.
Duration keeping_time(const OwnPixels& own_pixels, const Kvm02Parameters& parameters,
                      const Processor& processor) {
  const OwnPixelClocks clocks = own_pixels.clocks(parameters);
  return processor.time_of(clocks.first_word + clocks.second_word) +
         processor.clock().times(parameters.word_gap_clocks);
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
      bus_(site.bus),
      share_(share),
      source_(source),
      start_(start),
      ram_(checked_ram_bytes(parameters)),
      processor_(parameters, bus_master, this->name()),
      cursor_(share),
      writer_(site.frame, site.bus.word_bytes()),
      own_pixels_(site.own_pixels),
      frame_(site.frame),
      shared_(site.shared) {
  ram_port.register_b_transport(this, &Kvm02::access_ram);
  ram_port.register_transport_dbg(this, &Kvm02::debug_ram);
  BusTransaction& writing = writer_.burst().transaction;
  writing.gap = processor_.clock().times(parameters.word_gap_clocks);
  writing.block = keeps_bus(parameters.release);
  const unsigned word_bytes = site.bus.word_bytes();
  if (share.claim) {
    claims_.emplace(*share.claim, share.step, site.shared, site.bus, processor_);
  }
  if (is_shared(parameters.database)) {
    database_.emplace(parameters.database_cache_bytes, site.shared, word_bytes, processor_);
  } else {  // nothing but the writes needs the bus: it is given one burst after the other
    writing.follow_up = [this](Instant end) -> std::optional<Duration> {
      processor_.account(writer_.burst().transaction, end);
      tell_written();
      return gather() ? std::optional(processor_.computing()) : std::nullopt;
    };
  }
  if (own_pixels_) {  // which are shown in the order of time
    processor_.promise_nothing();
  }
  SC_HAS_PROCESS(Kvm02);
  SC_THREAD(run);
  set_stack_size(k_stack_bytes);
}

AccessLaw Kvm02::access_law() const {
  return {processor_.clock(), parameters_.access_clocks, parameters_.access_slack};
}

// ---- a frame ----

void Kvm02::run() {
  sc_core::wait(start_);
  processor_.start();
  if (executing_) {
    run_program();
    finish();
    return;
  }
  const Instant started = processor_.now();
  compute(source_.preprocessing());
  preprocessing_ = processor_.now() - started;
  if (pixel_meter_) {
    pixel_meter_->begin(processor_.spent());
  }
  make_pixels();
  finish();
}

void Kvm02::make_pixels() {
  if (dispatcher_) {
    run_dispatcher();
  } else if (own_pixels_) {
    if (cursor_.enter(share_.first)) {
      keep_pixels(*own_pixels_);
    }
  } else if (claims_) {
    while (cursor_.enter(claims_->next())) {
      write_pixels();
    }
  } else if (cursor_.enter(share_.first)) {
    write_pixels();
  }
}

void Kvm02::write_pixels() {
  while (gather()) {
    processor_.transact(writer_.burst());
    if (!writer_.burst().transaction.follow_up) {
      tell_written();
    }
  }
}

void Kvm02::tell_written() {
  if (pixel_meter_) {
    pixel_meter_->write(processor_.spent());
  }
}

// ---- pixels that others make as well ----

void Kvm02::dispatch(PixelDispatcher dispatcher) {
  dispatcher_ = std::move(dispatcher);
  processor_.tell(bus_, master_);
  writer_.burst().transaction.follow_up = nullptr;
}

void Kvm02::run_dispatcher() {
  bool has_unit = claims_ || cursor_.enter(share_.first);
  const auto has_pixel = [&] {
    while (has_unit && !cursor_.has_pixel()) {
      has_unit = claims_ && cursor_.enter(claims_->next());
    }
    return has_unit;
  };
  const auto write = [&](const SynthesizedPixel& pixel) {
    if (pixel_meter_) {
      pixel_meter_->compute({pixel.column, pixel.row}, processor_.spent());
    }
    if (own_pixels_) {
      processor_.compute(keeping_time(*own_pixels_, parameters_, processor_));
      processor_.pass();
      own_pixels_->keep({pixel.column, pixel.row}, frame_.format.written(pixel.rgb, pixel.depth),
                        processor_.now(), ram_);
    } else {
      writer_.clear();
      writer_.append(pixel);
      writer_.aim();
      processor_.transact(writer_.burst());
    }
    tell_written();
  };
  dispatcher_(
      {processor_, has_pixel, [this]() -> const SynthesizedPixel& { return take(); }, write});
}

// ---- a program ----

void Kvm02::execute(const ProgramEntry& entry, const HostRoutines& host_routines,
                    const std::vector<RamPart>& resident, ProgramSlots& slots) {
  for (const RamPart& part : resident) {
    if (part.address + part.bytes.size() > ram_.size()) {
      throw std::invalid_argument("a board's RAM has no room for its program");
    }
    std::copy(part.bytes.begin(), part.bytes.end(), ram_.begin() + part.address);
  }
  entry_ = entry;
  host_routines_ = host_routines;
  slots_ = &slots;
  executing_.emplace(
      parameters_, bus_, shared_, processor_,
      [this](std::uint64_t address, std::uint32_t value) { check_written(address, value); });
  if (own_pixels_) {
    executing_->keep_writes(frame_.base, shared_.base, own_pixels_->clocks(parameters_));
  }
}

void Kvm02::run_program() {
  const mc68000::Ram ram{ram_.data(), static_cast<std::uint32_t>(ram_.size())};
  program_.emplace(ram, entry_, host_routines_, *slots_);
  executing_->run(*program_);
  program_.reset();
  preprocessing_ = executing_->preprocessing();
}

// A pixel is written when its second word is. Behind the frame memory is what boards share.
void Kvm02::check_written(std::uint64_t address, std::uint32_t value) {
  constexpr unsigned k_word_bits = 16;
  if (address < frame_.base || address >= shared_.base) {
    return;
  }
  const std::uint64_t offset = address - frame_.base;
  if (offset % FrameMemory::k_pixel_bytes == 0) {
    first_word_ = value;
  } else {
    take_pixel(static_cast<std::int64_t>(offset / FrameMemory::k_pixel_bytes),
               first_word_ << k_word_bits | value);
  }
}

// The program and the firmware of the host agree in every pixel.
void Kvm02::take_pixel(std::int64_t number, std::uint32_t bytes) {
  const PixelPosition position{static_cast<int>(number % frame_.width),
                               static_cast<int>(number / frame_.width)};
  const SynthesizedPixel& pixel = source_.pixel(share_.allotment.index(position));
  if (frame_.format.written(pixel.rgb, pixel.depth) != bytes) {
    throw std::logic_error(std::string(name()) + ": the program has another pixel (" +
                           std::to_string(position.column) + ", " + std::to_string(position.row) +
                           ") than the firmware");
  }
  if (own_pixels_) {
    own_pixels_->keep(position, bytes, processor_.now(), ram_);
  }
  if (pixel_meter_) {
    if (pixels_ == 0) {
      pixel_meter_->begin(executing_->before_pixels());
    }
    pixel_meter_->compute(position, processor_.spent());
    tell_written();
  }
  ++pixels_;
  work_.add(pixel.work);
  work_.add(pixel.rays);
}

// ---- pixels of the source ----

const SynthesizedPixel& Kvm02::take() {
  const SynthesizedPixel& pixel = source_.pixel(cursor_.take());
  ++pixels_;
  work_.add(pixel.work);
  work_.add(pixel.rays);
  return pixel;
}

// Of the pixel a copy: other boards ask for theirs while this one reads a shared database.
SynthesizedPixel Kvm02::synthesize() {
  SynthesizedPixel pixel = take();
  compute(pixel.work);
  if (pixel_meter_) {
    pixel_meter_->compute({pixel.column, pixel.row}, processor_.spent());
  }
  return pixel;
}

void Kvm02::keep_pixels(const OwnPixels& own_pixels) {
  const Duration writing = keeping_time(own_pixels, parameters_, processor_);
  while (cursor_.has_pixel()) {
    const SynthesizedPixel pixel = synthesize();
    processor_.compute(writing);
    processor_.pass();
    own_pixels.keep({pixel.column, pixel.row}, frame_.format.written(pixel.rgb, pixel.depth),
                    processor_.now(), ram_);
    tell_written();
  }
}

// Synthesises pixels until some are due to be written; false when none is left.
//
// It runs in whichever process has the bus decide: the board's own, or, as the follow-up of a
// burst, the one whose call made the bus go ahead, which is another board's process or the bus's
// own. So one board's pixel may be synthesised on another's stack, before the kernel comes to the
// instant of its work; the source may even have had it from a thread of the host. Pixels depend
// neither on the instant nor on the board.
bool Kvm02::gather() {
  writer_.clear();
  while (cursor_.has_pixel()) {
    const SynthesizedPixel pixel = synthesize();
    writer_.append(pixel);
    if (is_due(pixel.row)) {
      writer_.aim();
      return true;
    }
  }
  return false;
}

// Whether the pixels gathered are to be written, the last of which is in `row`.
bool Kvm02::is_due(int row) {
  return !keeps_line(parameters_.pixel_write) || !cursor_.has_pixel() || cursor_.row() != row;
}

void Kvm02::compute(const firmware::Work& work) {
  if (database_) {
    database_->compute(work);
  } else {
    processor_.compute(processor_.take_on(work));
  }
}

void Kvm02::finish() {
  bus_.retire(master_);
  processor_.finish();
}

BoardStatistics Kvm02::statistics(Instant instant) const {
  BoardStatistics statistics = processor_.statistics(instant);
  statistics.preprocessing = preprocessing_;
  statistics.pixels = pixels_;
  statistics.work = work_;
  if (claims_) {
    statistics.claiming = claims_->time();
    statistics.claims = claims_->claims();
    statistics.failed_tries = claims_->failed_tries();
  }
  if (database_) {
    statistics.database_words = database_->words();
  }
  if (executing_) {
    statistics.claims = executing_->locks_taken();
    statistics.failed_tries = executing_->failed_tries();
    statistics.database_words = executing_->database_words();
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
