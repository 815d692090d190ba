#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/bus/duration.hpp"
#include "sim/report/function_statistics.hpp"
#include "sim/report/statistics_field.hpp"
#include "sim/report/unit_statistics.hpp"

namespace maquette::sim {

struct FrameStatistics {
  int width = 0;
  int height = 0;
  models::Duration time{};
  models::Duration load{};
  models::Duration preprocess{};
  models::Duration synthesis{};
  std::int64_t pixels_total = 0;
  std::int64_t pixels_synthesised = 0;
  double imbalance = 0;

  static constexpr auto fields() {
    using Self = FrameStatistics;
    return std::make_tuple(
        field("width", "pixels", "columns of the frame", &Self::width),
        field("height", "pixels", "rows of the frame", &Self::height),
        field("time_s", "s", "from the boards' start to the last pixel in the frame memory",
              &Self::time),
        field("load_s", "s", "writing code and database into the boards, before their start",
              &Self::load),
        field("preprocess_s", "s", "from the boards' start to the end of the last preprocessing",
              &Self::preprocess),
        field("synthesis_s", "s", "from the end of the last preprocessing to the last pixel",
              &Self::synthesis),
        field("pixels_total", "pixels", "of the frame", &Self::pixels_total),
        field("pixels_synthesised", "pixels", "in the useful zone, written by the boards",
              &Self::pixels_synthesised),
        field("imbalance", "1", "time of the longest busy board over the boards' mean, less 1",
              &Self::imbalance));
  }
};

/// The part of the screen outside of which every pixel shows the background (paper, section II.3).
struct UsefulZone {
  int column = 0;
  int row = 0;
  int width = 0;
  int height = 0;

  static constexpr auto fields() {
    using Self = UsefulZone;
    return std::make_tuple(field("column", "pixels", "of its left edge", &Self::column),
                           field("row", "pixels", "of its upper edge", &Self::row),
                           field("width", "pixels", "columns of the zone", &Self::width),
                           field("height", "pixels", "rows of the zone", &Self::height));
  }
};

/// A board's pixels and states; the four states sum to the frame time exactly, with a fifth one on
/// machines with function units (BoardWaits).
struct BoardStatistics {
  std::string name;
  std::int64_t pixels = 0;
  models::Duration compute{};
  models::Duration wait_grant{};
  models::Duration transfer{};
  models::Duration idle{};
  models::Duration claim{};
  std::int64_t claims = 0;
  std::int64_t claim_failed_tries = 0;

  static constexpr auto fields() {
    using Self = BoardStatistics;
    return std::make_tuple(
        field("name", "", "of the board", &Self::name),
        field("pixels", "pixels", "synthesised and written", &Self::pixels),
        field("compute_s", "s", "the processor works", &Self::compute),
        field("wait_grant_s", "s", "the bus is requested and not granted", &Self::wait_grant),
        field("transfer_s", "s", "the board is bus master", &Self::transfer),
        field("idle_s", "s", "the board has no more pixels", &Self::idle),
        field("claim_s", "s", "of these but idle: claiming units on demand", &Self::claim),
        field("claims", "claims", "of units on demand, the last one in vain", &Self::claims),
        field("claim_failed_tries", "accesses", "test-and-set cycles that found the lock taken",
              &Self::claim_failed_tries));
  }
};

/// Waits that most accesses did not exceed: quantiles by nearest rank, each rounded up to its
/// bucket in the histogram of the waits (at most 1/16 above the exact one, never below).
struct WaitQuantiles {
  models::Duration half{};
  models::Duration nine_of_10{};
  models::Duration nine_of_100{};
  models::Duration nine_of_1000{};

  static constexpr auto fields() {
    using Self = WaitQuantiles;
    return std::make_tuple(
        field("p50_s", "s", "not exceeded by 50 % of the accesses, up to 1/16 above", &Self::half),
        field("p90_s", "s", "not exceeded by 90 %, up to 1/16 above", &Self::nine_of_10),
        field("p99_s", "s", "not exceeded by 99 %, up to 1/16 above", &Self::nine_of_100),
        field("p999_s", "s", "not exceeded by 99.9 %, up to 1/16 above", &Self::nine_of_1000));
  }
};

/// One bucket of a histogram of waits; its width is at most 1/16 of its lower edge.
struct WaitBucket {
  models::Duration from{};
  models::Duration to{};
  std::int64_t count = 0;

  static constexpr auto fields() {
    using Self = WaitBucket;
    return std::make_tuple(field("from_s", "s", "shortest wait of the bucket", &Self::from),
                           field("to_s", "s", "just beyond the bucket", &Self::to),
                           field("count", "accesses", "that waited so long", &Self::count));
  }
};

/// How long one bus master waited for grants during the frame, and for whom.
struct MasterStatistics {
  std::string name;
  std::int64_t transfers = 0;
  models::Duration wait{};
  models::Duration wait_max{};
  WaitQuantiles wait_quantiles;
  std::vector<models::Duration> waited_for;
  std::vector<WaitBucket> waits;

