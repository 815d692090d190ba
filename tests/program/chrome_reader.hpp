#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/catch.hpp"

namespace maquette::tests {

/// A slice of a track, in picoseconds.
struct Slice {
  std::string name;
  std::int64_t from;
  std::int64_t to;
  nlohmann::json arguments;

  friend bool operator==(const Slice& a, const Slice& b) {
    return a.name == b.name && a.from == b.from && a.to == b.to && a.arguments == b.arguments;
  }
};

/// An arrow: where it starts and ends (process, thread, instant).
struct Arrow {
  std::pair<int, int> from_track;
  std::int64_t from = -1;
  std::pair<int, int> to_track;
  std::int64_t to = -1;
};

/// A Chrome trace as the Trace Event Format has it, read and checked: known phases, the keys that
/// each must have, slices that begin and end properly, arrows with two ends inside slices.
class ChromeTraceReader {
 public:
  explicit ChromeTraceReader(const std::string& text) {
    const nlohmann::json trace = nlohmann::json::parse(text);
    REQUIRE(trace.is_object());
    REQUIRE(trace["displayTimeUnit"] == "ns");
    for (const auto& event : trace["traceEvents"]) {
      read(event);
    }
    for (const auto& [track, open] : open_) {
      REQUIRE(open.empty());
    }
    for (const auto& [id, arrow] : arrows_by_id_) {
      REQUIRE(arrow.from >= 0);
      REQUIRE(arrow.to >= arrow.from);
      REQUIRE(slice_at(arrow.from_track, arrow.from) != nullptr);
      REQUIRE(slice_at(arrow.to_track, arrow.to) != nullptr);
      arrows.push_back(arrow);
    }
  }

  /// Slices of a track by the names of its process and its thread.
  [[nodiscard]] std::vector<Slice> slices(const std::string& process,
                                          const std::string& thread) const {
    for (const auto& [track, list] : slices_) {
      if (process_names_.at(track.first) == process && thread_names_.at(track) == thread) {
        return list;
      }
    }
    return {};
  }

  [[nodiscard]] const Slice* slice_at(const std::pair<int, int>& track,
                                      std::int64_t instant) const {
    for (const Slice& slice : slices_.at(track)) {
      if (slice.from <= instant && instant < slice.to) {
        return &slice;
      }
    }
    return nullptr;
  }

  [[nodiscard]] const std::string& thread_name(const std::pair<int, int>& track) const {
    return thread_names_.at(track);
  }
  [[nodiscard]] std::size_t threads() const { return thread_names_.size(); }

  std::vector<Arrow> arrows;
  /// Values of a counter from an instant on, by process name and counter name.
  std::map<std::pair<std::string, std::string>, std::vector<std::pair<std::int64_t, double>>>
      counters;

 private:
  static std::int64_t instant_of(const nlohmann::json& event) {
    REQUIRE(event["ts"].is_number());
    return std::llround(event["ts"].get<double>() * 1e6);
  }

  void read(const nlohmann::json& event) {
    const std::string phase = event["ph"];
    const int process = event["pid"];
    if (phase == "M") {
      read_name(event, process);
    } else if (phase == "C") {
      REQUIRE(event["args"].size() == 1);
      auto& values = counters[{process_names_.at(process), event["name"]}];
      values.emplace_back(instant_of(event), event["args"].begin()->get<double>());
      REQUIRE((values.size() < 2 || values[values.size() - 2].first < values.back().first));
    } else {
      read_track_event(event, phase, {process, event["tid"].get<int>()});
    }
  }

  void read_name(const nlohmann::json& event, int process) {
    const std::string what = event["name"];
    if (what == "process_name") {
      process_names_[process] = event["args"]["name"];
    } else if (what == "thread_name") {
      thread_names_[{process, event["tid"].get<int>()}] = event["args"]["name"];
    } else {
      REQUIRE((what == "process_sort_index" || what == "thread_sort_index"));
      REQUIRE(event["args"]["sort_index"].is_number_integer());
    }
  }

  void read_track_event(const nlohmann::json& event, const std::string& phase,
                        const std::pair<int, int>& track) {
    REQUIRE(thread_names_.count(track) == 1);
    const std::int64_t instant = instant_of(event);
    auto& open = open_[track];
    auto& closed = slices_[track];
    if (phase == "B") {
      REQUIRE(open.empty());  // states do not nest
      REQUIRE((closed.empty() || closed.back().to <= instant));
      open.push_back({event["name"], instant, -1, event.value("args", nlohmann::json())});
    } else if (phase == "E") {
      REQUIRE(open.size() == 1);
      REQUIRE(open.back().from < instant);
      open.back().to = instant;
      closed.push_back(open.back());
      open.clear();
    } else {
      Arrow& arrow = arrows_by_id_[event["id"].get<std::int64_t>()];
      const bool begins = phase == "s";
      REQUIRE((begins || (phase == "f" && event["bp"] == "e")));
      REQUIRE((begins ? arrow.from : arrow.to) == -1);
      (begins ? arrow.from : arrow.to) = instant;
      (begins ? arrow.from_track : arrow.to_track) = track;
    }
  }

  std::map<int, std::string> process_names_;
  std::map<std::pair<int, int>, std::string> thread_names_;
  std::map<std::pair<int, int>, std::vector<Slice>> open_;
  std::map<std::pair<int, int>, std::vector<Slice>> slices_;
  std::map<std::int64_t, Arrow> arrows_by_id_;
};

}  // namespace maquette::tests
