#include "sim/trace/trace_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "sim/fields/time_text.hpp"
#include "sim/trace/trace_formats.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

constexpr const char* k_range = "..";

[[noreturn]] void fail(const std::string& option, const std::string& text,
                       const std::string& what) {
  throw DescriptionError({fmt::format("{} {}", option, text), 1, 1}, what);
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

models::Instant instant_of(const std::string& time, const std::string& option) {
  models::Instant instant{};
  try {
    instant = models::Instant(parse_time(time));
  } catch (const std::invalid_argument& error) {
    fail("--trace-window", option, error.what());
  }
  if (instant.count() < 0) {
    fail("--trace-window", option, "a time before the frame; allowed: 0 s and later");
  }
  return instant;
}

TraceWindow window_of(const std::string& text) {
  TraceWindow window;
  const std::size_t dots = text.find(k_range);
  if (dots == std::string::npos) {
    fail("--trace-window", text, "is no window; allowed: T0..T1, e.g. \"1 s..1.01 s\"");
  }
  const std::string from = trimmed(text.substr(0, dots));
  const std::string to = trimmed(text.substr(dots + 2));
  if (!from.empty()) {
    window.from = instant_of(from, text);
  }
  if (!to.empty()) {
    window.to = instant_of(to, text);
  }
  if (window.from >= window.to) {
    fail("--trace-window", text, "is an empty window; allowed: T0 before T1");
  }
  return window;
}

std::size_t board_of(const std::string& text, const std::string& boards, std::size_t count) {
  const std::string number = trimmed(text);
  std::size_t board = 0;
  const auto result = std::from_chars(number.data(), number.data() + number.size(), board);
  if (result.ec != std::errc() || result.ptr != number.data() + number.size() || board >= count) {
    fail("--trace-boards", boards,
         fmt::format("`{}` is no board of this machine; allowed: 0..{}", number, count - 1));
  }
  return board;
}

std::vector<std::size_t> boards_of(const std::string& text, std::size_t count) {
  std::set<std::size_t> boards;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string part = text.substr(start, end - start);
    const std::size_t dots = part.find(k_range);
    const bool is_range = dots != std::string::npos;
    const std::size_t first = board_of(part.substr(0, dots), text, count);
    const std::size_t last = is_range ? board_of(part.substr(dots + 2), text, count) : first;
    if (first > last) {
      fail("--trace-boards", text, "is an empty range; allowed: the lower number first");
    }
    for (std::size_t board = first; board <= last; ++board) {
      boards.insert(board);
    }
    start = end + 1;
  }
  return {boards.begin(), boards.end()};
}

void check_files(const TraceOptions& options) {
  for (const std::string& file : options.files) {
    static_cast<void>(trace_format(file));
    if (std::count(options.files.begin(), options.files.end(), file) > 1 || file == options.lines) {
      fail("--trace", file, "is given twice; allowed: each file once");
    }
  }
  if (!options.lines.empty() &&
      std::filesystem::path(options.lines).extension() != k_vcd_trace.extension) {
    fail("--trace-lines", options.lines,
         fmt::format("is no value change dump; allowed: {}", k_vcd_trace.extension));
  }
}

void check_companions(const TraceOptions& options) {
  if (options.files.empty() && !options.boards.empty()) {
    fail("--trace-boards", options.boards, "traces nothing; allowed: beside --trace FILE");
  }
  if (options.files.empty() && options.lines.empty() && options.video) {
    throw DescriptionError(
        "--trace-video traces nothing; allowed: beside --trace FILE or --trace-lines FILE");
  }
  if (options.files.empty() && options.lines.empty() && !options.window.empty()) {
    fail("--trace-window", options.window,
         "traces nothing; allowed: beside --trace FILE or --trace-lines FILE");
  }
}

}  // namespace

const TraceFormat& trace_format(const std::string& file) {
  const TraceFormat* format = find_trace_format(file);
  if (format == nullptr) {
    fail("--trace", file, fmt::format("has no known extension; allowed: {}", trace_extensions()));
  }
  return *format;
}

std::string view_of(const std::string& file) {
  const std::string_view extension = trace_format(file).view_extension;
  return extension.empty() ? "" : std::filesystem::path(file).replace_extension(extension).string();
}

TraceRequest trace_request(const TraceOptions& options, std::size_t master_count) {
  check_companions(options);
  check_files(options);
  TraceRequest request;
  request.files = options.files;
  request.lines = options.lines;
  request.video = options.video;
  if (!options.window.empty()) {
    request.window = window_of(options.window);
  }
  const std::string all_boards = fmt::format("0..{}", master_count - 1);
  request.boards = boards_of(options.boards.empty() ? all_boards : options.boards, master_count);
  return request;
}

}  // namespace maquette::sim
