#pragma once

#include <array>
#include <optional>

#include "models/unit/unit_parameters.hpp"
#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/machine/cost_fields.hpp"

/// The parameters of function units, which are there only in machines that have some.
namespace maquette::sim {

inline constexpr const char* k_unit_kind_sentences[models::k_unit_kind_count] = {
    "units that compare rays with extents and find the way to leaves",
    "units that intersect rays with primitives", "units that combine segments of rays",
    "units that find points, normals and luminances",
    "units that do all but the board's part of reflected, refracted and shadow rays"};

/// Costs of a kind's own; check_units has both tables or none.
template <class Visitor>
void declare_unit_costs(Visitor& visitor, std::optional<models::ArithmeticCosts>& costs,
                        CostTables& tables) {
  const auto own = [&costs]() -> models::ArithmeticCosts& {
    return costs ? *costs : costs.emplace();
  };
  bool has_arithmetic = costs.has_value();
  bool has_program = has_arithmetic;
  visitor.optional_group(
      {"arithmetic", "cost of every operation of arithmetic; the boards' without"}, has_arithmetic,
      [&] { declare_arithmetic(visitor, own(), tables); });
  visitor.optional_group({"program", "cost of every event of the process; the boards' without"},
                         has_program, [&] { declare_program(visitor, own(), tables); });
}

template <class Visitor>
void declare_unit_kind(Visitor& visitor, models::FunctionUnitParameters& unit, CostTables& tables) {
  visitor.field({"number", "of units of this kind; 0: boards do it", "a question asked [I]"},
                unit.number, WholeType{WholeDimension::count, {0, 256}});
  visitor.field({"queue", "places of each unit for errands that are on the bus or wait",
                 "a question asked [I]"},
                unit.queue, WholeType{WholeDimension::count, {1, 1024}});
  visitor.field({"choice", "the unit with the least before it, or one told by the pixel's place",
                 "a question asked [I]"},
                unit.choice,
                ChoiceType<models::UnitChoice>{{{"first_come", models::UnitChoice::first_come},
                                                {"by_pixel", models::UnitChoice::by_pixel}}});
  visitor.field({"clock", "of the unit's own work; the boards' without", "as the boards [I]"},
                unit.clock_hz, RealType{RealDimension::frequency, {1e3, 1e12}});
  declare_unit_costs(visitor, unit.costs, tables);
  visitor.field({"request_level", "on the bus, chained behind the boards; 4 is the highest",
                 "above the boards, lest answers wait for errands [I]"},
                unit.request_level, WholeType{WholeDimension::count, {0, 4}});
  visitor.field({"access_time", "of its mailbox and its RAM, seen from the bus",
                 "as a board's second port [I]"},
                unit.access_time, WholeType{WholeDimension::time, {0, 1'000'000'000'000}});
  visitor.field({"ram", "of each unit, for the database of what it serves", "as a board [I]"},
                unit.ram_bytes, WholeType{WholeDimension::memory, {1024, 16 * k_mebibyte}});
}

/// A kind that is described has a unit.
template <class Visitor>
void declare_units(Visitor& visitor, models::UnitsParameters& units,
                   std::array<CostTables, models::k_unit_kind_count>& tables) {
  bool present = models::has_units(units);
  visitor.optional_group(
      {"units", "function units, to which boards hand out parts of a pixel's process"}, present,
      [&] {
        visitor.field({"in_flight", "pixels that a board has begun and not yet written, at most",
                       "1: a board waits for what it has handed out [I]"},
                      units.in_flight, WholeType{WholeDimension::count, {1, 1024}});
        for (std::size_t kind = 0; kind < units.kinds.size(); ++kind) {
          models::FunctionUnitParameters& unit = units.kinds[kind];
          bool is_there = unit.number > 0;
          visitor.optional_group({models::k_unit_kind_names[kind], k_unit_kind_sentences[kind]},
                                 is_there, [&] {
                                   unit.number = is_there && unit.number == 0 ? 1 : unit.number;
                                   declare_unit_kind(visitor, unit, tables[kind]);
                                 });
        }
      });
}

}  // namespace maquette::sim
