#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "sim/machine/machine_description.hpp"
#include "sim/report/scalar_statistics.hpp"
#include "sim/report/statistics_json.hpp"
#include "sim/run/forked_jobs.hpp"
#include "sim/run/simulation.hpp"
#include "sim/scene/scene_description.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

/// A picture of 48 pixels with mirror, glass, shadows, and every parameter that a scene may have.
const std::string k_tiny_scene = R"(name: tiny
view: {eye: [0, -6, 1], target: [0, 0, 0], up: [0, 0, 1], field_of_view: 30 deg}
lights:
  key: {position: [5, -6, 8], intensity: [2.5, 2.5, 2.5]}
surfaces:
  red: {diffuse: [0.8, 0.1, 0.1]}
  silver: {specular: 1, metal: {index: [0.15, 0.14, 0.13], extinction: [3.9, 3.2, 2.4]}, half_angle: 4 deg}
  glass: {specular: 1, index: 1.5, transparent: true, absorption: [0.5, 0.1, 0.1]}
object:
  union:
    - difference: [box: {size: [1, 1, 1]}, {sphere: {radius: 0.6}, place: {translate: [0.5, -0.5, 0.5]}}]
      surface: red
    - {sphere: {radius: 0.4}, surface: silver, place: {translate: [-1, 0.2, 0]}}
    - {sphere: {radius: 0.3}, surface: glass, place: {translate: [0.9, -0.6, -0.1]}}
machine: {name: corners, frame_memory: {width: 8 pixels, height: 6 pixels}}
)";

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos;
       end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + separator.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

/// The values at the ends of a declared range, or all that can be chosen; none of a text.
std::vector<std::string> corners_of(const std::string& range) {
  const std::string three = "three of ";
  if (range.compare(0, three.size(), three) == 0) {
    std::vector<std::string> corners;
    for (const std::string& one : corners_of(range.substr(three.size()))) {
      corners.push_back("[" + one + ", " + one + ", " + one + "]");
    }
    return corners;
  }
  std::smatch ends;
  if (std::regex_match(range, ends, std::regex("above 0( [^,]+)?, to (.+)"))) {
    return {"1e-9" + ends[1].str(), ends[2]};
  }
  if (std::regex_match(range, ends, std::regex("([^,]+) to ([^,]+)"))) {
    return {ends[1], ends[2]};
  }
  return range.find(", ") == std::string::npos || range.find(" to ") != std::string::npos
             ? std::vector<std::string>{}
             : split(range, ", ");
}

/// All corners of one parameter.
using Corners = std::vector<std::string>;

Corners corners_of(const ParameterRow& row) {
  Corners corners;
  for (const std::string& value : corners_of(row.range)) {
    corners.push_back(row.path + "=" + value);
  }
  return corners;
}

/// What a machine and a scene can be, and what operations cost; the costs are many and alike.
struct AllCorners {
  std::vector<Corners> parameters;
  std::vector<Corners> costs;
};

AllCorners all_corners(const Description& description) {
  std::vector<ParameterRow> rows = list_parameters(description.machine);
  for (const ParameterRow& row : list_parameters(description.scene)) {
    rows.push_back(row);
  }
  AllCorners all;
  for (const ParameterRow& row : rows) {
    const bool is_cost =
        std::regex_match(row.path, std::regex("board\\.(program|arithmetic)\\..*"));
    const bool is_mark = std::regex_match(row.path, std::regex(".*\\.mark"));
    const Corners corners = corners_of(row);
    if (!corners.empty() && !is_mark) {
      (is_cost ? all.costs : all.parameters).push_back(corners);
    }
  }
  return all;
}

/// Overrides of one description each.
using Case = std::vector<std::string>;

constexpr std::size_t k_pairs = 500;
constexpr std::size_t k_crowds = 300;
constexpr std::size_t k_most_corners = 8;

/// Each corner by itself, and random corners of random parameters together.
std::vector<Case> all_cases(const AllCorners& corners) {
  std::vector<Case> cases;
  for (const auto* kind : {&corners.parameters, &corners.costs}) {
    for (const Corners& parameter : *kind) {
      for (const std::string& corner : parameter) {
        cases.push_back({"board.costs=tables", corner});
      }
    }
  }
  std::mt19937_64 random{1984};
  const auto any_of = [&random](const std::vector<Corners>& parameters) {
    const Corners& parameter = parameters[random() % parameters.size()];
    return parameter[random() % parameter.size()];
  };
  for (std::size_t i = 0; i < k_pairs + k_crowds; ++i) {
    const std::size_t size = i < k_pairs ? 2 : 3 + random() % (k_most_corners - 2);
    Case& one = cases.emplace_back();
    if (random() % 2 == 0) {
      one = {"board.costs=tables", any_of(corners.costs)};
    }
    for (std::size_t j = 0; j < size; ++j) {
      one.push_back(any_of(corners.parameters));
    }
  }
  return cases;
}

