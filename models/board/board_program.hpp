#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "firmware/arithmetic/work.hpp"
#include "models/board/mc68000/mc68000.hpp"

namespace maquette::models {

/// A board's program as it lies in the board's RAM.
struct ProgramEntry {
  std::uint32_t start;      ///< address of its first instruction
  std::uint32_t stack;      ///< stack pointer at the start
  std::uint32_t synthesis;  ///< address of the routine that begins when preprocessing is done
};

/// Adds the routines that the host executes in the processor's place; they count what they do in
/// the Work, which has to outlive them. May be empty.
using HostRoutines = std::function<void(mc68000::NativeCalls& routines, firmware::Work& work)>;

/// What a board's program comes to next.
struct ProgramEvent {
  enum class Kind { access, synthesis, end };

  Kind kind;
  mc68000::Account account;  ///< at the start of the instruction; accesses before this included
  firmware::Work work;       ///< of the host's routines since the last event
  mc68000::BusRequest request;
  mc68000::Stop stop;
};

/// How many programs may be executed by the host at once.
class ProgramSlots {
 public:
  explicit ProgramSlots(int count) : free_(count) {}

  void take();
  void give_back();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int free_;
};

/// A board's program, executed instruction by instruction on a thread of the host, ahead of
/// simulated time. What it does depends on nothing but its RAM and the answers that it gets, so
/// that events are the same however threads run: it waits for the answer of a read, a write is
/// taken as answered.
class BoardProgram final : private mc68000::ExternalBus {
 public:
  /// Begins at once. The RAM, which nobody else touches meanwhile, and the slots have to outlive
  /// it.
  BoardProgram(mc68000::Ram ram, const ProgramEntry& entry, const HostRoutines& host_routines,
               ProgramSlots& slots);
  BoardProgram(const BoardProgram&) = delete;
  BoardProgram& operator=(const BoardProgram&) = delete;
  /// Ends the program where it is.
  ~BoardProgram() override;

  /// Waits for the next event. There is none after the end. Throws firmware::StopRequested.
  ProgramEvent next();

  /// Answers the read that was the last event.
  void answer(std::uint32_t value);

 private:
  void run(const ProgramEntry& entry);
  mc68000::Stop run_unless_abandoned();
  mc68000::BusReply access(const mc68000::BusRequest& request,
                           const mc68000::Account& account) override;

  ProgramEvent event(ProgramEvent::Kind kind, const mc68000::Account& account);
  void put(const ProgramEvent& event);

  mc68000::Mc68000 processor_;
  mc68000::NativeCalls routines_;
  firmware::Work work_{};
  ProgramSlots& slots_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<ProgramEvent> events_;
  std::optional<std::uint32_t> answer_;
  bool abandoned_ = false;
  std::thread thread_;  // last, since it works on the others
};

}  // namespace maquette::models
