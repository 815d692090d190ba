#include "models/board/board_program.hpp"

#include <chrono>

#include "firmware/arithmetic/stop_request.hpp"

namespace maquette::models {

namespace {

/// Events that may wait, and how many of them are left when the program goes on. So the host's
/// threads meet seldom: a switch between them costs as much as executing a small pixel.
constexpr std::size_t k_most_events = 256;
constexpr std::size_t k_fewer_events = 128;

/// So many events that wait are told at once, others when the program needs an answer or ends.
constexpr std::size_t k_told_events = 64;

bool needs_nothing(const ProgramEvent& event) {
  return event.kind == ProgramEvent::Kind::synthesis ||
         (event.kind == ProgramEvent::Kind::access &&
          event.request.kind == mc68000::BusRequest::Kind::write);
}

/// The host executes so much in some tenth of a second.
constexpr std::uint64_t k_cycles_between_looks = 10'000'000;
constexpr std::chrono::milliseconds k_between_looks{100};

}  // namespace

void ProgramSlots::take() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return free_ > 0; });
  --free_;
}

void ProgramSlots::give_back() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++free_;
  }
  changed_.notify_one();
}

BoardProgram::BoardProgram(mc68000::Ram ram, const ProgramEntry& entry,
                           const HostRoutines& host_routines, ProgramSlots& slots)
    : processor_(ram, *this), slots_(slots) {
  routines_.add(entry.synthesis, [this](mc68000::ExecutionUnit& unit) {
    unit.counter.settle();
    const std::lock_guard<std::mutex> lock(mutex_);
    put(event(ProgramEvent::Kind::synthesis, unit.counter.account()));
  });
  if (host_routines) {
    host_routines(routines_, work_);
  }
  processor_.use(routines_);
  thread_ = std::thread([this, entry] { run(entry); });
}

BoardProgram::~BoardProgram() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    abandoned_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BoardProgram::run(const ProgramEntry& entry) {
  processor_.registers().program_counter = entry.start;
  processor_.registers().stack() = entry.stack;
  slots_.take();
  const mc68000::Stop stop = run_unless_abandoned();
  slots_.give_back();
  const std::lock_guard<std::mutex> lock(mutex_);
  ProgramEvent end = event(ProgramEvent::Kind::end, processor_.account());
  end.stop = stop;
  put(end);
}

mc68000::Stop BoardProgram::run_unless_abandoned() {
  while (true) {
    const mc68000::Stop stop =
        processor_.run({processor_.account().cycles + k_cycles_between_looks});
    const std::lock_guard<std::mutex> lock(mutex_);
    if (abandoned_ || stop.reason != mc68000::StopReason::cycle_limit) {
      return stop;
    }
  }
}

ProgramEvent BoardProgram::event(ProgramEvent::Kind kind, const mc68000::Account& account) {
  ProgramEvent event{};
  event.kind = kind;
  event.account = account;
  event.work = work_;
  work_ = {};
  return event;
}

void BoardProgram::put(const ProgramEvent& event) {
  events_.push_back(event);
  if (!needs_nothing(event) || events_.size() == k_told_events) {
    changed_.notify_all();
  }
}

ProgramEvent BoardProgram::next() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!changed_.wait_for(lock, k_between_looks, [this] { return !events_.empty(); })) {
    firmware::end_if_requested();
  }
  const ProgramEvent event = events_.front();
  events_.pop_front();
  if (events_.size() == k_fewer_events) {
    changed_.notify_all();
  }
  return event;
}

void BoardProgram::answer(std::uint32_t value) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    answer_ = value;
  }
  changed_.notify_all();
}

// The slot is another program's while this one waits.
mc68000::BusReply BoardProgram::access(const mc68000::BusRequest& request,
                                       const mc68000::Account& account) {
  std::unique_lock<std::mutex> lock(mutex_);
  ProgramEvent asked = event(ProgramEvent::Kind::access, account);
  asked.request = request;
  put(asked);
  const bool writes = request.kind == mc68000::BusRequest::Kind::write;
  const auto may_go_on = [this, writes](std::size_t events) {
    return abandoned_ || (writes ? events_.size() < events : answer_.has_value());
  };
  if (!may_go_on(k_most_events)) {
    slots_.give_back();
    changed_.wait(lock, [&may_go_on] { return may_go_on(k_fewer_events + 1); });
    lock.unlock();
    slots_.take();
    lock.lock();
  }
  mc68000::BusReply reply;
  reply.error = abandoned_;
  if (!writes) {
    reply.value = answer_.value_or(0);
    answer_.reset();
  }
  return reply;
}

}  // namespace maquette::models
