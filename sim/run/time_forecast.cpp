#include "sim/run/time_forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "models/board/work_cost.hpp"
#include "models/bus/access_law.hpp"
#include "models/display/frame_memory.hpp"
#include "sim/report/seconds.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

constexpr std::int64_t k_sample_pixels = 64;
constexpr double k_bits_per_byte = 8;

[[noreturn]] void fail(const std::string& who_does_what, double seconds, const char* remedy) {
  constexpr double k_day_s = 86400;
  throw DescriptionError(fmt::format(
      "{} for at least {:.4g} days; simulated time goes up to {:.0f} days: {}", who_does_what,
      seconds / k_day_s, in_seconds(models::k_longest_run) / k_day_s, remedy));
}

void require_time(double seconds, const std::string& who_does_what, const char* remedy) {
  if (seconds > in_seconds(models::k_longest_run)) {
    fail(who_does_what, seconds, remedy);
  }
}

/// What a board computes at least, in seconds: of a shared database, without what it reads.
class ComputingTime {
 public:
  explicit ComputingTime(const models::Kvm02Parameters& board)
      : cost_(board), is_shared_(models::is_shared(board.database)) {}

  [[nodiscard]] double operator()(const firmware::Work& work) const {
    return in_seconds(cost_.duration(work, is_shared_ ? work[firmware::Operation::load] : 0));
  }

 private:
  models::WorkCost cost_;
  bool is_shared_;
};

/// The seconds of the busiest board, and its name. Boards that claim their units share the pixels
/// at best equally.
std::pair<double, std::string> busiest(std::vector<double> seconds, bool is_claimed) {
  if (is_claimed) {
    double sum = 0;
    for (const double one : seconds) {
      sum += one;
    }
    return {sum / static_cast<double>(seconds.size()), "a board"};
  }
  const auto most = std::max_element(seconds.begin(), seconds.end());
  return {*most, fmt::format("board{}", most - seconds.begin())};
}

}  // namespace

double likely_computing_s(const Machine& machine, const models::PixelRectangle& zone,
                          const firmware::Work& preprocessing, const WorkAt& work) {
  const ComputingTime time(machine.parameters.board);
  const auto boards = static_cast<int>(machine.parameters.boards.size());
  const models::PixelAllotment allotment(machine.parameters.allotment, zone, boards);
  const std::int64_t count = std::min(k_sample_pixels, allotment.pixels());
  double sum = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    sum += time(work(allotment.position((2 * i + 1) * allotment.pixels() / (2 * count))));
  }
  const double per_board = count == 0 ? 0
                                      : sum / static_cast<double>(count) *
                                            static_cast<double>(allotment.pixels()) / boards;
  return time(preprocessing) + per_board;
}

bool may_take_long(double likely_s) {
  constexpr double k_share = 0.25;
  return likely_s > k_share * in_seconds(models::k_longest_run);
}

void require_computing_time(const Machine& machine, const RecordedFrame& frame) {
  const models::AllotmentParameters& parameters = machine.parameters.allotment;
  const ComputingTime time(machine.parameters.board);
  const std::size_t boards = machine.parameters.boards.size();
  const models::PixelAllotment allotment(parameters, frame.useful_zone, static_cast<int>(boards));
  std::vector<double> seconds(boards, time(frame.preprocessing));
  for (std::int64_t unit = 0; unit < allotment.units(); ++unit) {
    const std::int64_t end = allotment.first_pixel(unit + 1);
    for (std::int64_t index = allotment.first_pixel(unit); index < end; ++index) {
      seconds[static_cast<std::size_t>(unit) % boards] +=
          time(frame.at(allotment.position(index)).work);
    }
  }
  const auto [most, name] = busiest(seconds, models::is_claimed(parameters.assignment));
  require_time(most, name + " would compute",
               "a faster board.clock, cheaper operations (board.arithmetic, board.call_overhead, "
               "board.ram_read_wait, board.refresh), more processors or fewer pixels take less");
}

void require_transfer_time(const Machine& machine, const models::FrameSetup& setup) {
  const models::MachineParameters& parameters = machine.parameters;
  const auto law = [&parameters](double clock_hz) {
    return models::AccessLaw{models::Period::of_frequency(clock_hz), parameters.board.access_clocks,
                             parameters.board.access_slack};
  };
  const double word_bytes = parameters.bus.data_width_bits / k_bits_per_byte;
  const double arbitration = static_cast<double>(parameters.bus.arbitration_clocks) /
                             parameters.bus.clock_hz * (parameters.bus.level.is_exclusive ? 1 : 0);
  auto loaded_bytes = static_cast<double>(setup.shared_database.size());
  for (const std::vector<unsigned char>& image : setup.images) {
    loaded_bytes += static_cast<double>(image.size());
  }
  const double host_word =
      static_cast<double>(parameters.host.word_clocks) / parameters.host.clock_hz + arbitration +
      in_seconds(law(parameters.host.clock_hz).duration({}));
  require_time(loaded_bytes / word_bytes * host_word, "the host would load the boards",
               "a faster host.clock or bus.clock, or fewer host.word_clocks, "
               "bus.arbitration_clocks and board.access clocks take less");
  if (!parameters.bus.level.is_exclusive || models::is_distributed(parameters.frame_memory)) {
    return;
  }
  const double words = static_cast<double>(setup.useful_zone.pixels()) *
                       models::FrameMemory::k_pixel_bytes / word_bytes /
                       parameters.frame_memory.ports;
  const bool is_held = models::keeps_bus(parameters.board.release);
  const double access =
      in_seconds(law(parameters.board.clock_hz).duration(parameters.frame_memory.access_time));
  require_time(words * (access + (is_held ? 0 : arbitration)),
               "the bus would be busy with the pixels",
               "a faster board.clock or bus.clock, fewer bus.arbitration_clocks and board.access "
               "clocks, a shorter frame_memory.access_time or fewer pixels take less");
}

}  // namespace maquette::sim
