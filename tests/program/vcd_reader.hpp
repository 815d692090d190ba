#pragma once

#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/catch.hpp"

namespace maquette::tests {

/// A value change dump as IEEE 1364 chapter 18 has it, read and checked: declarations before
/// values, a value for every variable in $dumpvars, times that grow.
class VcdReader {
 public:
  using Values = std::vector<std::pair<std::int64_t, std::string>>;

  explicit VcdReader(const std::string& text) : stream_(text) {
    read_declarations();
    read_values();
    for (const auto& [identifier, name] : names_) {
      REQUIRE_FALSE(values_[identifier].empty());
      signals[name] = values_[identifier];
    }
  }

  std::int64_t first = -1;  ///< instants, in units of the time scale
  std::int64_t last = -1;
  std::string time_scale;
  std::map<std::string, Values> signals;  ///< by "scope.name": values from an instant on

  [[nodiscard]] std::string value(const std::string& signal, std::int64_t instant) const {
    std::string value;
    for (const auto& [from, what] : signals.at(signal)) {
      if (from > instant) {
        break;
      }
      value = what;
    }
    return value;
  }

  /// For how long a signal has a value.
  [[nodiscard]] std::int64_t time_with(const std::string& signal, const std::string& value) const {
    const Values& values = signals.at(signal);
    std::int64_t time = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::int64_t end = i + 1 < values.size() ? values[i + 1].first : last;
      time += values[i].second == value ? end - values[i].first : 0;
    }
    return time;
  }

 private:
  std::string word() {
    std::string word;
    REQUIRE(stream_ >> word);
    return word;
  }

  std::string until_end() {
    std::string text;
    for (std::string next = word(); next != "$end"; next = word()) {
      text += (text.empty() ? "" : " ") + next;
    }
    return text;
  }

  void read_declarations() {
    std::vector<std::string> scopes;
    for (std::string keyword = word(); keyword != "$enddefinitions"; keyword = word()) {
      if (keyword == "$scope") {
        REQUIRE(word() == "module");
        scopes.push_back(word());
        REQUIRE(word() == "$end");
      } else if (keyword == "$upscope") {
        REQUIRE_FALSE(scopes.empty());
        scopes.pop_back();
        REQUIRE(word() == "$end");
      } else if (keyword == "$var") {
        REQUIRE(word() == "wire");
        const int bits = std::stoi(word());
        const std::string identifier = word();
        const std::string name = scopes.back() + "." + word();
        const std::string range = until_end();
        REQUIRE(range == (bits == 1 ? "" : "[" + std::to_string(bits - 1) + ":0]"));
        REQUIRE(names_.emplace(identifier, name).second);
        bits_[identifier] = bits;
      } else if (keyword == "$timescale") {
        time_scale = until_end();
      } else {
        REQUIRE((keyword == "$comment" || keyword == "$version" || keyword == "$date"));
        until_end();
      }
    }
    REQUIRE(scopes.empty());
    REQUIRE(word() == "$end");
  }

  void read_values() {
    for (std::string next; stream_ >> next;) {
      if (next[0] == '#') {
        const std::int64_t instant = std::stoll(next.substr(1));
        REQUIRE(instant >= last);
        REQUIRE((instant > last || first == -1 || instant == first));
        first = first == -1 ? instant : first;
        last = instant;
      } else if (next == "$dumpvars") {
        REQUIRE(last == first);
      } else if (next == "$comment") {
        until_end();
      } else if (next != "$end") {
        read_value(next);
      }
    }
  }

  void read_value(const std::string& text) {
    const bool is_vector = text[0] == 'b';
    const std::string value = is_vector ? text.substr(1) : text.substr(0, 1);
    const std::string identifier = is_vector ? word() : text.substr(1);
    REQUIRE(names_.count(identifier) == 1);
    REQUIRE(value.find_first_not_of("01xz") == std::string::npos);
    REQUIRE(static_cast<int>(value.size()) <= bits_[identifier]);
    REQUIRE(is_vector == (bits_[identifier] > 1));
    Values& values = values_[identifier];
    REQUIRE((values.empty() || values.back().first < last));
    values.emplace_back(last, value);
  }

  std::istringstream stream_;
  std::map<std::string, std::string> names_;
  std::map<std::string, int> bits_;
  std::map<std::string, Values> values_;
};

}  // namespace maquette::tests
