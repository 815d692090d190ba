#pragma once

#include <cstdint>
#include <functional>

#include "models/board/board_program.hpp"
#include "models/board/own_pixels.hpp"
#include "models/board/processor.hpp"
#include "models/board/program_time.hpp"
#include "models/board/shared_memory.hpp"
#include "models/board/starvation_watch.hpp"
#include "models/bus/bus_burst.hpp"

namespace maquette::models {

/// A board's processor that executes the board's program: lets the time of its instructions pass,
/// with the wait states of the RAM and its refresh, and does each access off the board on the bus,
/// at its cycle within its instruction.
class InstructionProcessor {
 public:
  /// Called with each word or byte that the program has written off the board.
  using Observer = std::function<void(std::uint64_t address, std::uint32_t value)>;

  /// Bus and processor are kept by reference. Throws as ProgramTime.
  InstructionProcessor(const Kvm02Parameters& parameters, const VersaBus& bus,
                       const SharedWindow& shared, Processor& processor, Observer written);

  /// Runs the program to its end, in the board's SystemC process. Reports an error when it stops
  /// for another reason than that it has come to its end.
  void run(BoardProgram& program);

  /// Has words that are written from `base` to `end` stay on the board, at these clocks of its RAM.
  void keep_writes(std::uint64_t base, std::uint64_t end, const OwnPixelClocks& clocks) {
    kept_ = {base, end, clocks};
  }

  /// From the start to the first pixel's work.
  [[nodiscard]] Duration preprocessing() const { return preprocessing_; }
  /// What the processor had done with its time when the first pixel's work began.
  [[nodiscard]] const ProcessorTime& before_pixels() const { return before_pixels_; }
  [[nodiscard]] std::int64_t locks_taken() const { return locks_taken_; }
  [[nodiscard]] std::int64_t failed_tries() const { return failed_tries_; }
  /// Read of a database that boards share.
  [[nodiscard]] std::int64_t database_words() const { return database_words_; }

 private:
  /// Addresses at which writes stay on the board.
  struct KeptWrites {
    std::uint64_t base = 0;
    std::uint64_t end = 0;
    OwnPixelClocks clocks{};
  };

  void spend(const ProgramEvent& event);
  void access(const ProgramEvent& event, BoardProgram& program);
  void keep(const ProgramEvent& event);
  void write(const mc68000::BusRequest& request);
  std::uint32_t read(const mc68000::BusRequest& request);
  std::uint32_t test_and_set(const mc68000::BusRequest& request);

  ProgramTime time_;
  SharedWindow shared_;
  unsigned word_bytes_;
  Processor& processor_;
  StarvationWatch watch_;
  Observer written_;
  KeptWrites kept_;
  Duration spent_{};
  Duration preprocessing_{};
  ProcessorTime before_pixels_;
  BusBurst read_{tlm::TLM_READ_COMMAND};
  BusBurst write_{tlm::TLM_WRITE_COMMAND};
  BusBurst test_and_set_{tlm::TLM_READ_COMMAND};
  std::int64_t locks_taken_ = 0;
  std::int64_t failed_tries_ = 0;
  std::int64_t database_words_ = 0;
};

}  // namespace maquette::models
