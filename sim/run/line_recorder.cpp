#include "sim/run/line_recorder.hpp"

#include <memory>
#include <optional>
#include <vector>

#include "models/bus/kernel_time.hpp"
#include "sim/run/bus_recorder.hpp"

namespace maquette::sim {

namespace {

constexpr models::Instant k_before_the_frame{-1};

}  // namespace

void record_lines(models::CcettMachine& model, LineTrace& trace) {
  const auto numbers = std::make_shared<std::vector<std::vector<std::size_t>>>(model.backplanes());
  model.observe_lines([&model, &trace, numbers](std::size_t backplane,
                                                const models::LineState& line) {
    std::vector<std::size_t>& traced = (*numbers)[backplane];
    const auto number = static_cast<std::size_t>(line.line);
    if (number == traced.size()) {
      traced.push_back(trace.add({backplane_name(backplane), line.name, line.bits}, line.value));
      return;
    }
    const std::optional<models::Instant> start = model.started();
    trace.change(traced[number], start ? models::kernel_now() - *start : k_before_the_frame,
                 line.value);
  });
}

}  // namespace maquette::sim
