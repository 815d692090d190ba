#include "sim/sequence/sequence_run.hpp"

#include <fmt/format.h>

#include <exception>

#include "sim/picture/image_file.hpp"
#include "sim/report/remark.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/report/seconds.hpp"
#include "sim/report/statistics_json.hpp"
#include "sim/run/forked_jobs.hpp"
#include "sim/run/interruption.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

std::string statistics_name(std::size_t frame) { return fmt::format("stats-{:04}.json", frame); }

/// One frame, in a process of its own: SystemC elaborates once in each.
int run_frame(const Description& description, std::size_t frame, SimulationRequest request,
              const std::filesystem::path& directory) {
  if (frame > 0) {
    request.held = &description.frames[frame - 1];
  }
  request.warn = [frame](const SceneWarning& warning) {
    remark(fmt::format("frame {}: warning: {}\n", frame, warning.text));
  };
  const SimulationResult result =
      simulate(description.frames[frame], description.machine, request,
               [](models::Duration, double) { return !Interruption::is_requested(); });
  if (result.statistics.partial) {
    return k_job_interrupted;
  }
  write_files(directory, {{fmt::format("frame-{:04}.png", frame), encode_png(result.picture)},
                          {statistics_name(frame), statistics_json(result.statistics)}});
  return 0;
}

/// What all frames took.
struct SequenceTimes {
  models::Duration load{};
  models::Duration frames{};
};

SequenceTimes times_of(const SequenceResult& sequence) {
  SequenceTimes times;
  for (const Statistics& statistics : sequence.frames) {
    times.load += statistics.frame.load;
    times.frames += statistics.frame.time;
  }
  return times;
}

}  // namespace

SequenceResult run_sequence(const Description& description, const SimulationRequest& request,
                            const std::filesystem::path& directory,
                            const std::function<void(std::size_t done)>& show) {
  for (const Scene& scene : description.frames) {
    check_fit(scene, description.machine);
  }
  SequenceResult sequence;
  std::string failure;
  ForkedJobs jobs;
  jobs.count = description.frames.size();
  jobs.run = [&](std::size_t frame) {
    constexpr int k_failed = 1;
    try {
      return run_frame(description, frame, request, directory);
    } catch (const std::exception& error) {
      remark(fmt::format("frame {}: {}\n", frame, error.what()));
      return k_failed;
    }
  };
  jobs.ended = [&](std::size_t frame, const JobEnd& end) {
    if (end.exit_code != 0 || !end.crash.empty()) {
      failure = fmt::format("frame {} of the sequence has failed{}{}", frame,
                            end.crash.empty() ? "" : ": ", end.crash);
      return;
    }
    sequence.frames.push_back(
        parse_statistics(read_file(directory / statistics_name(frame)), statistics_name(frame)));
    show(sequence.frames.size());
  };
  sequence.partial = !run_forked(jobs);
  if (!failure.empty()) {
    throw DescriptionError(failure);
  }
  return sequence;
}

std::string sequence_json(const SequenceResult& sequence) {
  std::string frames;
  for (const Statistics& statistics : sequence.frames) {
    const FrameStatistics& frame = statistics.frame;
    frames += fmt::format(
        R"({}    {{"load_s": {}, "time_s": {}, "preprocess_s": {}, "synthesis_s": {}}})",
        frames.empty() ? "\n" : ",\n", format_seconds(frame.load), format_seconds(frame.time),
        format_seconds(frame.preprocess), format_seconds(frame.synthesis));
  }
  const SequenceTimes times = times_of(sequence);
  return fmt::format(
      "{{\n  \"frames\": [{}\n  ],\n  \"load_s\": {},\n  \"time_s\": {},\n  \"partial\": {}\n}}\n",
      frames, format_seconds(times.load), format_seconds(times.load + times.frames),
      sequence.partial);
}

std::string summarise_sequence(const SequenceResult& sequence) {
  std::string text = fmt::format("{:>5} {:>14} {:>14} {:>14}\n", "frame", "loading",
                                 "preprocessing", "frame time");
  for (std::size_t frame = 0; frame < sequence.frames.size(); ++frame) {
    const FrameStatistics& times = sequence.frames[frame].frame;
    text += fmt::format("{:>5} {:>14} {:>14} {:>14}\n", frame, readable_duration(times.load),
                        readable_duration(times.preprocess), readable_duration(times.time));
  }
  const SequenceTimes times = times_of(sequence);
  return text + fmt::format("sequence time   {}, of which loading {}{}\n",
                            readable_duration(times.load + times.frames),
                            readable_duration(times.load), sequence.partial ? "; partial" : "");
}

}  // namespace maquette::sim
