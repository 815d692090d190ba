#include "sim/page/result_page.hpp"

#include <system_error>

#include "sim/page/comparison_page.hpp"
#include "sim/page/run_page.hpp"
#include "sim/page/sequence_page.hpp"
#include "sim/page/study_elements.hpp"
#include "sim/page/study_page.hpp"
#include "sim/page/sweep_page.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

/// What a directory is of that holds a file of this name, and what makes its page.
struct PageKind {
  const char* file;
  std::string (*page)(const fs::path& directory);
};

constexpr PageKind k_page_kinds[] = {
    {"table.csv", sweep_page}, {"accuracy.csv", accuracy_page}, {"stability.json", stability_page}};

}  // namespace

std::string result_page(const std::vector<fs::path>& directories,
                        const std::string& data_directory) {
  if (directories.size() > 1) {
    std::vector<RunResults> runs;
    runs.reserve(directories.size());
    for (const fs::path& directory : directories) {
      runs.push_back(run_results(read_run_files(directory), data_directory));
    }
    return comparison_page(runs);
  }
  const fs::path& directory = directories.front();
  for (const PageKind& kind : k_page_kinds) {
    std::error_code error;
    if (fs::is_regular_file(directory / kind.file, error)) {
      return kind.page(directory);
    }
  }
  if (std::error_code error; fs::is_regular_file(directory / "sequence.json", error)) {
    return sequence_page(directory, study_name(directory), data_directory);
  }
  return run_page(read_run_files(directory), data_directory);
}

}  // namespace maquette::sim