  static constexpr auto fields() {
    using Self = MasterStatistics;
    return std::make_tuple(
        field("name", "", "of the bus master", &Self::name),
        field("transfers", "accesses", "during the frame", &Self::transfers),
        field("wait_s", "s", "from request to grant, all accesses together", &Self::wait),
        field("wait_max_s", "s", "from request to grant, longest", &Self::wait_max),
        field("wait_quantiles", "", "", &Self::wait_quantiles),
        field("waited_for_s", "s",
              "part of wait_s while that master had the bus, in their order; its own: arbitration",
              &Self::waited_for),
        field("waits", "", "histogram of the waits; empty buckets are left out", &Self::waits));
  }
};

/// The wait that was longer than all before it and not exceeded after.
struct LongestWait {
  models::Duration time{};
  models::Duration requested_at{};
  std::string master = "nobody";
  std::string behind = "nobody";

  static constexpr auto fields() {
    using Self = LongestWait;
    return std::make_tuple(
        field("time_s", "s", "from request to grant", &Self::time),
        field("requested_at_s", "s", "from the frame's start to its request", &Self::requested_at),
        field("master", "", "that waited", &Self::master),
        field("behind", "", "the master that had the bus for most of it", &Self::behind));
  }
};

/// For how long the queue of requests had a certain length.
struct QueueTime {
  int length = 0;
  models::Duration time{};

  static constexpr auto fields() {
    using Self = QueueTime;
    return std::make_tuple(field("length", "requests", "that stood together", &Self::length),
                           field("time_s", "s", "how long; sums to the frame time", &Self::time));
  }
};

/// The requests that stand and are not yet granted.
struct QueueStatistics {
  double mean = 0;
  int longest = 0;
  std::vector<QueueTime> times;

  static constexpr auto fields() {
    using Self = QueueStatistics;
    return std::make_tuple(field("mean", "requests", "over the frame time", &Self::mean),
                           field("longest", "requests", "that stood together", &Self::longest),
                           field("times", "", "by length of the queue", &Self::times));
  }
};

/// What the bus does with the time of the frame; the shares sum to one.
struct BusShares {
  double transfer = 0;
  double arbitration = 0;
  double handover = 0;
  double kept = 0;
  double idle = 1;

  static constexpr auto fields() {
    using Self = BusShares;
    return std::make_tuple(
        field("transfer", "1", "a master has the bus, from grant to release", &Self::transfer),
        field("arbitration", "1", "free and requested, until the grant", &Self::arbitration),
        field("handover", "1", "of that time: added since another master had the bus before",
              &Self::handover),
        field("kept", "1", "between the accesses of a block, by their master", &Self::kept),
        field("idle", "1", "nobody has or requests it", &Self::idle));
  }
};

struct BusStatistics {
  std::int64_t transfers = 0;
  std::int64_t database_words = 0;
  models::Duration busy{};
  double utilisation = 0;
  int buses = 1;
  double occupied = 0;
  BusShares shares;
  models::Duration wait_mean{};
  models::Duration wait_max{};
  WaitQuantiles wait_quantiles;
  LongestWait longest_wait;
  double fairness = 1;
  QueueStatistics queue;
  std::vector<MasterStatistics> masters;

  static constexpr auto fields() {
    using Self = BusStatistics;
    return std::make_tuple(
        field("transfers", "accesses", "by all masters during the frame", &Self::transfers),
        field("database_words", "accesses", "of these: reads of a shared database",
              &Self::database_words),
        field("busy_s", "s", "the bus has a master", &Self::busy),
        field("utilisation", "1",
              "busy time over frame time, of a backplane; above 1 where accesses overlap",
              &Self::utilisation),
        field("buses", "buses",
              "that occupied and shares are of: backplanes, or an ideal bus for each board",
              &Self::buses),
        field("occupied", "1", "share of the frame time in which the bus is not idle",
              &Self::occupied),
        field("shares", "", "", &Self::shares),
        field("wait_mean_s", "s", "from request to grant, mean to the nearest picosecond",
              &Self::wait_mean),
        field("wait_max_s", "s", "from request to grant, longest", &Self::wait_max),
        field("wait_quantiles", "", "", &Self::wait_quantiles),
        field("longest_wait", "", "", &Self::longest_wait),
        field("fairness", "1",
              "Jain's index of the masters' mean waits: 1 all alike, 1/n one of n bears them",
              &Self::fairness),
        field("queue", "", "", &Self::queue),
        field("masters", "", "who waited for whom", &Self::masters));
  }
};

/// Rays by kind (paper, section V.2.3.1.2).
struct RayStatistics {
  std::int64_t primary = 0;
  std::int64_t reflected = 0;
  std::int64_t refracted = 0;
  std::int64_t shadow = 0;
  std::int64_t total = 0;

