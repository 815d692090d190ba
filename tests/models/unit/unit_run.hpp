#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "models/unit/pixel_leg.hpp"
#include "tests/models/machine/machine_run.hpp"

/// Machines with function units, for tests. A node costs one clock of 8 MHz, nothing else does.
namespace maquette::models::traffic {

/// A leg of so many clocks, which hands over so many numbers both ways.
inline PixelLeg leg(Stage stage, std::uint32_t clocks, std::uint16_t numbers_in = 7,
                    std::uint16_t numbers_out = 3,
                    firmware::RayKind ray = firmware::RayKind::primary) {
  PixelLeg one{stage, ray, 0, numbers_in, numbers_out, {}};
  one.work[firmware::Operation::node] = clocks;
  return one;
}

using Legs = std::vector<PixelLeg>;
using LegsOf = std::function<Legs(PixelPosition)>;

/// Pixels with their legs, told by a function.
class LeggedPixels : public PixelSource, public LegSource {
 public:
  LeggedPixels(const PixelAllotment& allotment, LegsOf legs_of, std::uint32_t preprocessing)
      : allotment_(allotment), legs_of_(std::move(legs_of)) {
    preprocessing_[firmware::Operation::node] = preprocessing;
  }

  const SynthesizedPixel& pixel(std::int64_t index) override {
    const PixelPosition position = allotment_.position(index);
    pixel_ = {static_cast<std::uint16_t>(position.column),
              static_cast<std::uint16_t>(position.row),
              0,
              colour(position),
              {1, 2, 3, 4},
              {}};
    legs_ = legs_of_(position);
    for (const PixelLeg& one : legs_) {
      pixel_.work[firmware::Operation::node] += one.work[firmware::Operation::node];
    }
    return pixel_;
  }

  [[nodiscard]] firmware::Work preprocessing() const override { return preprocessing_; }
  const std::vector<PixelLeg>& legs() override { return legs_; }

 private:
  SynthesizedPixel pixel_{};
  Legs legs_;
  PixelAllotment allotment_;
  LegsOf legs_of_;
  firmware::Work preprocessing_{};
};

inline FunctionUnitParameters& kind_of(MachineParameters& parameters, UnitKind kind) {
  return parameters.units.kinds[static_cast<std::size_t>(kind)];
}

/// A machine with units and the source that feeds it.
struct UnitRun {
  UnitRun(const std::string& name, const MachineParameters& parameters,
          const PixelRectangle& rectangle, LegsOf legs_of, std::uint32_t preprocessing = 5000)
      : source(PixelAllotment(parameters.allotment, rectangle,
                              static_cast<int>(parameters.boards.size())),
               std::move(legs_of), preprocessing),
        machine(name.c_str(), parameters, source, with_legs(rectangle)) {}

  LeggedPixels source;
  CcettMachine machine;

 private:
  FrameSetup with_legs(const PixelRectangle& rectangle) {
    FrameSetup setup = zone(rectangle);
    setup.legs = &source;
    setup.pixel_address = 0x1000;  // of boards that keep their pixels
    return setup;
  }
};

inline Duration sum_of_states(const BoardStatistics& states) {
  return states.compute + states.wait_grant + states.transfer + states.wait_unit + states.idle;
}

/// What holds of every machine with units that has finished.
inline void check_unit_run(const CcettMachine& machine) {
  const MachineStatistics statistics = machine.statistics();
  REQUIRE(statistics.has_finished);
  machine.verify_frame();
  Duration busy = statistics.host.transferred;
  Duration waited = statistics.host.waited;
  const auto add = [&](const BoardStatistics& states) {
    CHECK(sum_of_states(states) == statistics.frame_time);
    CHECK(states.idle >= Duration::zero());
    busy += states.transfer;
    waited += states.wait_grant;
  };
  for (const BoardStatistics& board : statistics.boards) {
    add(board);
  }
  for (std::size_t board = 0; board < statistics.boards.size(); ++board) {
    Duration for_units{};
    for (const UnitKindStatistics& kind : statistics.units) {
      for_units += kind.board_waits[board];
    }
    CHECK(for_units == statistics.boards[board].wait_unit);
  }
  for (const UnitKindStatistics& kind : statistics.units) {
    std::int64_t served = 0;
    for (const FunctionUnitStatistics& unit : kind.units) {
      add(unit.states);
      served += unit.errands;
    }
    CHECK(served == kind.places);
  }
  CHECK(busy == total(statistics.bus).busy);
  CHECK(waited == total(statistics.bus).waited);
}

}  // namespace maquette::models::traffic
