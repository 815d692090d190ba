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

double likely_computing_s(const CountedSource& source, const Machine& machine) {
  SynthesisArea<firmware::Counted> area(source.frame().database);
  const auto look = [&] {
    return likely_computing_s(machine, source.useful_zone(), source.preprocessing(),
                              [&](const auto& position) {
                                return counted_pixel(source.frame(), area.view(), position).work;
                              });
  };
  return firmware::unless_stopped(look, 0.0);
}

void warn_of_time(double likely_s, const Warn& warn) {
  const std::optional<SceneWarning> warning = time_warning(likely_s);
  if (warn && warning) {
    warn(*warning);
  }
}

FramePixels recorded_pixels(const RecordedFrame& record, const Machine& machine, LegsOfPixels legs,
                            const Warn& warn) {
  const double likely_s =
      likely_computing_s(machine, record.useful_zone, record.preprocessing,
                         [&](const auto& position) { return record.at(position).work; });
  warn_of_time(likely_s, warn);
  if (may_take_long(likely_s)) {
    require_computing_time(machine, record);
  }
  if (legs == LegsOfPixels::told && !record.has_legs()) {
    throw std::logic_error("a record without the legs that a machine needs");
  }
  auto source = std::make_unique<RecordedSource>(record, machine);
  models::LegSource* const of_source = legs == LegsOfPixels::told ? source.get() : nullptr;
  return {nullptr, std::move(source), of_source, record.useful_zone};
}

void warn_of_frame(const Scene& scene, const CountedSource& source, const Warn& warn) {
  if (warn) {
    for (const SceneWarning& warning : frame_warnings(scene, source.frame())) {
      warn(warning);
    }
  }
}

}  // namespace

FramePixels frame_pixels(const Scene& scene, const Machine& machine, const RecordedFrame* record,
                         bool executed, int threads, LegsOfPixels legs, const Warn& warn) {
  if (record != nullptr) {
    return recorded_pixels(*record, machine, legs, warn);
  }
  const PictureFormat format = picture_format_of(machine);
  auto source = std::make_unique<CountedSource>(packed_scene<firmware::Counted>(scene, format),
                                                machine, threads, legs);
  warn_of_frame(scene, *source, warn);
  const double likely_s = executed && !warn ? 0 : likely_computing_s(*source, machine);
  warn_of_time(likely_s, warn);
  if (!executed && may_take_long(likely_s)) {
    const auto whole = [&] {
      return std::make_unique<RecordedFrame>(
          record_frame(scene, format, threads, FunctionsOfPixels::untold, legs));
    };
    if (auto made = firmware::unless_stopped(whole, std::unique_ptr<RecordedFrame>())) {
      FramePixels pixels = recorded_pixels(*made, machine, legs, {});
      pixels.record = std::move(made);
      return pixels;
    }
  }
  const models::PixelRectangle zone = source->useful_zone();
  models::LegSource* const of_source = legs == LegsOfPixels::told ? source.get() : nullptr;
  return {nullptr, std::move(source), of_source, zone};
}

}  // namespace maquette::sim
