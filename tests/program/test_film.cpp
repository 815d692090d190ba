#include <string>
#include <utility>
#include <vector>

#include "sim/picture/animated_png.hpp"
#include "sim/picture/image_file.hpp"
#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;
using maquette::sim::decode_png;
using maquette::sim::png_chunk;

namespace {

Outcome run_small(const ScratchDirectory& scratch, const std::string& options) {
  return run_maquette("run " + scratch.file("small.yaml", k_small_scene) + " --quiet --outdir " +
                      (scratch / "run").string() + k_small_frame + options);
}

void require_good(const Outcome& outcome) {
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
}

/// How many pictures a GIF has: each begins with an extension that controls it.
int pictures_in(const std::string& gif) {
  int pictures = 0;
  const std::string control("\x21\xF9\x04", 3);
  for (std::size_t at = gif.find(control); at != std::string::npos;
       at = gif.find(control, at + 1)) {
    ++pictures;
  }
  return pictures;
}

/// The chunks of a PNG file: types and contents.
std::vector<std::pair<std::string, std::string>> chunks_in(const std::string& file) {
  std::vector<std::pair<std::string, std::string>> chunks;
  for (std::size_t at = 8; at < file.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length = 256 * length + static_cast<unsigned char>(file[at + i]);
    }
    chunks.emplace_back(file.substr(at + 4, 4), file.substr(at + 8, length));
    at += length + 12;
  }
  return chunks;
}

}  // namespace

TEST_CASE("A film is an animated GIF of as many pictures as asked for, among the run's results") {
  const ScratchDirectory scratch;
  require_good(run_small(scratch, "--film film.gif --film-frames 5 --film-clock"));
  const std::string gif = content_of(scratch / "run" / "film.gif");
  CHECK(gif.substr(0, 6) == "GIF89a");
  CHECK(pictures_in(gif) == 5);
  CHECK_THAT(content_of(scratch / "run" / "manifest.json"), ContainsSubstring("\"film.gif\""));
  require_good(
      run_small(scratch, "--processor recorded --film film.gif --film-frames 5 --film-clock"));
  CHECK(content_of(scratch / "run" / "film.gif") == gif);
  require_good(run_small(scratch, ""));
  CHECK_FALSE(std::filesystem::exists(scratch / "run" / "film.gif"));
}

TEST_CASE("A film as an animated PNG has the pictures of the folder, in their order") {
  const ScratchDirectory scratch;
  const std::string four = " --film-frames 4 --film-clock";
  require_good(run_small(scratch, "--film " + (scratch / "pictures").string() + four));
  require_good(run_small(scratch, "--film film.png" + four));
  const std::string film = content_of(scratch / "run" / "film.png");
  CHECK_THAT(content_of(scratch / "run" / "manifest.json"), ContainsSubstring("\"film.png\""));
  const std::string signature_and_header = film.substr(0, 8 + 25);
  int sequence = 0;
  std::vector<std::string> data;
  for (const auto& [type, content] : chunks_in(film)) {
    if (type == "fcTL" || type == "fdAT") {
      CHECK(static_cast<int>(content[3]) == sequence++);
    }
    if (type == "fcTL") {
      data.emplace_back();
    } else if (type == "IDAT" || type == "fdAT") {
      data.back() += png_chunk("IDAT", content.substr(type == "IDAT" ? 0 : 4));
    }
  }
  REQUIRE(data.size() == 4);
  for (std::size_t i = 0; i < data.size(); ++i) {
    const std::string name = "film-000" + std::to_string(i + 1) + ".png";
    const std::string png = signature_and_header + data[i] + png_chunk("IEND", "");
    CHECK(decode_png(png, name).pixels ==
          decode_png(content_of(scratch / "pictures" / name), name).pixels);
  }
  CHECK(decode_png(film, "film").pixels ==
        decode_png(content_of(scratch / "pictures" / "film-0001.png"), "first").pixels);
}

TEST_CASE("A film as a folder shows the frame memory as snapshots do") {
  const ScratchDirectory scratch;
  require_good(run_small(scratch, "--film film --film-step '2 s' --snapshot-shown '2 s'"));
  CHECK(content_of(scratch / "run" / "film" / "film-0001.png") ==
        content_of(scratch / "run" / "snapshot-shown-2s.png"));
  require_good(run_small(
      scratch, "--film " + (scratch / "fields").string() + " --film-step '2 s' --film-fields"));
  const auto whole = decode_png(content_of(scratch / "run" / "frame.png"), "frame");
  const auto field = decode_png(content_of(scratch / "fields" / "film-0001.png"), "field");
  CHECK(field.width == whole.width);
  CHECK(field.pixels != whole.pixels);
}

TEST_CASE("The film of a sequence has a picture for each of its frames") {
  const ScratchDirectory scratch;
  require_good(run_maquette("run swelling --quiet --film film.gif --film-clock --outdir " +
                            (scratch / "run").string() + k_small_frame));
  int frames = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch / "run")) {
    frames += entry.path().filename().string().rfind("frame-", 0) == 0 &&
                      entry.path().extension() == ".png"
                  ? 1
                  : 0;
  }
  CHECK(frames > 1);
  CHECK(pictures_in(content_of(scratch / "run" / "film.gif")) == frames);
}

TEST_CASE("Films that can not be made are refused with what is allowed") {
  const ScratchDirectory scratch;
  const std::pair<const char*, const char*> refused[] = {
      {"--film film.mp4", "allowed: .gif, .png, or a folder"},
      {"--film film.gif --film-step '0 s'", "more than 0 s"},
      {"--film film.gif --film-step 5", "has no unit"},
      {"--film film.gif --film-step '1 us'", "up to 10000"}};
  for (const auto& [options, told] : refused) {
    const Outcome outcome = run_small(scratch, options);
    INFO(options);
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.errors, ContainsSubstring(told));
  }
  CHECK(run_small(scratch, "--film-clock").exit_code != 0);
  CHECK_FALSE(std::filesystem::exists(scratch / "run"));
}
