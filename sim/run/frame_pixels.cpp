#include "sim/run/frame_pixels.hpp"

#include <stdexcept>
#include <utility>

#include "firmware/arithmetic/stop_request.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/counted_source.hpp"
#include "sim/run/frame_recorder.hpp"
#include "sim/run/recorded_source.hpp"
#include "sim/run/time_forecast.hpp"

namespace maquette::sim {

namespace {

FramePixels recorded_pixels(const RecordedFrame& record, const Machine& machine,
                            LegsOfPixels legs) {
  if (may_take_long(machine, record.useful_zone, record.preprocessing,
                    [&](const auto& position) { return record.at(position).work; })) {
    require_computing_time(machine, record);
  }
  if (legs == LegsOfPixels::told && !record.has_legs()) {
    throw std::logic_error("a record without the legs that a machine needs");
  }
  auto source = std::make_unique<RecordedSource>(record, machine);
  models::LegSource* const of_source = legs == LegsOfPixels::told ? source.get() : nullptr;
  return {nullptr, std::move(source), of_source, record.useful_zone};
}

bool may_take_long(const CountedSource& source, const Machine& machine) {
  SynthesisArea<firmware::Counted> area(source.frame().database);
  const auto look = [&] {
    return may_take_long(machine, source.useful_zone(), source.preprocessing(),
                         [&](const auto& position) {
                           return counted_pixel(source.frame(), area.view(), position).work;
                         });
  };
  return firmware::unless_stopped(look, false);
}

}  // namespace

FramePixels frame_pixels(const Scene& scene, const Machine& machine, const RecordedFrame* record,
                         bool executed, int threads, LegsOfPixels legs) {
  if (record != nullptr) {
    return recorded_pixels(*record, machine, legs);
  }
  const PictureFormat format = picture_format_of(machine);
  auto source = std::make_unique<CountedSource>(packed_scene<firmware::Counted>(scene, format),
                                                machine, threads, legs);
  if (!executed && may_take_long(*source, machine)) {
    const auto whole = [&] {
      return std::make_unique<RecordedFrame>(
          record_frame(scene, format, threads, FunctionsOfPixels::untold, legs));
    };
    if (auto made = firmware::unless_stopped(whole, std::unique_ptr<RecordedFrame>())) {
      FramePixels pixels = recorded_pixels(*made, machine, legs);
      pixels.record = std::move(made);
      return pixels;
    }
  }
  const models::PixelRectangle zone = source->useful_zone();
  models::LegSource* const of_source = legs == LegsOfPixels::told ? source.get() : nullptr;
  return {nullptr, std::move(source), of_source, zone};
}

}  // namespace maquette::sim
