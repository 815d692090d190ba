#include "sim/trace/trace_files.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/report/run_directory.hpp"
#include "sim/report/seconds.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

constexpr std::int64_t k_large_bytes = 100'000'000;
constexpr std::int64_t k_megabyte = 1'000'000;

/// Makes sure that a viewer's file takes the place of none that a user has saved.
void check_view(const std::filesystem::path& view, std::string_view mark) {
  std::ifstream file(view);
  std::string line;
  if (file && (!std::getline(file, line) || line != mark)) {
    throw DescriptionError(fmt::format(
        "{}: is no file that this program wrote; allowed: a trace of another name, or none there",
        view.string()));
  }
}

}  // namespace

TraceFiles::TraceFiles(TraceRequest request) : request_(std::move(request)) {
  for (const std::string& file : request_.files) {
    files_.emplace_back(place_of_result(file, request_.folder));
    if (const std::string view = view_of(file); !view.empty()) {
      const std::filesystem::path place = place_of_result(view, request_.folder);
      check_view(place, trace_format(file).view_mark);
      views_.emplace_back(place);
    }
  }
  if (!request_.lines.empty()) {
    lines_.emplace(place_of_result(request_.lines, request_.folder).string(), request_.window);
  }
}

std::string TraceFiles::remarks(const BusRecord& record, models::Instant frame_end) const {
  std::string text;
  for (const std::string& file : request_.files) {
    if (const std::int64_t bytes = trace_format(file).expected_bytes(record);
        bytes > k_large_bytes) {
      text += fmt::format("{}: will take about {} MB; --trace-window makes it smaller\n", file,
                          bytes / k_megabyte);
    }
  }
  if (request_.window.from >= frame_end) {
    std::vector<std::string> empty = request_.files;
    if (lines_) {
      empty.push_back(request_.lines);
    }
    for (const std::string& file : empty) {
      text += fmt::format("{}: is empty, the frame ended after {}\n", file,
                          readable_duration(frame_end));
    }
  }
  return text;
}

void TraceFiles::write(const BusRecord& record, models::Instant frame_end) {
  auto file = files_.begin();
  auto view = views_.begin();
  for (const std::string& name : request_.files) {
    const TraceFormat& format = trace_format(name);
    format.write(record, request_.boards, file->stream());
    ++file;
    if (format.write_view != nullptr) {
      format.write_view(record, request_.boards, std::filesystem::path(name).filename().string(),
                        view->stream());
      ++view;
    }
  }
  for (std::list<OutputFile>* files : {&files_, &views_}) {
    for (OutputFile& written : *files) {
      written.publish();
    }
  }
  if (lines_) {
    lines_->publish(frame_end);
  }
}

}  // namespace maquette::sim
