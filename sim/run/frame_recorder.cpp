#include "sim/run/frame_recorder.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "sim/database/prepared_scene.hpp"
#include "sim/run/counted_pixel.hpp"

namespace maquette::sim {

namespace {

using Area = SynthesisArea<firmware::Counted>;

void record_row(const firmware::Frame<firmware::Counted>& frame, Area& area, int row,
                RecordedFrame& record) {
  const firmware::WorkArea<firmware::Counted> view = area.view();
  const models::PixelRectangle& zone = record.useful_zone;
  auto* pixel = record.pixels.data() +
                static_cast<std::ptrdiff_t>(row) * static_cast<std::ptrdiff_t>(zone.width);
  for (int column = 0; column < zone.width; ++column) {
    *pixel++ = counted_pixel(frame, view, {zone.column0 + column, zone.row0 + row});
  }
}

}  // namespace

RecordedFrame record_frame(const Scene& scene, const PictureFormat& format, int threads) {
  RecordedFrame record;
  record.key = record_key_of(packed_scene<float>(scene, format).database());
  firmware::reset_counted_work();
  const PreparedScene<firmware::Counted> prepared(packed_scene<firmware::Counted>(scene, format));
  record.preprocessing = firmware::counted_work();
  const firmware::Frame<firmware::Counted>& frame = prepared.frame();
  record.useful_zone = useful_zone_of(frame);
  record.pixels.resize(static_cast<std::size_t>(record.useful_zone.pixels()));

  tbb::task_arena arena(threads);
  tbb::enumerable_thread_specific<Area> areas([&frame] { return Area(frame.database); });
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, record.useful_zone.height),
                      [&](const tbb::blocked_range<int>& rows) {
                        for (int row = rows.begin(); row != rows.end(); ++row) {
                          record_row(frame, areas.local(), row, record);
                        }
                      });
  });
  return record;
}

}  // namespace maquette::sim
