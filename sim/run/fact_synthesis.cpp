#include "sim/run/fact_synthesis.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <functional>

#include "models/board/work_cost.hpp"
#include "models/bus/wide.hpp"
#include "sim/database/object_tree.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/pixel_sight.hpp"
#include "sim/run/proportional_shares.hpp"

namespace maquette::sim {

namespace {

/// Calls `look(area, place, position)` for each pixel of a zone, each thread with an area of its
/// own.
template <class Real, class Look>
void for_each_pixel(const firmware::Frame<Real>& frame, const models::PixelRectangle& zone,
                    int threads, Look look) {
  tbb::task_arena arena(threads);
  tbb::enumerable_thread_specific<SynthesisArea<Real>> areas(
      [&frame] { return SynthesisArea<Real>(frame.database); });
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, zone.height), [&](const auto& rows) {
      const firmware::WorkArea<Real> area = areas.local().view();
      for (int row = rows.begin(); row != rows.end(); ++row) {
        for (int column = 0; column < zone.width; ++column) {
          firmware::end_if_requested();
          const auto place = static_cast<std::size_t>(row) * static_cast<std::size_t>(zone.width) +
                             static_cast<std::size_t>(column);
          look(area, place, models::PixelPosition{zone.column0 + column, zone.row0 + row});
        }
      }
    });
  });
}

/// What the work that the meter of this thread has counted costs, by function.
std::vector<models::Wide> prices_of(const models::WorkCost& cost) {
  FunctionWork work;
  work.add(firmware::counted_meter);
  std::vector<models::Wide> prices(static_cast<std::size_t>(k_told_function_count));
  for (std::size_t ray = 0; ray < work.ray_kinds(); ++ray) {
    for (std::size_t function = 0; function < prices.size(); ++function) {
      const FunctionWork::Counts& counts = work.cells[FunctionWork::cell(ray, function)];
      for (std::size_t i = 0; i < counts.size(); ++i) {
        prices[function] +=
            static_cast<models::Wide>(cost.milliclocks(static_cast<firmware::Operation>(i))) *
            static_cast<models::Wide>(counts[i]);
      }
    }
  }
  return prices;
}

firmware::ExtentCounts met_extents() {
  firmware::ExtentCounts sum{};
  for (const firmware::ExtentCounts& kind : firmware::counted_meter.extents) {
    sum.tests += kind.tests;
    sum.hits += kind.hits;
    sum.spared_leaves += kind.spared_leaves;
  }
  return sum;
}

FunctionTimes function_times(models::Duration computed, std::vector<models::Wide> prices) {
  const std::vector<models::Duration> shares = proportional_shares(computed, std::move(prices));
  FunctionTimes times;
  std::copy(shares.begin(), shares.end(), times.values.begin());
  return times;
}

void count_pixels(const Scene& scene, const Machine& machine, const WantedFacts& wanted,
                  int threads, PixelFacts& facts) {
  const PreparedScene<firmware::Counted> prepared(
      packed_scene<firmware::Counted>(scene, picture_format_of(machine)));
  const models::WorkCost cost(machine.parameters.board);
  const auto pixels = static_cast<std::size_t>(facts.zone.pixels());
  facts.pixels.resize(pixels);
  facts.functions.resize(wanted.functions ? pixels : 0);
  facts.extents.resize(wanted.extents ? pixels : 0);
  for_each_pixel(prepared.frame(), facts.zone, threads,
                 [&](const auto& area, std::size_t place, const models::PixelPosition& position) {
                   facts.pixels[place] = counted_pixel(prepared.frame(), area, position);
                   if (wanted.functions) {
                     facts.functions[place] =
                         function_times(facts.times[place].spent.compute, prices_of(cost));
                   }
                   if (wanted.extents) {
                     facts.extents[place] = met_extents();
                   }
                 });
}

void see_pixels(const Scene& scene, const Machine& machine, int threads, PixelFacts& facts) {
  const PreparedScene<float> prepared(packed_scene<float>(scene, picture_format_of(machine)));
  facts.sights.resize(static_cast<std::size_t>(facts.zone.pixels()));
  for_each_pixel(prepared.frame(), facts.zone, threads,
                 [&](const auto& area, std::size_t place, const models::PixelPosition& position) {
                   facts.sights[place] = pixel_sight(prepared.frame(), area, position);
                 });
}

/// As the database numbers them: those that a primitive has.
std::vector<std::string> seen_surfaces(const Scene& scene) {
  std::vector<bool> is_used(scene.surfaces.size());
  for (const TreeLeaf& leaf : object_tree_of(scene).leaves) {
    is_used[leaf.surface] = true;
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    if (is_used[i]) {
      names.push_back(scene.surfaces[i].name);
    }
  }
  return names;
}

}  // namespace

void synthesise_facts(const Scene& scene, const Machine& machine, const RecordedFrame* record,
                      const WantedFacts& wanted, int threads, PixelFacts& facts) {
  if (wanted.functions || wanted.extents ||
      ((wanted.work || wanted.counted) && record == nullptr)) {
    count_pixels(scene, machine, wanted, threads, facts);
  } else if (wanted.work || wanted.counted) {
    facts.pixels = record->pixels;
  }
  if (wanted.counted) {
    const models::WorkCost cost(machine.parameters.board);
    for (const models::SynthesizedPixel& pixel : facts.pixels) {
      facts.counted.push_back(cost.duration(pixel.work));
    }
  }
  if (wanted.sights) {
    facts.surfaces = seen_surfaces(scene);
    see_pixels(scene, machine, threads, facts);
  }
}

}  // namespace maquette::sim