  static constexpr auto fields() {
    using Self = RayStatistics;
    return std::make_tuple(
        field("primary", "rays", "from the eye", &Self::primary),
        field("reflected", "rays", "off mirrors and smooth faces", &Self::reflected),
        field("refracted", "rays", "into and out of transparent bodies", &Self::refracted),
        field("shadow", "rays", "towards a light", &Self::shadow),
        field("total", "rays", "of all kinds", &Self::total));
  }
};

/// The roots that were refined in a number of steps.
struct RootsBySteps {
  int steps = 0;
  std::uint64_t roots = 0;

  static constexpr auto fields() {
    using Self = RootsBySteps;
    return std::make_tuple(field("steps", "steps", "of Laguerre's method", &Self::steps),
                           field("roots", "roots", "that took so many", &Self::roots));
  }
};

/// The roots of rays' intersections, without those of points settled (paper, section IV.2.4: three
/// to five iterations).
struct IntersectionRoots {
  std::uint64_t found = 0;
  std::uint64_t steps = 0;
  double steps_per_root = 0;
  double up_to_two = 0;
  double three_to_five = 0;
  double more = 0;
  std::vector<RootsBySteps> by_steps;

  static constexpr auto fields() {
    using Self = IntersectionRoots;
    return std::make_tuple(
        field("found", "roots", "of rays' intersections, refined", &Self::found),
        field("steps", "steps", "of Laguerre's method", &Self::steps),
        field("steps_per_root", "1", "mean", &Self::steps_per_root),
        field("up_to_two", "1", "of these roots: in one or two steps", &Self::up_to_two),
        field("three_to_five", "1", "of these roots: in 3 to 5 steps", &Self::three_to_five),
        field("more", "1", "of these roots: in 6 steps or more", &Self::more),
        field("by_steps", "", "histogram; numbers of steps that no root took are left out",
              &Self::by_steps));
  }
};

/// Roots refined by Laguerre's method, of intersections and of points settled on curved surfaces.
/// What is of intersections alone is there where a whole frame has any.
struct RootStatistics {
  std::uint64_t found = 0;
  std::uint64_t steps = 0;
  double steps_per_root = 0;
  std::optional<IntersectionRoots> intersections;

  static constexpr auto fields() {
    using Self = RootStatistics;
    return std::make_tuple(field("found", "roots", "of polynomials, refined", &Self::found),
                           field("steps", "steps", "of Laguerre's method", &Self::steps),
                           field("steps_per_root", "1", "mean", &Self::steps_per_root),
                           field("intersections", "", "", &Self::intersections));
  }
};

/// What counted work costs, and where that is from.
struct CostStatistics {
  std::string from = "tables";
  int pixels = 0;
  double sum_error = 0;
  double typical_error = 0;
  OperationClocks clocks{};

  static constexpr auto fields() {
    using Self = CostStatistics;
    return std::make_tuple(
        field("from", "", "calibration: executed pixels; tables; execution: of the whole program",
              &Self::from),
        field("pixels", "pixels", "executed for the calibration", &Self::pixels),
        field("sum_error", "1", "of their counted clocks together, over the executed ones",
              &Self::sum_error),
        field("typical_error", "1", "of one of them: root of the mean square, over the mean",
              &Self::typical_error),
        field("clocks", "clocks", "of the processor, RAM's wait states included, per class",
              &Self::clocks));
  }
};

/// All that a run determines: equal inputs give equal statistics, on any host.
struct Statistics {
  FrameStatistics frame;
  UsefulZone useful_zone;
  std::vector<BoardStatistics> boards;
  std::optional<UnitsStatistics> units;
  BusStatistics bus;
  RayStatistics rays;
  RootStatistics roots;
  OperationCounts work{};
  OperationCounts preprocess_work{};
  CostStatistics costs;
  FunctionStatistics functions;
  ExtentStatistics extents;
  bool partial = false;
  std::string end_reason;

  static constexpr auto fields() {
    using Self = Statistics;
    return std::make_tuple(
        field("frame", "", "", &Self::frame), field("useful_zone", "", "", &Self::useful_zone),
        field("boards", "", "in board order; states sum to the frame time", &Self::boards),
        field("units", "", "of a machine that has some", &Self::units),
        field("bus", "", "", &Self::bus), field("rays", "", "of all pixels", &Self::rays),
        field("roots", "", "", &Self::roots),
        field("work", "operations", "of all pixels, per operation class", &Self::work),
        field("preprocess_work", "operations", "of each board, per operation class",
              &Self::preprocess_work),
        field("costs", "", "", &Self::costs), field("functions", "", "", &Self::functions),
        field("extents", "", "", &Self::extents),
        field("partial", "", "whether the run ended before its last pixel", &Self::partial),
        field("end_reason", "", "why the run ended", &Self::end_reason));
  }
};

}  // namespace maquette::sim
