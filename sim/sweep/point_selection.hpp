#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace maquette::sim {

/// One of several equal shares of a study's points: number `task`, `task + tasks`, ...
struct TaskShare {
  int task = 0;
  int tasks = 1;
};

/// The value of an environment variable; null when there is none.
using Environment = std::function<const char*(const char* name)>;

/// The share that falls to this process of a Slurm array (SLURM_ARRAY_TASK_ID, _MIN, _STEP,
/// _COUNT), of an MPI program or a step of srun (OMPI_COMM_WORLD_RANK and _SIZE, PMI_RANK and
/// _SIZE, SLURM_PROCID and SLURM_STEP_NUM_TASKS), or of ranks within an array. Throws
/// DescriptionError when the environment tells of none.
[[nodiscard]] TaskShare share_of_environment(const Environment& environment);

/// The points of a share of the points 0 to `count` - 1.
[[nodiscard]] std::vector<int> points_of(const TaskShare& share, int count);

/// Reads "3" or "3..7" as points of 0 to `count` - 1. Throws DescriptionError, whose file is
/// `option` with the text.
[[nodiscard]] std::vector<int> parse_points(const std::string& text, const std::string& option,
                                            int count);

}  // namespace maquette::sim
