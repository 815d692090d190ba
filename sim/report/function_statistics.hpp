#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "firmware/arithmetic/function.hpp"
#include "firmware/primitives/primitive_table.hpp"
#include "models/bus/duration.hpp"
#include "sim/report/statistics_field.hpp"

/// Where the time goes: by function of the process and by kind of ray (paper, section V.2.3.1).
namespace maquette::sim {

/// The firmware's functions, with an intersection for each row of the table of primitives.
inline constexpr int k_told_function_count =
    firmware::k_fixed_function_count + firmware::k_primitive_kind_count;

/// "extents", "intersection_sphere"; `function` is below k_told_function_count.
[[nodiscard]] const std::string& function_name(int function);

/// A time per function, keyed by function_name.
struct FunctionTimes {
  std::array<models::Duration, k_told_function_count> values{};
};

struct RayTimes {
  models::Duration preprocessing{};
  models::Duration primary{};
  models::Duration reflected{};
  models::Duration refracted{};
  models::Duration shadow{};

  static constexpr auto fields() {
    using Self = RayTimes;
    return std::make_tuple(
        field("preprocessing", "s", "before the first ray", &Self::preprocessing),
        field("primary", "s", "from the eye, with the colour of the pixel", &Self::primary),
        field("reflected", "s", "off mirrors and smooth faces", &Self::reflected),
        field("refracted", "s", "into and out of transparent bodies", &Self::refracted),
        field("shadow", "s", "towards lights", &Self::shadow));
  }
};

/// Work of one function or kind of ray.
struct NamedWork {
  std::string name;
  OperationCounts work{};

  static constexpr auto fields() {
    using Self = NamedWork;
    return std::make_tuple(
        field("name", "", "of the function or kind of ray", &Self::name),
        field("work", "operations", "of all boards, per operation class", &Self::work));
  }
};

/// Both partitions of the time and of the work are of the same whole, to the last picosecond.
struct FunctionStatistics {
  std::string from = "absent";
  models::Duration time{};
  FunctionTimes by_function;
  RayTimes by_ray;
  std::vector<models::Duration> shadow_by_light;
  double intersection_share = 0;
  std::vector<NamedWork> work_by_function;
  std::vector<NamedWork> work_by_ray;

  static constexpr auto fields() {
    using Self = FunctionStatistics;
    return std::make_tuple(
        field("from", "", "counted work, priced as the pixels; or why it is absent", &Self::from),
        field("time_s", "s", "of a board in the mean: preprocessing and pixels", &Self::time),
        field("time_by_function_s", "s", "of it, by function of the process", &Self::by_function),
        field("time_by_ray_s", "", "", &Self::by_ray),
        field("shadow_by_light_s", "s",
              "of the shadow rays' time, the 61st light and those after it together",
              &Self::shadow_by_light),
        field("intersection_share", "1", "of the time: rays intersected with primitives",
              &Self::intersection_share),
        field("work_by_function", "", "functions that did something", &Self::work_by_function),
        field("work_by_ray", "", "the preprocessing and rays that were cast", &Self::work_by_ray));
  }
};

/// What comparing rays with one kind of extent came to.
struct ExtentTests {
  std::uint64_t tests = 0;
  std::uint64_t hits = 0;
  std::uint64_t spared_leaves = 0;

  static constexpr auto fields() {
    using Self = ExtentTests;
    return std::make_tuple(
        field("tests", "comparisons", "of a ray with an extent", &Self::tests),
        field("hits", "comparisons", "after which the node was looked at", &Self::hits),
        field("spared_leaves", "leaves", "below the nodes that were not", &Self::spared_leaves));
  }
};

/// Extents of nodes: rectangles for primary rays, spheres for secondary ones, boxes in their place
/// and for all rays where unions are large.
struct ExtentStatistics {
  ExtentTests rectangles;
  ExtentTests boxes;
  ExtentTests spheres;

  static constexpr auto fields() {
    using Self = ExtentStatistics;
    return std::make_tuple(field("rectangles", "", "", &Self::rectangles),
                           field("boxes", "", "", &Self::boxes),
                           field("spheres", "", "", &Self::spheres));
  }
};

}  // namespace maquette::sim
