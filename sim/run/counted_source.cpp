#include "sim/run/counted_source.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace maquette::sim {

namespace {

/// Pixels of a board that one thread synthesises in a row.
constexpr std::size_t k_piece_pixels = 64;

/// Pieces per board and thread that are made ready at once by several threads.
constexpr std::size_t k_pieces_ahead = 8;

models::PixelRectangle rectangle_of(const firmware::Rectangle& r) {
  if (r.is_empty()) {
    return {};
  }
  return {r.first_column, r.first_row, r.end_column - r.first_column, r.end_row - r.first_row};
}

}  // namespace

CountedSource::CountedSource(const PackedScene<firmware::Counted>& scene, const Machine& machine,
                             int threads)
    : threads_(threads), arena_(threads), areas_([this] { return Area(frame().database); }) {
  firmware::reset_counted_work();
  scene_ = std::make_unique<PreparedScene<firmware::Counted>>(scene);
  preprocessing_ = firmware::counted_work();
  const models::MachineParameters& parameters = machine.parameters;
  const int boards = static_cast<int>(parameters.boards.size());
  allotment_ = std::make_unique<models::PixelAllotment>(
      parameters.allotment, useful_zone(), boards, parameters.tile_width, parameters.tile_height);
  queues_.resize(parameters.boards.size());
  for (int board = 0; board < boards; ++board) {
    queues_[static_cast<std::size_t>(board)].count = allotment_->count(board);
  }
}

models::PixelRectangle CountedSource::useful_zone() const {
  return rectangle_of(frame().prepared.useful_zone);
}

double CountedSource::fraction_taken() const {
  const std::int64_t pixels = useful_zone().pixels();
  return pixels == 0 ? 1 : static_cast<double>(taken_) / static_cast<double>(pixels);
}

const models::SynthesizedPixel* CountedSource::next(int board) {
  Queue& queue = queues_[static_cast<std::size_t>(board)];
  if (queue.next == queue.pixels.size()) {
    if (queue.left() == 0) {
      return nullptr;
    }
    if (threads_ == 1) {
      refill(board);
    } else {
      refill_all();
    }
  }
  ++taken_;
  return &queue.pixels[queue.next++];
}

void CountedSource::refill(int board) {
  Queue& queue = queues_[static_cast<std::size_t>(board)];
  const std::int64_t left = queue.left();
  queue.first += static_cast<std::int64_t>(queue.pixels.size());
  queue.next = 0;
  queue.pixels.resize(std::min(k_piece_pixels, static_cast<std::size_t>(left)));
  synthesise(board, 0, queue.pixels.size(), areas_.local());
}

/// Makes pixels ready for every board that has used up its own; the threads share them in pieces.
void CountedSource::refill_all() {
  struct Piece {
    int board;
    std::size_t begin;
    std::size_t end;
  };
  std::vector<Piece> pieces;
  const std::size_t ahead = k_piece_pixels * k_pieces_ahead * static_cast<std::size_t>(threads_);
  for (std::size_t board = 0; board < queues_.size(); ++board) {
    Queue& queue = queues_[board];
    const auto taken = static_cast<std::ptrdiff_t>(queue.next);
    queue.pixels.erase(queue.pixels.begin(), queue.pixels.begin() + taken);
    queue.first += taken;
    queue.next = 0;
    const std::size_t ready = queue.pixels.size();
    const auto left = static_cast<std::size_t>(queue.left());
    queue.pixels.resize(ready + std::min(left, ahead - std::min(ahead, ready)));
    for (std::size_t start = ready; start < queue.pixels.size(); start += k_piece_pixels) {
      pieces.push_back(
          {static_cast<int>(board), start, std::min(start + k_piece_pixels, queue.pixels.size())});
    }
  }
  // The library orders these threads as well, but out of sight of the thread sanitizer.
  std::atomic<std::size_t> done{0};
  done.store(0, std::memory_order_release);
  arena_.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pieces.size(), 1),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        static_cast<void>(done.load(std::memory_order_acquire));
                        for (std::size_t i = range.begin(); i != range.end(); ++i) {
                          synthesise(pieces[i].board, pieces[i].begin, pieces[i].end,
                                     areas_.local());
                        }
                        done.fetch_add(range.size(), std::memory_order_release);
                      });
  });
  if (done.load(std::memory_order_acquire) != pieces.size()) {
    throw std::logic_error("a piece of the picture was not synthesised");
  }
}

/// Fills places begin..end of a board's queue.
void CountedSource::synthesise(int board, std::size_t begin, std::size_t end, Area& area) {
  Queue& queue = queues_[static_cast<std::size_t>(board)];
  const firmware::WorkArea<firmware::Counted> view = area.view();
  for (std::size_t i = begin; i < end; ++i) {
    const models::PixelPosition position =
        allotment_->pixel(board, queue.first + static_cast<std::int64_t>(i));
    firmware::reset_counted_work();
    const firmware::Pixel pixel =
        firmware::synthesize(frame(), view, static_cast<std::int16_t>(position.column),
                             static_cast<std::int16_t>(position.row));
    queue.pixels[i] = {static_cast<std::uint16_t>(position.column),
                       static_cast<std::uint16_t>(position.row), pixel.rgb, pixel.rays,
                       firmware::counted_work()};
  }
}

}  // namespace maquette::sim
