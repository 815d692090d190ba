#include "sim/trace/board_states.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace maquette::sim {

namespace {

using models::Instant;

std::vector<RecordedAccess> accesses_of(const BusRecord& record, std::size_t board) {
  std::vector<RecordedAccess> accesses;
  for (const RecordedBus& bus : record.buses) {
    std::copy_if(bus.accesses.begin(), bus.accesses.end(), std::back_inserter(accesses),
                 [board](const RecordedAccess& access) { return access.board == board; });
  }
  std::stable_sort(accesses.begin(), accesses.end(),
                   [](const auto& a, const auto& b) { return a.grant < b.grant; });
  return accesses;
}

Instant standing_request(const BusRecord& record, std::size_t board) {
  for (const RecordedBus& bus : record.buses) {
    for (const StandingRequest& standing : bus.standing) {
      if (standing.board == board) {
        return standing.request;
      }
    }
  }
  return record.window.to;
}

// Appends one state after the other, cut at the edges of a window.
class Tiling {
 public:
  explicit Tiling(const TraceWindow& window) : window_(window), reached_(window.from) {}

  void stay(BoardState state, Instant until) {
    const Instant to = window_.clip(until);
    if (to > reached_) {
      intervals_.push_back({state, reached_, to});
      reached_ = to;
    }
  }

  [[nodiscard]] std::vector<StateInterval> take() { return std::move(intervals_); }

 private:
  TraceWindow window_;
  Instant reached_;
  std::vector<StateInterval> intervals_;
};

// What a board does off the bus: it computes, but for its pauses.
class OffBus {
 public:
  OffBus(const BusRecord& record, std::size_t board, Tiling& tiling) : tiling_(tiling) {
    if (board < record.pauses.size()) {
      next_ = record.pauses[board].begin();
      end_ = record.pauses[board].end();
    }
  }

  void stay(Instant until) {
    for (; next_ != end_ && next_->from < until; ++next_) {
      tiling_.stay(BoardState::compute, next_->from);
      tiling_.stay(BoardState::idle, std::min(next_->to, until));
    }
    tiling_.stay(BoardState::compute, until);
  }

 private:
  Tiling& tiling_;
  std::vector<RecordedPause>::const_iterator next_{};
  std::vector<RecordedPause>::const_iterator end_{};
};

}  // namespace

const char* name_of(BoardState state) {
  switch (state) {
    case BoardState::compute:
      return "compute";
    case BoardState::wait_grant:
      return "wait for grant";
    case BoardState::transfer:
      return "transfer";
    case BoardState::idle:
      break;
  }
  return "idle";
}

std::vector<StateInterval> board_states(const BusRecord& record, std::size_t board) {
  Tiling tiling(record.window);
  OffBus off_bus(record, board, tiling);
  for (const RecordedAccess& access : accesses_of(record, board)) {
    off_bus.stay(access.request);
    tiling.stay(BoardState::wait_grant, access.grant);
    tiling.stay(BoardState::transfer, access.end());
  }
  if (const auto& finish = record.boards[board].finish) {
    off_bus.stay(*finish);
    tiling.stay(BoardState::idle, record.window.to);
  } else {
    off_bus.stay(standing_request(record, board));
    tiling.stay(BoardState::wait_grant, record.window.to);
  }
  return tiling.take();
}

}  // namespace maquette::sim
