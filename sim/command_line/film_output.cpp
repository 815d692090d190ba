#include "sim/command_line/film_output.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "sim/fields/time_text.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/report/seconds.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

constexpr int k_pictures = 50;
constexpr double k_pictures_per_s = 10;

[[noreturn]] void fail(const std::string& option, const std::string& what) {
  throw DescriptionError(SourcePosition{option, 1, 1}, what);
}

models::Duration step_of(const std::string& text) {
  const std::string option = "--film-step " + text;
  try {
    const models::Duration step(parse_time(text));
    if (step <= models::Duration::zero()) {
      fail(option, "no time passes; allowed: more than 0 s");
    }
    return step;
  } catch (const std::invalid_argument& error) {
    fail(option, error.what());
  }
}

}  // namespace

void add_film_options(CLI::App& verb, FilmOptions& options) {
  CLI::Option* const film =
      verb.add_option("--film", options.place,
                      "show the frame memory as the video reader shows it while it fills: an "
                      "animated .gif, or .png, which is faster and has all colours, or a folder of "
                      "pictures; a name alone is put into the run "
                      "directory")
          ->type_name("FILE.gif|FILE.png|DIR");
  CLI::Option* const step =
      verb.add_option("--film-step", options.step, "simulated time between two of its pictures")
          ->type_name("TIME")
          ->needs(film);
  verb.add_option("--film-frames", options.pictures,
                  fmt::format("number of its pictures (default: {})", k_pictures))
      ->type_name("N")
      ->check(CLI::Range(1, 10'000))
      ->needs(film)
      ->excludes(step);
  verb.add_flag("--film-fields", options.as_fields,
                "show the lines of one interlaced field in each picture")
      ->needs(film);
  verb.add_flag("--film-clock", options.has_clock, "show the simulated time in its corner")
      ->needs(film);
}

FilmRequest film_request(const FilmOptions& options) {
  FilmRequest request{options.place, {}, options.pictures, options.as_fields, options.has_clock};
  const std::string extension = request.place.extension().string();
  if (!extension.empty() && !request.is_one_file()) {
    fail("--film " + options.place,
         "films as `" + extension +
             "` are not written; allowed: .gif, .png, or a folder, whose name "
             "has no extension");
  }
  if (!options.step.empty()) {
    request.step = step_of(options.step);
  } else if (request.pictures == 0) {
    request.pictures = k_pictures;
  }
  return request;
}

void write_film(const FilmRequest& request, const std::filesystem::path& workplace,
                const NextFilmPicture& next) {
  const std::filesystem::path place = place_of_result(request.place, workplace);
  if (request.is_one_file()) {
    create_run_directory(place.parent_path());
    write_files(
        place.parent_path(),
        {{place.filename().string(), request.is_gif() ? encode_film(k_pictures_per_s, next)
                                                      : encode_png_film(k_pictures_per_s, next)}});
    return;
  }
  std::vector<NamedContent> files;
  for (FilmPicture picture; next(picture);) {
    files.push_back(
        {fmt::format("film-{:04}.png", files.size() + 1), encode_film_picture(picture)});
  }
  create_run_directory(place);
  write_files(place, files);
}

void write_film(const FilmRequest& request, const std::filesystem::path& workplace,
                const FrameFilm& film) {
  const std::vector<models::Duration> instants = [&] {
    try {
      return film_instants(film.frame_time, request.step, request.pictures);
    } catch (const std::invalid_argument& error) {
      throw DescriptionError(std::string("--film-step ") + error.what());
    }
  }();
  auto instant = instants.begin();
  write_film(request, workplace, [&](FilmPicture& picture) {
    if (instant == instants.end()) {
      return false;
    }
    picture.picture = film_picture(film, *instant, request.as_fields);
    picture.caption = request.has_clock ? readable_duration(*instant) : "";
    ++instant;
    return true;
  });
}

}  // namespace maquette::sim
