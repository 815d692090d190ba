#include "sim/run/frame_recorder.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <vector>

#include "sim/database/prepared_scene.hpp"
#include "sim/run/pixel_run.hpp"

namespace maquette::sim {

namespace {

using Area = SynthesisArea<firmware::Counted>;

/// The legs of the row go into a table of its own, if there is one.
void record_row(const firmware::Frame<firmware::Counted>& frame, Area& area, int row,
                RecordedFrame& record, FunctionWork& by_function, LegTable* legs) {
  PixelRun run(by_function, legs == nullptr ? LegsOfPixels::untold : LegsOfPixels::told);
  const firmware::WorkArea<firmware::Counted> view = area.view();
  const models::PixelRectangle& zone = record.useful_zone;
  const auto place = [&](int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(zone.width) +
           static_cast<std::size_t>(column);
  };
  for (int column = 0; column < zone.width; ++column) {
    firmware::end_if_requested();
    record.pixels[place(column)] = run.pixel(frame, view, {zone.column0 + column, zone.row0 + row});
    if (legs != nullptr) {
      legs->put(run.legs());
    }
    if (!record.functions.empty()) {
      record.functions[place(column)] = function_counts(firmware::counted_meter);
      run.settle();
    }
  }
}

}  // namespace

RecordedFrame record_frame(const Scene& scene, const PictureFormat& format, int threads,
                           FunctionsOfPixels functions, LegsOfPixels legs) {
  RecordedFrame record;
  record.key = record_key_of(packed_scene<float>(scene, format));
  firmware::reset_counted_work();
  const PreparedScene<firmware::Counted> prepared(packed_scene<firmware::Counted>(scene, format));
  record.preprocessing = firmware::counted_work();
  record.by_function.preprocessing.add(firmware::counted_meter);
  const firmware::Frame<firmware::Counted>& frame = prepared.frame();
  record.useful_zone = useful_zone_of(frame);
  record.pixels.resize(static_cast<std::size_t>(record.useful_zone.pixels()));
  if (functions == FunctionsOfPixels::told) {
    record.functions.resize(record.pixels.size());
  }

  std::vector<LegTable> legs_of_rows(
      legs == LegsOfPixels::told ? static_cast<std::size_t>(record.useful_zone.height) : 0);
  tbb::task_arena arena(threads);
  tbb::enumerable_thread_specific<Area> areas([&frame] { return Area(frame.database); });
  tbb::enumerable_thread_specific<FunctionWork> by_function;
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, record.useful_zone.height),
        [&](const tbb::blocked_range<int>& rows) {
          for (int row = rows.begin(); row != rows.end(); ++row) {
            LegTable* const of_row =
                legs == LegsOfPixels::told ? &legs_of_rows[static_cast<std::size_t>(row)] : nullptr;
            record_row(frame, areas.local(), row, record, by_function.local(), of_row);
          }
        });
  });
  for (const FunctionWork& of_thread : by_function) {
    record.by_function.pixels.add(of_thread);
  }
  for (const LegTable& of_row : legs_of_rows) {
    record.legs.append(of_row);
  }
  return record;
}

}  // namespace maquette::sim
