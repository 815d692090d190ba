#include "sim/trace/trace_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <stdexcept>

#include "sim/fields/quantity.hpp"
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
    instant = models::Instant(parse_quantity(time, WholeDimension::time));
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

}  // namespace

const TraceFormat& trace_format(const std::string& file) {
  const TraceFormat* format = find_trace_format(file);
  if (format == nullptr) {
    fail("--trace", file, fmt::format("has no known extension; allowed: {}", trace_extensions()));
  }
  return *format;
}

TraceRequest trace_request(const std::vector<std::string>& files, const std::string& window,
                           const std::string& boards, std::size_t board_count) {
  TraceRequest request;
  request.files = files;
  if (files.empty() && (!window.empty() || !boards.empty())) {
    fail(window.empty() ? "--trace-boards" : "--trace-window", window.empty() ? boards : window,
         "traces nothing; allowed: beside --trace FILE");
  }
  for (const std::string& file : files) {
    static_cast<void>(trace_format(file));
    if (std::count(files.begin(), files.end(), file) > 1) {
      fail("--trace", file, "is given twice; allowed: each file once");
    }
  }
  if (!window.empty()) {
    request.window = window_of(window);
  }
  request.boards =
      boards_of(boards.empty() ? fmt::format("0..{}", board_count - 1) : boards, board_count);
  return request;
}

}  // namespace maquette::sim
