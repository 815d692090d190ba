#include <map>
#include <set>

#include "sim/sweep/point_selection.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;

namespace {

TaskShare share_of(const std::map<std::string, std::string>& variables) {
  return share_of_environment([&variables](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
}

std::pair<int, int> numbers(const TaskShare& share) { return {share.task, share.tasks}; }

}  // namespace

TEST_CASE("the tasks together take every point once") {
  for (const int tasks : {1, 2, 3, 7, 20}) {
    std::multiset<int> taken;
    for (int task = 0; task < tasks; ++task) {
      for (const int point : points_of({task, tasks}, 13)) {
        taken.insert(point);
      }
    }
    CHECK(taken.size() == 13);
    CHECK(std::set<int>(taken.begin(), taken.end()).size() == 13);
  }
}

TEST_CASE("the share comes from a Slurm array, from MPI ranks, or from both") {
  CHECK(numbers(share_of({{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_COUNT", "8"}})) ==
        std::pair{3, 8});
  CHECK(numbers(share_of({{"SLURM_ARRAY_TASK_ID", "7"},
                          {"SLURM_ARRAY_TASK_MIN", "1"},
                          {"SLURM_ARRAY_TASK_STEP", "2"},
                          {"SLURM_ARRAY_TASK_COUNT", "4"}})) == std::pair{3, 4});
  CHECK(numbers(share_of({{"OMPI_COMM_WORLD_RANK", "1"}, {"OMPI_COMM_WORLD_SIZE", "4"}})) ==
        std::pair{1, 4});
  CHECK(numbers(share_of({{"PMI_RANK", "2"}, {"PMI_SIZE", "4"}})) == std::pair{2, 4});
  CHECK(numbers(share_of({{"SLURM_PROCID", "2"}, {"SLURM_STEP_NUM_TASKS", "3"}})) ==
        std::pair{2, 3});
  CHECK(numbers(share_of({{"SLURM_ARRAY_TASK_ID", "1"},
                          {"SLURM_ARRAY_TASK_COUNT", "2"},
                          {"SLURM_PROCID", "2"},
                          {"SLURM_STEP_NUM_TASKS", "3"}})) == std::pair{5, 6});
}

TEST_CASE("an environment that tells of no share is an error") {
  CHECK_THROWS_AS(share_of({}), DescriptionError);
  CHECK_THROWS_AS(share_of({{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "4"}}), DescriptionError);
  CHECK_THROWS_AS(share_of({{"PMI_RANK", "4"}, {"PMI_SIZE", "4"}}), DescriptionError);
}

TEST_CASE("points are chosen by number or range") {
  CHECK(parse_points("3", "--point", 5) == std::vector<int>{3});
  CHECK(parse_points("1..3", "--points", 5) == std::vector<int>{1, 2, 3});
  for (const char* text : {"5", "3..1", "-1", "x", "1..", "..2", "1..5"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_points(text, "--points", 5), DescriptionError);
  }
}
