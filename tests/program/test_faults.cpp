#include <algorithm>
#include <chrono>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;

namespace {

namespace fs = std::filesystem;
using Catch::Matchers::ContainsSubstring;

const std::string k_tiny_frame =
    " --set frame_memory.width=32pixels --set frame_memory.height=24pixels ";

/// A text as one word of a shell.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char character : text) {
    word += character == '\'' ? std::string{"'\\''"} : std::string{character};
  }
  return word + "'";
}

/// A command on the small scene; quick enough to be killed often.
std::string command(const ScratchDirectory& scratch, const std::string& verb) {
  return std::string(MAQUETTE_PROGRAM) + " " + verb + " " +
         quoted(scratch.file("small.yaml", k_small_scene)) + k_tiny_frame + "--quiet ";
}

/// Runs a script of a shell; its exit code, or 128 and the signal that ended it.
int shell(const std::string& script) {
  const int status = std::system(script.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// All files below a folder with their content; those in which the host's part stands are empty.
std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      const bool is_host = entry.path().filename() == "manifest.json";
      files[fs::relative(entry.path(), folder).string()] = is_host ? "" : content_of(entry.path());
    }
  }
  return files;
}

/// Whether a folder holds all files of another, with their bytes.
bool holds(const fs::path& folder, const fs::path& other) {
  const auto all = files_below(folder);
  const auto wanted = files_below(other);
  return std::includes(all.begin(), all.end(), wanted.begin(), wanted.end());
}

/// The names in a folder, hidden ones as well.
std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

void kill_after(const std::string& line, int milliseconds) {
  shell(line + " 2>/dev/null & pid=$!; sleep " + std::to_string(milliseconds / 1000.0) +
        "; kill -KILL $pid 2>/dev/null; wait $pid 2>/dev/null");
}

/// Of a command on this host, from the shell's start.
int milliseconds_of(const std::string& line) {
  const auto start = std::chrono::steady_clock::now();
  REQUIRE(shell(line) == 0);
  const auto time = std::chrono::steady_clock::now() - start;
  return static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
}

/// Kills a command at random instants and lets it end at last: it gives what it gives undisturbed,
/// and nothing else is left. `options` take the folder of the results in the place of %.
void kill_and_repeat(const std::string& verb, const std::string& options, int kills) {
  const ScratchDirectory scratch;
  const auto line = [&](const std::string& folder) {
    std::string text = options;
    fs::create_directory(scratch / folder);
    for (std::size_t at = text.find('%'); at != std::string::npos; at = text.find('%')) {
      text.replace(at, 1, (scratch / folder).string());
    }
    return command(scratch, verb) + text;
  };
  const int whole_ms = milliseconds_of(line("whole"));
  std::mt19937 random(1984);
  for (int i = 0; i < kills; ++i) {
    const fs::path results = scratch / "killed" / "results";
    const bool was_there = fs::exists(results);
    kill_after(line("killed"), static_cast<int>(random() % static_cast<unsigned>(whole_ms + 1)));
    // Earlier results are replaced file by file, the manifest last, from a folder among them.
    const bool is_whole = fs::exists(results / "manifest.json");
    CHECK((verb == "sweep" || was_there || is_whole == fs::exists(results)));
    CHECK((verb == "sweep" || !is_whole || holds(results, scratch / "whole" / "results")));
  }
  REQUIRE(shell(line("killed")) == 0);
  CHECK(files_below(scratch / "killed") == files_below(scratch / "whole"));
  CHECK(names_in(scratch / "killed") == names_in(scratch / "whole"));
}

/// Whether this test may mount file systems in a namespace of its own.
bool can_mount() { return shell("unshare --mount true 2>/dev/null") == 0; }

/// Runs a script where $disk is a file system of its own of so many KiB, which goes away with it.
int on_disk(const ScratchDirectory& scratch, int kibibytes, const std::string& script) {
  fs::create_directories(scratch / "disk");
  const std::string inner = "disk=" + (scratch / "disk").string() +
                            "; mount -t tmpfs -o size=" + std::to_string(kibibytes) +
                            "k none $disk || exit 99; " + script;
  return shell("unshare --mount sh -c " + quoted(inner));
}

}  // namespace

