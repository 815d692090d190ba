#include "sim/sweep/point_list.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "sim/sweep/latin_hypercube.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

AxisValue value_of(const Measure& measure, const YamlPlace& place) {
  YamlNode node = yaml_scalar(write_measure(measure));
  node.place = place;
  std::string text = node.text;
  return {std::move(text), std::move(node)};
}

[[noreturn]] void fail(const Axis& axis, const std::string& message) {
  throw DescriptionError(axis.steps.front().place.position(), axis.path + ": " + message);
}

/// All values of an axis. A range without step or count stands for its two ends if `ends_only`.
std::vector<AxisValue> all_values(const Axis& axis, bool is_whole_parameter, bool ends_only) {
  std::vector<AxisValue> values;
  for (const auto& piece : axis.pieces) {
    if (const auto* value = std::get_if<AxisValue>(&piece)) {
      values.push_back(*value);
      continue;
    }
    ValueRange range = std::get<ValueRange>(piece);
    if (ends_only && !range.step && !range.count) {
      range.count = 2;
    }
    for (const Measure& measure :
         values_of(range, is_whole_parameter || is_whole_unit(range.unit))) {
      values.push_back(value_of(measure, range.place));
    }
  }
  if (values.size() > static_cast<std::size_t>(k_most_values)) {
    fail(axis, "more than " + std::to_string(k_most_values) + " values");
  }
  return values;
}

/// The values of an axis at the given shares of it: of one range, or of a list of values.
std::vector<AxisValue> sampled_values(const Axis& axis, bool is_whole_parameter,
                                      const std::vector<double>& shares) {
  const auto* range = std::get_if<ValueRange>(&axis.pieces.front());
  std::vector<AxisValue> values;
  for (const double share : shares) {
    if (range != nullptr) {
      const bool is_whole = is_whole_parameter || is_whole_unit(range->unit);
      values.push_back(value_of(value_at(*range, is_whole, share), range->place));
    } else {
      const auto choice = static_cast<std::size_t>(share * static_cast<double>(axis.pieces.size()));
      values.push_back(std::get<AxisValue>(axis.pieces[choice]));
    }
  }
  return values;
}

void check_can_be_sampled(const Axis& axis) {
  for (const auto& piece : axis.pieces) {
    const auto* range = std::get_if<ValueRange>(&piece);
    if (range != nullptr && (axis.pieces.size() > 1 || range->step || range->count)) {
      fail(axis,
           "a Latin hypercube takes its values from one range without step and count, or "
           "from a list without ranges");
    }
  }
}

std::int64_t grid_size(const std::vector<std::vector<AxisValue>>& values) {
  std::int64_t size = 1;
  for (const auto& axis : values) {
    size = std::min<std::int64_t>(size * static_cast<std::int64_t>(axis.size()),
                                  std::int64_t{k_most_values} + 1);
  }
  return size;
}

std::int64_t zip_size(const std::vector<Axis>& axes,
                      const std::vector<std::vector<AxisValue>>& values) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i].size() != values[0].size()) {
      fail(axes[i], std::to_string(values[i].size()) + " values stand here and " +
                        std::to_string(values[0].size()) + " at " + axes[0].path +
                        "; paired axes need equally many");
    }
  }
  return values.empty() ? 0 : static_cast<std::int64_t>(values[0].size());
}

}  // namespace

PointList::PointList(const Study& study, const OwnValues& own) : design_(study.design) {
  const auto shares = is_sampled(design_)
                          ? latin_hypercube(static_cast<int>(study.axes.size()), study.samples,
                                            static_cast<std::uint64_t>(study.seed))
                          : std::vector<std::vector<double>>{};
  std::int64_t values = 0;
  for (const Axis& axis : study.axes) {
    const bool is_whole = own.is_whole(axis.path);
    if (is_sampled(design_)) {
      check_can_be_sampled(axis);
      values_.push_back(sampled_values(axis, is_whole, shares[values_.size()]));
    } else {
      values_.push_back(all_values(axis, is_whole, varies_single_axes(design_)));
    }
    values += static_cast<std::int64_t>(values_.back().size());
  }
  std::int64_t size = 0;
  switch (design_) {
    case StudyDesign::grid:
      size = grid_size(values_);
      break;
    case StudyDesign::zip:
      size = zip_size(study.axes, values_);
      break;
    case StudyDesign::one_at_a_time:
      size = 1 + values;
      break;
    case StudyDesign::latin_hypercube:
      size = 1 + std::int64_t{study.samples};
      break;
  }
  if (size > k_most_values) {
    throw DescriptionError("the study has more than " + std::to_string(k_most_values) + " points");
  }
  size_ = static_cast<int>(size);
}

std::vector<const AxisValue*> PointList::values(int point) const {
  std::vector<const AxisValue*> result(values_.size(), nullptr);
  auto rest = static_cast<std::size_t>(point);
  if (plain_point(design_) == point) {
    return result;
  }
  switch (design_) {
    case StudyDesign::grid:
      for (std::size_t axis = values_.size(); axis > 0; --axis) {
        const auto& values = values_[axis - 1];
        result[axis - 1] = &values[rest % values.size()];
        rest /= values.size();
      }
      break;
    case StudyDesign::zip:
      for (std::size_t axis = 0; axis < values_.size(); ++axis) {
        result[axis] = &values_[axis][rest];
      }
      break;
    case StudyDesign::one_at_a_time:
      --rest;
      for (std::size_t axis = 0; axis < values_.size(); ++axis) {
        if (rest < values_[axis].size()) {
          result[axis] = &values_[axis][rest];
          break;
        }
        rest -= values_[axis].size();
      }
      break;
    case StudyDesign::latin_hypercube:
      for (std::size_t axis = 0; axis < values_.size(); ++axis) {
        result[axis] = &values_[axis][rest - 1];
      }
      break;
  }
  return result;
}

}  // namespace maquette::sim
