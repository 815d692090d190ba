#include "sim/maps/map_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "firmware/arithmetic/work.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/nearest_name.hpp"

namespace maquette::sim {

namespace {

constexpr double k_nothing = std::numeric_limits<double>::quiet_NaN();

using Time = models::ProcessorTime;

bool is_written(const PixelFacts& facts, std::size_t pixel) {
  return facts.written[pixel] != models::k_never;
}

double ticks(models::Duration time) { return static_cast<double>(time.count()); }

/// A time of the pixel's board.
template <class Get>
Map time_map(const char* name, const char* title, Get get) {
  return {name,
          "s",
          title,
          MapKind::time,
          &WantedFacts::times,
          [get](const PixelFacts& facts, std::size_t pixel) {
            return is_written(facts, pixel) ? ticks(get(facts.times[pixel].spent)) : k_nothing;
          }};
}

Map ray_map(const char* name, const char* title, std::uint32_t firmware::RayCounts::*kind) {
  return {name,
          "rays",
          title,
          MapKind::count,
          &WantedFacts::work,
          [kind](const PixelFacts& facts, std::size_t pixel) {
            return static_cast<double>(facts.pixels[pixel].rays.*kind);
          }};
}

Map work_map(std::string name, const char* unit, std::string title, firmware::Operation operation) {
  return {std::move(name),
          unit,
          std::move(title),
          MapKind::count,
          &WantedFacts::work,
          [operation](const PixelFacts& facts, std::size_t pixel) {
            return static_cast<double>(facts.pixels[pixel].work[operation]);
          }};
}

Map extent_map(const char* name, const char* title, std::uint64_t firmware::ExtentCounts::*count) {
  return {name,
          "extents",
          title,
          MapKind::count,
          &WantedFacts::extents,
          [count](const PixelFacts& facts, std::size_t pixel) {
            return static_cast<double>(facts.extents[pixel].*count);
          }};
}

/// Of what is seen; nothing at the background.
template <class Get>
Map sight_map(const char* name, const char* unit, const char* title, MapKind kind, Get get) {
  return {name,
          unit,
          title,
          kind,
          &WantedFacts::sights,
          [get](const PixelFacts& facts, std::size_t pixel) {
            const PixelSight& sight = facts.sights[pixel];
            return sight.is_seen ? static_cast<double>(get(sight)) : k_nothing;
          }};
}

Map with_names(Map map, std::vector<std::string> PixelFacts::*names) {
  map.names = names;
  return map;
}

double board_of(const PixelFacts& facts, std::size_t pixel) {
  return is_written(facts, pixel) ? facts.times[pixel].board : k_nothing;
}

double instant_of(const PixelFacts& facts, std::size_t pixel) {
  return is_written(facts, pixel) ? ticks(facts.written[pixel]) : k_nothing;
}

double rays_of(const PixelFacts& facts, std::size_t pixel) {
  const firmware::RayCounts& rays = facts.pixels[pixel].rays;
  return static_cast<double>(rays.primary) + static_cast<double>(rays.reflected) +
         static_cast<double>(rays.refracted) + static_cast<double>(rays.shadow);
}

double tree_depth_of(const PixelFacts& facts, std::size_t pixel) {
  return facts.sights[pixel].tree_depth;
}

double count_error_of(const PixelFacts& facts, std::size_t pixel) {
  const double executed = is_written(facts, pixel) ? ticks(facts.times[pixel].spent.compute) : 0;
  return executed > 0 ? ticks(facts.counted[pixel]) / executed - 1 : k_nothing;
}

void add_times(std::vector<Map>& maps) {
  maps.push_back(time_map("time", "Time that the board spent on the pixel",
                          [](const Time& time) { return time.sum(); }));
  maps.push_back(time_map("compute", "Of this time: computing",
                          [](const Time& time) { return time.compute; }));
  maps.push_back(time_map("wait", "Of this time: waiting for the bus",
                          [](const Time& time) { return time.wait; }));
  maps.push_back(time_map("transfer", "Of this time: master of the bus",
                          [](const Time& time) { return time.transfer; }));
  maps.push_back({"written", "s", "Instant at which the pixel was written, from the frame's start",
                  MapKind::time, &WantedFacts::times, instant_of});
  maps.push_back(with_names(
      {"board", "", "Board that computed the pixel", MapKind::name, &WantedFacts::times, board_of},
      &PixelFacts::boards));
  maps.push_back({"count_error", "1", "Counted over executed computing time, less 1",
                  MapKind::number, &WantedFacts::counted, count_error_of});
}

void add_work(std::vector<Map>& maps) {
  using firmware::Operation;
  using firmware::RayCounts;
  maps.push_back(
      {"rays", "rays", "Rays of all kinds", MapKind::count, &WantedFacts::work, rays_of});
  maps.push_back(ray_map("rays.primary", "Rays from the eye", &RayCounts::primary));
  maps.push_back(ray_map("rays.reflected", "Reflected rays", &RayCounts::reflected));
  maps.push_back(ray_map("rays.refracted", "Refracted rays", &RayCounts::refracted));
  maps.push_back(ray_map("rays.shadow", "Rays towards lights", &RayCounts::shadow));
  maps.push_back(
      work_map("crossings", "crossings", "Crossings of rays with bodies", Operation::crossing));
  maps.push_back(work_map("roots", "roots", "Roots of polynomials, refined", Operation::root));
  maps.push_back(
      work_map("root_steps", "steps", "Steps in which roots were refined", Operation::root_step));
}

void add_sights(std::vector<Map>& maps) {
  maps.push_back(
      extent_map("extents.tested", "Extents compared with rays", &firmware::ExtentCounts::tests));
  maps.push_back(extent_map("extents.met", "Extents that rays met", &firmware::ExtentCounts::hits));
  maps.push_back({"tree_depth", "rays", "Depth of the tree: most secondary rays in a row",
                  MapKind::count, &WantedFacts::sights, tree_depth_of});
  maps.push_back(sight_map("primitive", "", "Primitive seen, by its place in the database",
                           MapKind::name, [](const PixelSight& sight) { return sight.primitive; }));
  maps.push_back(with_names(sight_map("surface", "", "Surface seen", MapKind::name,
                                      [](const PixelSight& sight) { return sight.surface; }),
                            &PixelFacts::surfaces));
  maps.push_back(sight_map("distance", "scene units", "Distance of what is seen", MapKind::number,
                           [](const PixelSight& sight) { return sight.distance; }));
  constexpr const char* k_axes[][2] = {{"normal.x", "Normal of the face seen: to the right"},
                                       {"normal.y", "Normal of the face seen: upwards"},
                                       {"normal.z", "Normal of the face seen: away from the eye"}};
  for (std::size_t axis = 0; axis < std::size(k_axes); ++axis) {
    maps.push_back(sight_map(k_axes[axis][0], "1", k_axes[axis][1], MapKind::number,
                             [axis](const PixelSight& sight) { return sight.normal[axis]; }));
  }
}

void add_families(std::vector<Map>& maps) {
  for (int function = 0; function < k_told_function_count; ++function) {
    const auto place = static_cast<std::size_t>(function);
    maps.push_back({"function." + function_name(function), "s",
                    "Computing time in the function " + function_name(function), MapKind::time,
                    &WantedFacts::functions, [place](const PixelFacts& facts, std::size_t pixel) {
                      return is_written(facts, pixel) ? ticks(facts.functions[pixel].values[place])
                                                      : k_nothing;
                    }});
  }
  for (int operation = 0; operation < firmware::k_operation_count; ++operation) {
    const char* const name = firmware::k_operation_names[operation];
    maps.push_back(work_map(fmt::format("work.{}", name), "operations",
                            fmt::format("Counted work: {}", name),
                            static_cast<firmware::Operation>(operation)));
  }
}

std::vector<Map> made_maps() {
  std::vector<Map> maps;
  add_times(maps);
  add_work(maps);
  add_sights(maps);
  add_families(maps);
  return maps;
}

}  // namespace

const std::vector<Map>& all_maps() {
  static const std::vector<Map> maps = made_maps();
  return maps;
}

std::vector<Map> maps_named(const std::vector<std::string>& names) {
  std::vector<std::string_view> allowed;
  for (const Map& map : all_maps()) {
    allowed.push_back(map.name);
  }
  for (const std::string& name : names) {
    if (std::find(allowed.begin(), allowed.end(), name) == allowed.end()) {
      throw DescriptionError(SourcePosition{"--map " + name, 1, 1},
                             "unknown map; " + allowed_names(name, allowed));
    }
  }
  std::vector<Map> maps;
  for (const Map& map : all_maps()) {
    if (std::find(names.begin(), names.end(), map.name) != names.end()) {
      maps.push_back(map);
    }
  }
  return maps;
}

WantedFacts facts_of(const std::vector<Map>& maps) {
  WantedFacts wanted;
  for (const Map& map : maps) {
    wanted.*map.fact = true;
  }
  // What a function takes is a part of what the board computed, and so is the error a ratio to it.
  wanted.times |= wanted.functions || wanted.counted;
  return wanted;
}

std::string describe_maps() {
  std::string text = "Maps of a run, one value for each pixel of the useful zone\n\n";
  for (const Map& map : all_maps()) {
    text += fmt::format("  {:<30} {:<11}  {}\n", map.name, map.unit, map.title);
  }
  return text;
}

}  // namespace maquette::sim
