#include "sim/sweep/point_selection.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <string_view>
#include <system_error>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = result.ec == std::errc{} && result.ptr == text.data() + text.size();
  return is_number && value >= 0 ? std::optional{value} : std::nullopt;
}

std::optional<int> variable(const Environment& environment, const char* name) {
  const char* text = environment(name);
  return text == nullptr ? std::nullopt : whole_number(text);
}

std::optional<TaskShare> checked(const std::optional<int>& task, const std::optional<int>& tasks) {
  return task && tasks && *task < *tasks ? std::optional{TaskShare{*task, *tasks}} : std::nullopt;
}

std::optional<TaskShare> array_share(const Environment& environment) {
  const auto number = variable(environment, "SLURM_ARRAY_TASK_ID");
  const int first = variable(environment, "SLURM_ARRAY_TASK_MIN").value_or(0);
  const int step = variable(environment, "SLURM_ARRAY_TASK_STEP").value_or(1);
  const auto count = variable(environment, "SLURM_ARRAY_TASK_COUNT");
  if (!number || *number < first || step < 1) {
    return std::nullopt;
  }
  return checked((*number - first) / step, count);
}

std::optional<TaskShare> rank_share(const Environment& environment) {
  // Slurm sets SLURM_NTASKS in the batch script too, which runs once: only steps have ranks.
  constexpr std::array<std::array<const char*, 2>, 3> k_names{
      {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
       {"PMI_RANK", "PMI_SIZE"},
       {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"}}};
  for (const auto& [rank, size] : k_names) {
    if (const auto share = checked(variable(environment, rank), variable(environment, size))) {
      return share;
    }
  }
  return std::nullopt;
}

}  // namespace

TaskShare share_of_environment(const Environment& environment) {
  const std::optional<TaskShare> array = array_share(environment);
  const std::optional<TaskShare> rank = rank_share(environment);
  if (!array && !rank) {
    throw DescriptionError(
        "--from-environment: neither a Slurm array nor MPI ranks are in the environment; allowed: "
        "SLURM_ARRAY_TASK_ID with SLURM_ARRAY_TASK_COUNT, OMPI_COMM_WORLD_RANK with "
        "OMPI_COMM_WORLD_SIZE, PMI_RANK with PMI_SIZE, SLURM_PROCID with SLURM_STEP_NUM_TASKS");
  }
  const TaskShare outer = array.value_or(TaskShare{});
  const TaskShare inner = rank.value_or(TaskShare{});
  return {outer.task * inner.tasks + inner.task, outer.tasks * inner.tasks};
}

std::vector<int> points_of(const TaskShare& share, int count) {
  std::vector<int> points;
  for (std::int64_t point = share.task; point < count; point += share.tasks) {
    points.push_back(static_cast<int>(point));
  }
  return points;
}

std::vector<int> parse_points(const std::string& text, const std::string& option, int count) {
  const std::size_t dots = text.find("..");
  const auto first = whole_number(std::string_view{text}.substr(0, dots));
  const auto last =
      dots == std::string::npos ? first : whole_number(std::string_view{text}.substr(dots + 2));
  if (!first || !last || *last < *first || *last >= count) {
    throw DescriptionError({option + " " + text, 1, 1},
                           fmt::format("the study has the points 0 to {}; one of them or "
                                       "FIRST..LAST is allowed",
                                       count - 1));
  }
  std::vector<int> points;
  for (int point = *first; point <= *last; ++point) {
    points.push_back(point);
  }
  return points;
}

}  // namespace maquette::sim
