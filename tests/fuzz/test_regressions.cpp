#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/catch.hpp"
#include "tests/fuzz/harness.hpp"

namespace {

namespace fs = std::filesystem;
using maquette::fuzz::Harness;
using maquette::fuzz::k_harnesses;

const fs::path k_regressions = fs::path{MAQUETTE_PROJECT_DIRECTORY} / "tests/fuzz/regressions";

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::directory_iterator{folder}) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("what every harness begins with holds its laws") {
  for (const Harness& harness : k_harnesses) {
    const auto seeds = harness.seeds();
    CHECK(seeds.size() > 1);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      INFO(harness.name << ", seed " << i);
      CHECK_NOTHROW(harness.try_input(seeds[i]));
    }
  }
}

TEST_CASE("what fuzzing has found before holds the laws now") {
  for (const Harness& harness : k_harnesses) {
    for (const fs::path& file : files_of(k_regressions / harness.name)) {
      INFO(file.string());
      std::ifstream stream{file, std::ios::binary};
      const std::string input{std::istreambuf_iterator<char>{stream}, {}};
      CHECK_NOTHROW(harness.try_input(input));
    }
  }
}

TEST_CASE("every folder of inputs that were found belongs to a harness") {
  for (const fs::path& folder : files_of(k_regressions)) {
    CHECK_NOTHROW(maquette::fuzz::harness_named(folder.filename().string()));
  }
}
