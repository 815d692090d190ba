#include "sim/command_line/frame_choice.hpp"

#include <fmt/format.h>

#include <utility>

#include "sim/page/run_page.hpp"
#include "sim/page/sequence_page.hpp"
#include "sim/page/study_elements.hpp"
#include "sim/picture/image_file.hpp"
#include "sim/report/remark.hpp"
#include "sim/report/result_directory.hpp"
#include "sim/report/seconds.hpp"
#include "sim/run/execution_check.hpp"
#include "sim/run/interruption.hpp"
#include "sim/sequence/sequence_run.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

/// What shows or keeps one frame has no meaning for several.
void refuse_of_one_frame(const RunOptions& options) {
  const std::pair<bool, const char*> of_one[] = {
      {!options.record.empty() || options.processor == "recorded", "--record"},
      {!options.snapshots.empty(), "--snapshot"},
      {!options.shown_snapshots.empty(), "--snapshot-shown"},
      {!options.maps.empty(), "--map"},
      {!options.dumped_boards.empty(), "--dump-ram"},
      {!options.trace.files.empty() || !options.trace.lines.empty(), "--trace"}};
  for (const auto& [is_given, option] : of_one) {
    if (is_given) {
      throw DescriptionError(fmt::format(
          "{} is of one frame, but the scene has a sequence of them; --frame N is allowed with it",
          option));
    }
  }
}

/// A film of a sequence has a picture for each of its frames.
FilmRequest film_of_sequence(const RunOptions& options) {
  const FilmOptions& film = options.film;
  if (!film.step.empty() || film.pictures > 0 || film.as_fields) {
    throw DescriptionError(
        "--film-step, --film-frames and --film-fields are of one frame, but the scene has a "
        "sequence of them; --frame N is allowed with them");
  }
  return film_request(film);
}

void write_film(const FilmRequest& request, const std::filesystem::path& workplace,
                const SequenceResult& sequence) {
  std::size_t frame = 0;
  models::Duration time{};
  write_film(request, workplace, [&](FilmPicture& picture) {
    if (frame == sequence.frames.size()) {
      return false;
    }
    const std::string name = fmt::format("frame-{:04}.png", frame);
    picture.picture = decode_png(read_file(workplace / name), name);
    time += sequence.frames[frame].frame.load + sequence.frames[frame].frame.time;
    picture.caption =
        request.has_clock ? fmt::format("frame {}: {}", frame, readable_duration(time)) : "";
    ++frame;
    return true;
  });
}

}  // namespace

int run_frames(const RunOptions& options, const std::vector<std::string>& command,
               const Description& description, const std::function<double()>& host_time_s) {
  refuse_of_one_frame(options);
  const FilmRequest film = film_of_sequence(options);
  SimulationRequest request;
  request.executed = options.processor == "instruction";
  if (request.executed) {
    require_execution(description.machine);
  }
  const std::filesystem::path directory = run_directory_of(options, description);
  ResultDirectory results(directory);
  const Interruption interruption;
  const auto show = [&](std::size_t done) {
    if (!options.quiet) {
      remark(fmt::format("frame {} of {}\n", done, description.frames.size()));
    }
  };
  const SequenceResult sequence = run_sequence(description, request, results.workplace(), show);
  if (film.is_wanted() && !sequence.partial) {
    write_film(film, results.workplace(), sequence);
  }
  write_files(results.workplace(),
              {{"sequence.json", sequence_json(sequence)},
               {"config.yaml", effective_configuration(description.scene, description.machine)}});
  if (options.report && !sequence.frames.empty()) {
    write_files(results.workplace(),
                {{k_page_name,
                  sequence_page(results.workplace(), study_name(directory), data_directory())}});
  }
  results.publish(manifest_of(command, description.input_files, host_time_s()));
  if (!options.quiet) {
    fmt::print("{}\nwritten: {}\n", summarise_sequence(sequence), directory.string());
  }
  return sequence.partial ? k_exit_interrupted : 0;
}

const Scene* take_frame(const RunOptions& options, Description& description) {
  if (options.frame < 0) {
    return nullptr;
  }
  const auto frame = static_cast<std::size_t>(options.frame);
  if (frame >= description.frames.size()) {
    throw DescriptionError(SourcePosition{fmt::format("--frame {}", options.frame), 1, 1},
                           description.frames.empty() ? "the scene has no sequence"
                                                      : fmt::format("frames 0 to {} are allowed",
                                                                    description.frames.size() - 1));
  }
  const std::string name = fmt::format("{}-{:04}", description.scene.name, frame);
  description.scene = description.frames[frame];
  description.scene.name = name;
  return frame > 0 ? &description.frames[frame - 1] : nullptr;
}

}  // namespace maquette::sim