TEST_CASE("A run that is killed at any instant leaves whole results or none, and can be repeated") {
  kill_and_repeat("run", "--outdir %/results --record %/frame.exr --trace %/bus.json", 12);
}

TEST_CASE("A sweep that is killed at any instant goes on to the same bytes") {
  kill_and_repeat("sweep",
                  "--vary 'bus.arbitration_clocks=1..12 clocks' --plot "
                  "bus.arbitration_clocks,frame.time_s --outdir %/results",
                  6);
}

TEST_CASE("On a disk that is full a run leaves all of its results or nothing") {
  if (!can_mount()) {
    return;
  }
  const ScratchDirectory scratch;
  const std::string run = command(scratch, "run");
  int failed = 0;
  for (const int kibibytes : {4, 8, 16, 24, 32, 40, 48, 1024}) {
    const std::string errors = (scratch / "errors").string();
    const int code = on_disk(scratch, kibibytes,
                             run + "--outdir $disk/run 2>" + errors +
                                 "; code=$?; [ $code = 0 ] && left=run || left=; [ \"$(ls -A "
                                 "$disk)\" = \"$left\" ] || exit 98; exit $code");
    INFO(kibibytes << " KiB: " << content_of(scratch / "errors"));
    CHECK((code == 0 || code == 2));
    if (code == 2) {
      ++failed;
      CHECK_THAT(content_of(scratch / "errors"), ContainsSubstring("No space left"));
    }
  }
  CHECK(failed > 3);
  CHECK(failed < 8);
}

TEST_CASE("A sweep whose disk is full ends, and goes on when there is space") {
  if (!can_mount()) {
    return;
  }
  const ScratchDirectory scratch;
  const std::string sweep = command(scratch, "sweep") + "--vary 'processors=1..6' --outdir ";
  REQUIRE(shell(sweep + (scratch / "whole").string()) == 0);
  const int code = on_disk(
      scratch, 48,
      sweep +
          "$disk/study 2>/dev/null; [ $? -ne 0 ] || exit 98; mount -o remount,size=4m $disk && " +
          sweep + "$disk/study && cp -r $disk/study " + (scratch / "resumed").string());
  CHECK(code == 0);
  CHECK(files_below(scratch / "resumed") == files_below(scratch / "whole"));
}

TEST_CASE("A sweep whose folder becomes read-only ends, and goes on when it may write") {
  if (!can_mount()) {
    return;
  }
  const ScratchDirectory scratch;
  const std::string sweep =
      command(scratch, "sweep") + "--vary 'bus.arbitration_clocks=1..120 clocks' --outdir ";
  REQUIRE(shell(sweep + (scratch / "whole").string()) == 0);
  // The file system is busy while a point is written, so this is tried until it is not.
  const std::string script =
      sweep + "$disk/study 2>" + (scratch / "errors").string() +
      " & pid=$!; until [ -e $disk/study/points/000003.json ] || ! kill -0 $pid; do sleep 0.01; "
      "done; until mount -o remount,ro $disk 2>/dev/null || ! kill -0 $pid; do :; done; wait $pid; "
      "code=$?; mount -o remount,rw $disk; [ $code -ne 0 ] || [ -e $disk/study/manifest.json ] || "
      "exit 98; " +
      sweep + "$disk/study && cp -r $disk/study " + (scratch / "resumed").string();
  const int code = on_disk(scratch, 16384, script);
  INFO(content_of(scratch / "errors"));
  CHECK(code == 0);
  CHECK(files_below(scratch / "resumed") == files_below(scratch / "whole"));
}

TEST_CASE("Commands that run at once into one folder leave the results of one of them, whole") {
  for (const std::string& verb : {std::string("run"), std::string("sweep")}) {
    const ScratchDirectory scratch;
    const std::string line =
        command(scratch, verb) + (verb == "run" ? "" : "--vary processors=1..4 ") + "--outdir ";
    const std::string both = line + (scratch / "both").string();
    REQUIRE(shell(line + (scratch / "alone").string()) == 0);
    const std::set<std::string> names = names_in(scratch.path());
    CHECK(shell("(" + both + ") & first=$!; (" + both + ") & second=$!; (" + both +
                ") || exit 97; wait $first || exit 98; wait $second || exit 99") == 0);
    CHECK(files_below(scratch / "both") == files_below(scratch / "alone"));
    CHECK(names_in(scratch.path()).size() == names.size() + 1);
  }
}

