#include "sim/trace/line_trace.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"
#include "tests/program/vcd_reader.hpp"

namespace {

using namespace maquette::sim;
using namespace maquette::tests;
using maquette::models::Instant;

constexpr int k_lines = 4;
constexpr int k_bits[k_lines] = {1, 1, 16, 32};
constexpr std::int64_t k_frame_end = 300;

struct Change {
  std::int64_t at;
  std::size_t line;
  std::uint64_t value;
};

std::uint64_t random_value(std::mt19937& random, std::size_t line) {
  return random() % (std::uint64_t{1} << std::min(k_bits[line], 3));
}

// Some before the frame, several in an instant, many that change nothing.
std::vector<Change> random_changes(std::mt19937& random) {
  std::vector<Change> changes;
  std::int64_t at = -1;
  while (at < k_frame_end) {
    const std::size_t line = random() % k_lines;
    changes.push_back({at, line, random_value(random, line)});
    const bool begins = at == -1 && random() % 10 == 0;
    at += begins ? 1 + random() % 3 : (at >= 0 && random() % 3 == 0 ? random() % 20 : 0);
  }
  while (!changes.empty() && changes.back().at >= k_frame_end) {
    changes.pop_back();
  }
  return changes;
}

std::string binary(std::uint64_t value) {
  std::string text;
  do {
    text.insert(text.begin(), static_cast<char>('0' + (value & 1U)));
    value >>= 1U;
  } while (value > 0);
  return text;
}

// What a line shows at the end of each instant of the window in which that is something new.
VcdReader::Values expected(const std::vector<Change>& changes, std::size_t line, std::int64_t from,
                           std::int64_t to) {
  std::map<std::int64_t, std::uint64_t> shown{{from, 0}};
  for (const Change& change : changes) {
    if (change.line == line && change.at < std::max(to, from + 1)) {
      shown[std::max(change.at, from)] = change.value;
    }
  }
  VcdReader::Values values;
  for (const auto& [at, value] : shown) {
    if (values.empty() || values.back().second != binary(value)) {
      values.emplace_back(at, binary(value));
    }
  }
  return values;
}

VcdReader traced(const std::vector<Change>& changes, const TraceWindow& window) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "lines.vcd").string();
  LineTrace trace(file, window);
  for (std::size_t line = 0; line < k_lines; ++line) {
    const std::string scope = line < 2 ? "first" : "second";
    REQUIRE(trace.add({scope, "line" + std::to_string(line), k_bits[line]}, 0) == line);
  }
  for (const Change& change : changes) {
    trace.change(change.line, Instant(change.at), change.value);
  }
  CHECK_FALSE(std::filesystem::exists(file));
  trace.publish(Instant(k_frame_end));
  return VcdReader(content_of(file));
}

void check_window(const std::vector<Change>& changes, std::int64_t from, std::int64_t to) {
  INFO(from << ".." << to);
  const VcdReader reader = traced(changes, {Instant(from), Instant(to)});
  const std::int64_t end = std::min(to, k_frame_end);
  CHECK(reader.first == std::min(from, end));
  CHECK(reader.last == end);
  for (std::size_t line = 0; line < k_lines; ++line) {
    const std::string name = (line < 2 ? "first.line" : "second.line") + std::to_string(line);
    CHECK(reader.signals.at(name) == expected(changes, line, std::min(from, end), end));
  }
}

TEST_CASE("a trace of lines shows what they showed in its window, instant by instant") {
  std::mt19937 random(5);
  for (int one = 0; one < 300; ++one) {
    const std::vector<Change> changes = random_changes(random);
    const auto from = static_cast<std::int64_t>(random() % k_frame_end);
    check_window(changes, 0, maquette::models::k_never.count());
    check_window(changes, from, from + 1 + static_cast<std::int64_t>(random() % 100));
  }
}

TEST_CASE("a window without a change, and one after the frame, show how the lines are") {
  check_window({{-1, 2, 5}, {7, 0, 1}}, 20, 40);
  check_window({{-1, 2, 5}, {7, 0, 1}}, 400, 500);
  check_window({}, 0, 10);
}

}  // namespace
