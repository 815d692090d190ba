#pragma once

#include "sim/fields/declaration.hpp"
#include "sim/fields/field_reader.hpp"
#include "sim/fields/field_writer.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/sweep/study.hpp"
#include "sim/sweep/study_types.hpp"

/// Every key of a study file, declared once.
namespace maquette::sim {

template <class Visitor>
void declare_element(Visitor& visitor, DerivedColumn& column) {
  visitor.field(required("name", "of the column"), column.name, TextType{});
  visitor.field({"unit", "of the column, for headers and axes"}, column.unit, TextType{});
  visitor.field({"sentence", "what the column is, for axes"}, column.sentence, TextType{});
  visitor.field(required("kind", "how the column comes from others"), column.derivation,
                ChoiceType<Derivation>{{{"speed_up", Derivation::speed_up},
                                        {"efficiency", Derivation::efficiency},
                                        {"ratio", Derivation::ratio}}});
  visitor.field(required("of", "the column it is about, e.g. frame.time_s"), column.of, TextType{});
  visitor.field(required("over", "the varied parameter along a series; of a ratio the denominator"),
                column.over, TextType{});
}

template <class Visitor>
void declare_element(Visitor& visitor, Plot& plot) {
  constexpr RealType k_number{RealDimension::number, {-1e300, 1e300}};
  visitor.field({"name", "of the plot's files"}, plot.name, FileNameType{});
  visitor.field({"kind", "how the plot shows the table"}, plot.kind,
                ChoiceType<PlotKind>{{{"lines", PlotKind::lines},
                                      {"tornado", PlotKind::tornado},
                                      {"histogram", PlotKind::histogram},
                                      {"scatter", PlotKind::scatter}}});
  visitor.field({"x", "column along the horizontal axis"}, plot.x, TextType{});
  visitor.field(required("y", "column that is shown"), plot.y, TextType{});
  visitor.field({"series", "column that tells lines from one another"}, plot.series, TextType{});
  visitor.field({"band", "column that marks the points of a scatter plot"}, plot.band, TextType{});
  visitor.field({"band_low", "from this value on"}, plot.band_low, k_number);
  visitor.field({"band_high", "up to this value"}, plot.band_high, k_number);
  visitor.field({"log_x", "logarithmic horizontal axis"}, plot.log_x, FlagType{});
  visitor.field({"log_y", "logarithmic vertical axis"}, plot.log_y, FlagType{});
  visitor.field({"title", "above the plot; else the study's sentence"}, plot.title, TextType{});
}

/// Several of one kind; `declare` declares the fields of one.
template <class Element>
struct ListType {
  [[nodiscard]] static std::vector<Element> read(const YamlNode& node, std::string_view name) {
    if (node.kind != YamlKind::sequence) {
      throw DescriptionError(node.place.position(), std::string{name} + ": " + node.kind_name() +
                                                        " stands here; a list is allowed");
    }
    std::vector<Element> elements;
    for (const YamlNode& item : node.items) {
      Element& element = elements.emplace_back();
      element.place = item.place;
      FieldReader reader{item, name};
      declare_element(reader, element);
      reader.finish();
    }
    return elements;
  }

  [[nodiscard]] static YamlNode write(const std::vector<Element>& elements) {
    YamlNode list = yaml_sequence({});
    for (Element element : elements) {
      FieldWriter writer;
      declare_element(writer, element);
      list.items.push_back(writer.take());
    }
    return list;
  }
};

/// What decides the points of a study and what each of them gives.
template <class Visitor>
void declare_points(Visitor& visitor, Study& study) {
  visitor.field(required("scene", "file, or scene inline"), study.scene, NodeType{});
  visitor.field({"machine", "file, shipped name, or machine inline; else the scene's own"},
                study.machine, NodeType{});
  visitor.field({"set", "parameters of every point, as for --set"}, study.changes, ChangesType{});
  visitor.field(required("vary", "parameters with their values, as for --vary"), study.axes,
                AxesType{});
  visitor.field({"design", "how points come from the axes"}, study.design,
                ChoiceType<StudyDesign>{{{"grid", StudyDesign::grid},
                                         {"zip", StudyDesign::zip},
                                         {"one_at_a_time", StudyDesign::one_at_a_time},
                                         {"latin_hypercube", StudyDesign::latin_hypercube}}});
  visitor.field({"samples", "of the Latin hypercube"}, study.samples,
                WholeType{WholeDimension::count, {1, k_most_values}});
  visitor.field({"seed", "of the Latin hypercube"}, study.seed,
                WholeType{WholeDimension::count, {0, 1'000'000'000}});
}

/// What is shown of the points.
template <class Visitor>
void declare_presentation(Visitor& visitor, Study& study) {
  visitor.field({"columns", "that the table gets besides"}, study.columns,
                ListType<DerivedColumn>{});
  visitor.field({"plots", "of the table"}, study.plots, ListType<Plot>{});
}

template <class Visitor>
void declare_study(Visitor& visitor, Study& study) {
  visitor.field(required("name", "of the study"), study.name, FileNameType{});
  visitor.field({"sentence", "what the study asks"}, study.sentence, TextType{});
  declare_points(visitor, study);
  declare_presentation(visitor, study);
}

}  // namespace maquette::sim
