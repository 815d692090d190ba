#include "sim/report/result_directory.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/unfinished.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/scratch_directory.hpp"

using namespace maquette::sim;
using maquette::tests::ScratchDirectory;

namespace fs = std::filesystem;

namespace {

/// Names and contents of all files below a directory, but for the manifest's, and of empty folders.
std::map<std::string, std::string> contents(const fs::path& directory) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    const std::string name = entry.path().lexically_relative(directory).generic_string();
    if (entry.is_regular_file()) {
      files[name] = entry.path().filename() == "manifest.json" ? "" : read_file(entry.path());
    } else if (fs::is_empty(entry.path())) {
      files[name + "/"] = "";
    }
  }
  return files;
}

using Files = std::map<std::string, std::string>;

void write_results(const fs::path& directory, const std::vector<NamedContent>& files) {
  ResultDirectory results(directory);
  write_files(results.workplace(), files);
  results.publish({});
}

}  // namespace

TEST_CASE("results appear together, and nothing before") {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "deep" / "run";
  {
    ResultDirectory results(directory);
    write_files(results.workplace(), {{"one", "1"}, {"two", "2"}});
    create_run_directory(results.workplace() / "plots");
    write_files(results.workplace() / "plots", {{"three", "3"}});
    CHECK_FALSE(fs::exists(directory));
    results.publish({});
    CHECK(fs::exists(directory / "manifest.json"));
  }
  CHECK(contents(scratch.path()) == Files{{"deep/run/one", "1"},
                                          {"deep/run/two", "2"},
                                          {"deep/run/plots/three", "3"},
                                          {"deep/run/manifest.json", ""}});
  const auto manifest = nlohmann::json::parse(read_file(directory / "manifest.json"));
  CHECK(manifest["files"] == std::vector<std::string>{"one", "plots/three", "two"});
}

TEST_CASE("without publication nothing is left, not even directories above") {
  const ScratchDirectory scratch;
  {
    ResultDirectory results(scratch.path() / "deep" / "er" / "run");
    write_files(results.workplace(), {{"one", "1"}});
  }
  CHECK(contents(scratch.path()).empty());
  fs::create_directories(scratch.path() / "deep");
  { const ResultDirectory results(scratch.path() / "deep" / "er" / "run"); }
  CHECK(contents(scratch.path()) == Files{{"deep/", ""}});
}

TEST_CASE("results take the place of the earlier ones, and of nothing else") {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "run";
  write_results(directory, {{"one", "old"}, {"gone", "old"}});
  write_files(directory, {{"note", "mine"}});
  {
    ResultDirectory results(directory);
    const fs::path kept = results.kept("record");
    create_run_directory(kept);
    write_files(kept, {{"frame", "kept"}});
    write_files(results.workplace(), {{"one", "new"}});
    results.publish({});
  }
  write_results(directory, {{"one", "newest"}});
  CHECK(contents(scratch.path()) == Files{{"run/one", "newest"},
                                          {"run/note", "mine"},
                                          {"run/record/frame", "kept"},
                                          {"run/manifest.json", ""}});
}

TEST_CASE("what is kept stays also where it came with the directory itself") {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "run";
  {
    ResultDirectory results(directory);
    create_run_directory(results.kept("record"));
    write_files(results.kept("record"), {{"frame", "kept"}});
    results.publish({});
  }
  write_results(directory, {{"one", "1"}});
  CHECK(contents(directory) ==
        Files{{"one", "1"}, {"record/frame", "kept"}, {"manifest.json", ""}});
}

TEST_CASE("a manifest that names files elsewhere removes none of them") {
  const ScratchDirectory scratch;
  write_files(scratch.path(), {{"mine", "1"}});
  create_run_directory(scratch.path() / "run");
  const std::string absolute = (scratch.path() / "mine").string();
  for (const std::string& manifest :
       {std::string(R"({"files": ["../mine", ")") + absolute + R"(", "a/../../mine", ""]})",
        std::string(R"({"files": 7})"), std::string("[]"), std::string("{")}) {
    write_files(scratch.path() / "run", {{"manifest.json", manifest}});
    write_results(scratch.path() / "run", {{"one", "1"}});
    CHECK(read_file(scratch.path() / "mine") == "1");
  }
}

TEST_CASE("results that cannot be published leave the directory as it was") {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "run";
  write_results(directory, {{"one", "old"}, {"two", "old"}});
  fs::remove(directory / "two");
  SECTION("because a directory has the name of one") { fs::create_directory(directory / "two"); }
  SECTION("because a link to nothing has it") { fs::create_symlink("nowhere", directory / "two"); }
  CHECK_THROWS_AS(write_results(directory, {{"one", "new"}, {"two", "new"}}), DescriptionError);
  CHECK(read_file(directory / "one") == "old");
  CHECK(fs::exists(directory / "manifest.json"));
}

TEST_CASE("a directory that cannot be made or used is refused at once") {
  const ScratchDirectory scratch;
  write_files(scratch.path(), {{"file", "x"}});
  fs::create_symlink("nowhere", scratch.path() / "link");
  for (const fs::path& wrong : {scratch.path() / "file", scratch.path() / "file" / "below",
                                scratch.path() / "link", fs::path("/proc"), fs::path("/proc/x")}) {
    INFO(wrong);
    CHECK_THROWS_AS(ResultDirectory(wrong), DescriptionError);
  }
  CHECK(fs::is_symlink(scratch.path() / "link"));
  fs::remove(scratch.path() / "link");
  CHECK(contents(scratch.path()) == Files{{"file", "x"}});
}

TEST_CASE("what killed commands left is cleared by the next into the same place") {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "run";
  const auto killed = [&directory] {
    const pid_t process = ::fork();
    if (process == 0) {
      const ResultDirectory results(directory);
      write_files(results.workplace(), {{"half", "1"}});
      ::_exit(0);
    }
    ::waitpid(process, nullptr, 0);
  };
  killed();
  CHECK(contents(scratch.path()).size() == 1);
  write_results(directory, {{"one", "1"}});
  killed();
  // Of one that still runs, and of another name, nothing is cleared.
  const std::string running = "run/" + unfinished_name("mine");
  write_files(scratch.path(), {{".other.unfinished-host-1", "2"}});
  create_run_directory(scratch.path() / running);
  write_results(directory, {{"one", "1"}});
  CHECK(contents(scratch.path()) == Files{{"run/one", "1"},
                                          {"run/manifest.json", ""},
                                          {running + "/", ""},
                                          {".other.unfinished-host-1", "2"}});
}

TEST_CASE("of two commands into one directory the last one is there, whole") {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "run";
  for (int round = 0; round < 20; ++round) {
    std::vector<pid_t> processes;
    for (const char* content : {"a", "b", "c"}) {
      processes.push_back(::fork());
      if (processes.back() == 0) {
        int failed = 0;
        try {
          write_results(directory, {{"one", content}, {std::string("of_") + content, content}});
        } catch (const std::exception&) {
          failed = 1;
        }
        ::_exit(failed);
      }
    }
    for (const pid_t process : processes) {
      int status = 0;
      ::waitpid(process, &status, 0);
      CHECK(status == 0);
    }
    CHECK(fs::exists(directory / "manifest.json"));
    for (const auto& [name, content] : contents(scratch.path())) {
      CHECK(name.find("unfinished") == std::string::npos);
    }
    fs::remove_all(directory);
  }
}
