#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "models/bus/duration.hpp"
#include "sim/picture/film_file.hpp"
#include "sim/run/frame_film.hpp"

namespace maquette::sim {

/// The texts of a command line about a film; those that are not given are empty.
struct FilmOptions {
  std::string place;
  std::string step;
  int pictures = 0;
  bool as_fields = false;
  bool has_clock = false;
};

/// A film that is to be made.
struct FilmRequest {
  std::filesystem::path place;
  models::Duration step{};  ///< zero: `pictures` of the frame
  int pictures = 0;
  bool as_fields = false;
  bool has_clock = false;

  [[nodiscard]] bool is_wanted() const { return !place.empty(); }
  [[nodiscard]] bool is_gif() const { return place.extension() == ".gif"; }
  [[nodiscard]] bool is_one_file() const { return is_gif() || place.extension() == ".png"; }
};

/// Adds --film and what goes with it to a verb.
void add_film_options(CLI::App& verb, FilmOptions& options);

/// Throws DescriptionError that says what is wrong and what is allowed.
FilmRequest film_request(const FilmOptions& options);

/// Writes the film: an animated GIF, or a folder of pictures. Throws DescriptionError.
void write_film(const FilmRequest& request, const std::filesystem::path& workplace,
                const NextFilmPicture& next);

/// The same of a frame.
void write_film(const FilmRequest& request, const std::filesystem::path& workplace,
                const FrameFilm& film);

}  // namespace maquette::sim
