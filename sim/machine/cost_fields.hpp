#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

inline ChoiceType<ConfidenceMark> confidence_marks() {
  return {{{"R", ConfidenceMark::read},
           {"M", ConfidenceMark::measured},
           {"W", ConfidenceMark::stated},
           {"I", ConfidenceMark::inferred}}};
}

/// The source as declarations write it, with its mark in brackets.
inline std::string marked(const CostSource& source) {
  return source.text + " [" + confidence_marks().write(source.mark).text + "]";
}

/// Clocks and bus cycles of one operation; the keys are the units.
template <class Visitor>
void declare_cost(Visitor& visitor, models::OperationCost& cost, std::string_view source,
                  bool is_required) {
  constexpr RealType k_count{RealDimension::number, {0, 1e7}};
  visitor.field({"clocks", "processor clocks without wait states", source, is_required},
                cost.clocks, k_count);
  visitor.field({"reads", "16-bit bus reads among them", source, is_required}, cost.reads, k_count);
  visitor.field({"writes", "16-bit bus writes among them", source, is_required}, cost.writes,
                k_count);
}

/// Where the cost of an operation comes from.
template <class Visitor>
void declare_source(Visitor& visitor, CostSource& source) {
  visitor.field(required("source", "where the figures come from"), source.text, TextType{});
  visitor.field(required("mark", "R read, M measured, W widely stated, I inferred"), source.mark,
                confidence_marks());
}

/// The fields of a table of models/arithmetic/: every operation of arithmetic in
/// firmware/arithmetic/work.hpp.
template <class Visitor>
void declare_arithmetic(Visitor& visitor, models::ArithmeticCosts& costs, CostTables& tables) {
  visitor.field(required("name", "name of the cost table"), tables.arithmetic, TextType{});
  visitor.field(required("code", "of the package in a board's RAM, loaded by the host"),
                costs.package_bytes, WholeType{WholeDimension::memory, {0, 16 * k_mebibyte}});
  visitor.field(
      required(
          "execution",
          "of boards that execute their program: none (it is no package of an MC68000), costs (the "
          "host computes, a call costs what the table says), exact (the host computes, a call "
          "costs what the project's package takes on its operands), package (which is executed)"),
      costs.execution,
      ChoiceType<models::ArithmeticExecution>{{{"none", models::ArithmeticExecution::none},
                                               {"costs", models::ArithmeticExecution::costs},
                                               {"exact", models::ArithmeticExecution::exact},
                                               {"package", models::ArithmeticExecution::package}}});
  visitor.field(
      {"numbers", "format of the numbers in a program that boards execute; ffp without"},
      costs.numbers,
      ChoiceType<firmware::NumberFormat>{{{"ffp", firmware::NumberFormat::ffp},
                                          {"ieee_single", firmware::NumberFormat::ieee_single}}});
  for (std::size_t i = 0; i < firmware::k_arithmetic_count; ++i) {
    visitor.group(required(firmware::k_operation_names[i], "cost of this operation"), [&, i] {
      CostSource& source = tables.sources[i];
      declare_cost(visitor, costs.operations[i], marked(source), true);
      visitor.field(required("called", "a call that pays board.call_overhead; false: in line"),
                    costs.called[i], FlagType{});
      declare_source(visitor, source);
    });
  }
}

/// The fields of a table of models/program/: every event of the process in
/// firmware/arithmetic/work.hpp.
template <class Visitor>
void declare_program(Visitor& visitor, models::ArithmeticCosts& costs, CostTables& tables) {
  visitor.field(required("name", "name of the cost table"), tables.program, TextType{});
  for (std::size_t i = firmware::k_arithmetic_count; i < firmware::k_operation_count; ++i) {
    visitor.group(required(firmware::k_operation_names[i],
                           "what the program takes for this event, besides arithmetic"),
                  [&, i] {
                    CostSource& source = tables.sources[i];
                    declare_cost(visitor, costs.operations[i], marked(source), true);
                    declare_source(visitor, source);
                  });
  }
}

}  // namespace maquette::sim