TEST_CASE("Standard streams that are closed or full change no result and are no crash") {
  const ScratchDirectory scratch;
  const std::string quiet = command(scratch, "run");
  const std::string loud = quiet.substr(0, quiet.find("--quiet"));
  const std::string folder = (scratch / "run").string();
  const std::string trace = " --trace " + (scratch / "bus.json").string();
  REQUIRE(shell(quiet + trace + " --outdir " + folder) == 0);
  const auto expected = files_below(scratch / "run");
  const std::string expected_trace = content_of(scratch / "bus.json");
  for (const char* streams : {"<&-", "2>&-", "2>/dev/full", "<&- >&- 2>&-", ">/dev/full 2>&-"}) {
    INFO(streams);
    CHECK(shell(quiet + trace + " --outdir " + folder + " " + streams) == 0);
    CHECK(files_below(scratch / "run") == expected);
    CHECK(content_of(scratch / "bus.json") == expected_trace);
  }
  for (const char* streams :
       {">&-", ">/dev/full", ">&- 2>&-", ">/dev/full 2>/dev/full", "<&- >&- 2>&-"}) {
    INFO(streams);
    CHECK(shell(loud + trace + " --outdir " + folder + " " + streams) == 1);
    CHECK(content_of(scratch / "bus.json") == expected_trace);
  }
  CHECK(shell(std::string(MAQUETTE_PROGRAM) + " run nothing.yaml 2>/dev/full") == 2);
  CHECK(shell(std::string(MAQUETTE_PROGRAM) + " run nothing.yaml <&- >&- 2>&-") == 2);
}

TEST_CASE("A locale that writes commas changes no byte") {
  const ScratchDirectory scratch;
  const std::string locales = (scratch / "locales").string();
  fs::create_directory(locales);
  // Where no such locale can be made this shows nothing.
  if (shell("localedef -i de_DE -f UTF-8 " + locales + "/de_DE.UTF-8 >/dev/null 2>&1") != 0) {
    return;
  }
  const std::string line = command(scratch, "sweep") +
                           "--vary board.clock=8MHz,12.5MHz --plot board.clock,frame.time_s "
                           "--outdir ";
  REQUIRE(shell(line + (scratch / "points").string()) == 0);
  REQUIRE(shell("LOCPATH=" + locales + " LC_ALL=de_DE.UTF-8 " + line +
                (scratch / "commas").string()) == 0);
  CHECK(files_below(scratch / "commas") == files_below(scratch / "points"));
}

TEST_CASE("Odd names of files and folders are names as any other") {
  const ScratchDirectory scratch;
  REQUIRE(shell(command(scratch, "sweep") +
                "--vary processors=1,2 --plot processors,frame.time_s --outdir " +
                (scratch / "plain").string()) == 0);
  for (const char* odd :
       {"two words", "\xC3\xBC\xE2\x98\x83", "-dash", "--outdir", "new\nline", "quo'te\"s",
        "$(exit 3)`exit 4`", "%s%n{}", "a,b;c=d", "back\\slash", "tab\there", "#", "~"}) {
    INFO(odd);
    const std::string scene = scratch.file(std::string(odd) + ".yaml", k_small_scene);
    const std::string name = fs::path(scene).filename().string();
    const std::string line = "cd " + quoted(scratch.path().string()) + " && " + MAQUETTE_PROGRAM +
                             " sweep" + k_tiny_frame +
                             "--quiet --vary processors=1,2 --plot processors,frame.time_s "
                             "--outdir=" +
                             quoted(odd) + " -- " + quoted(name);
    CHECK(shell(line) == 0);
    CHECK(files_below(scratch / odd) == files_below(scratch / "plain"));
  }
}