std::string text_of(const Case& one) {
  std::string text;
  for (const std::string& change : one) {
    text += " --set '" + change + "'";
  }
  return text;
}

/// Whether a message begins with file, line and column.
bool has_place(const std::string& message) {
  return std::regex_search(message, std::regex("^[^\n]+:[0-9]+:[0-9]+: ."));
}

/// No time is negative, and what is written reads back.
void require_sound(const Statistics& statistics) {
  const std::string written = statistics_json(statistics);
  if (statistics_json(parse_statistics(written, "stats.json")) != written) {
    throw std::logic_error("the statistics do not read back");
  }
  for (const ScalarStatistic& scalar : scalar_statistics(statistics)) {
    // What waited before the frame's start is told as such.
    const bool is_instant = scalar.name == "bus.longest_wait.requested_at_s";
    if (scalar.unit == "s" && !is_instant && scalar.text.compare(0, 1, "-") == 0) {
      throw std::logic_error(scalar.name + " is " + scalar.text);
    }
  }
}

constexpr int k_refused = 2;
constexpr int k_wrong = 3;

/// Of the processor, with sanitizers on a slow host; the longest case takes some seconds.
constexpr rlim_t k_limit_s = 300;

/// Simulates in a process of its own; why it is refused or wrong goes to a file.
int run_case(const Description& description, const std::string& message_file) {
  const rlimit limits{k_limit_s, k_limit_s + 1};
  ::setrlimit(RLIMIT_CPU, &limits);
  SimulationRequest request;
  request.picture = false;
  try {
    require_sound(simulate(description.scene, description.machine, request, [](auto, auto) {
                    return true;
                  }).statistics);
    return 0;
  } catch (const DescriptionError& error) {
    std::ofstream{message_file} << error.what();
    return k_refused;
  } catch (const std::exception& error) {
    std::ofstream{message_file} << error.what();
    return k_wrong;
  }
}

/// A frame that would take too long is that of scene and machine together, and has no place.
bool is_of_time(const std::string& message) {
  return message.find("100 days") != std::string::npos;
}

struct Outcomes {
  int results = 0;
  int refused_read = 0;
  int refused_late = 0;
};

void simulate_all(const std::vector<std::pair<Case, Description>>& machines, Outcomes& outcomes) {
  const tests::ScratchDirectory scratch;
  const auto message_file = [&scratch](std::size_t job) {
    return (scratch.path() / std::to_string(job)).string();
  };
  ForkedJobs jobs;
  jobs.count = machines.size();
  jobs.processes = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  jobs.run = [&](std::size_t job) { return run_case(machines[job].second, message_file(job)); };
  jobs.ended = [&](std::size_t job, const JobEnd& end) {
    const std::string message = read_text(message_file(job));
    INFO(text_of(machines[job].first) << ": " << message << end.crash);
    CHECK((end.exit_code == 0 || end.exit_code == k_refused));
    if (end.exit_code == k_refused) {
      CHECK((has_place(message) || is_of_time(message)));
    }
    ++(end.exit_code == 0 ? outcomes.results : outcomes.refused_late);
  };
  run_forked(jobs);
}

}  // namespace

TEST_CASE("machines and scenes at the corners of their ranges give a result or a refusal") {
  const Description plain = load_text(k_tiny_scene);
  const std::vector<Case> cases = all_cases(all_corners(plain));
  Outcomes outcomes;
  std::vector<std::pair<Case, Description>> machines;
  for (const Case& one : cases) {
    try {
      machines.emplace_back(one, load_text(k_tiny_scene, one));
    } catch (const DescriptionError& error) {
      INFO(text_of(one) << ": " << error.what());
      CHECK(has_place(error.what()));
      ++outcomes.refused_read;
    }
  }
  simulate_all(machines, outcomes);
  // All three happen, or the corners show nothing.
  CHECK(outcomes.results > 300);
  CHECK(outcomes.refused_read > 50);
  CHECK(outcomes.refused_late > 10);
}

}  // namespace maquette::sim
