#include "sim/report/statistics_json.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <type_traits>

#include "sim/report/seconds.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

std::string joined(const std::string& path, const char* name) {
  return path.empty() ? name : path + "." + name;
}

class Writer {
 public:
  std::string text;

  void write(models::Duration value) { text += format_seconds(value); }
  void write(bool value) { text += value ? "true" : "false"; }
  void write(const std::string& value) { text += nlohmann::json(value).dump(); }

  template <typename Number>
  std::enable_if_t<std::is_arithmetic_v<Number>> write(Number value) {
    if constexpr (std::is_floating_point_v<Number>) {
      if (!std::isfinite(value)) {
        throw std::invalid_argument("a statistic is not finite");
      }
    }
    text += fmt::format("{}", value);
  }

  template <typename Number>
  void write(const PerOperation<Number>& numbers) {
    open('{');
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      key(firmware::k_operation_names[i]);
      write(numbers[i]);
    }
    close('}');
  }

  void write(const FunctionTimes& times) {
    open('{');
    for (std::size_t i = 0; i < times.values.size(); ++i) {
      key(function_name(static_cast<int>(i)).c_str());
      write(times.values[i]);
    }
    close('}');
  }

  template <typename Element>
  void write(const std::vector<Element>& elements) {
    open('[');
    for (const auto& element : elements) {
      separate();
      write(element);
    }
    close(']');
  }

  template <typename Group>
  std::enable_if_t<k_has_fields<Group>> write(const Group& group) {
    open('{');
    for_each_field<Group>(
        [this, &group](const auto& field) { this->write(field.name, group.*field.member); });
    close('}');
  }

 private:
  template <typename Value>
  void write(const char* name, const Value& value) {
    key(name);
    write(value);
  }

  template <typename Group>
  void write(const char* name, const std::optional<Group>& group) {
    if (group) {
      write(name, *group);
    }
  }

  void open(char bracket) {
    text += bracket;
    ++depth_;
    empty_ = true;
  }

  void close(char bracket) {
    --depth_;
    if (!empty_) {
      start_line();
    }
    empty_ = false;
    text += bracket;
  }

  void separate() {
    if (!empty_) {
      text += ',';
    }
    empty_ = false;
    start_line();
  }

  void start_line() { text += '\n' + std::string(2 * depth_, ' '); }

  void key(const char* name) {
    separate();
    text += fmt::format("\"{}\": ", name);
  }

  std::size_t depth_ = 0;
  bool empty_ = true;
};

// Takes each value out of the flat values, so what is left at the end is unknown.
class Reader {
 public:
  Reader(const FlatValues& values, std::string name)
      : name_(std::move(name)), values_(values.begin(), values.end()) {}

  void read(const std::string& path, std::string& value) { value = take(path); }

  void read(const std::string& path, bool& value) {
    const std::string text = take(path);
    value = text == "true";
    if (!value && text != "false") {
      fail(path, text, "true or false");
    }
  }

  void read(const std::string& path, models::Duration& value) {
    const std::string text = take(path);
    const auto duration = parse_seconds(text);
    if (!duration) {
      fail(path, text, "seconds with at most twelve decimals");
    }
    value = *duration;
  }

  template <typename Number>
  std::enable_if_t<std::is_arithmetic_v<Number>> read(const std::string& path, Number& value) {
    const std::string text = take(path);
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    bool is_right = result.ec == std::errc() && result.ptr == text.data() + text.size();
    if constexpr (std::is_floating_point_v<Number>) {
      is_right = is_right && std::isfinite(value);
    }
    if (!is_right) {
      fail(path, text, std::is_integral_v<Number> ? "a whole number" : "a number");
    }
  }

  template <typename Number>
  void read(const std::string& path, PerOperation<Number>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      read(joined(path, firmware::k_operation_names[i]), numbers[i]);
    }
  }

  void read(const std::string& path, FunctionTimes& times) {
    for (std::size_t i = 0; i < times.values.size(); ++i) {
      read(joined(path, function_name(static_cast<int>(i)).c_str()), times.values[i]);
    }
  }

  template <typename Element>
  void read(const std::string& path, std::vector<Element>& elements) {
    elements.clear();
    for (auto element = path + "[0]"; holds(element);
         element = fmt::format("{}[{}]", path, elements.size())) {
      read(element, elements.emplace_back());
    }
  }

  template <typename Group>
  void read(const std::string& path, std::optional<Group>& group) {
    group.reset();
    if (holds(path + ".")) {
      read(path, group.emplace());
    }
  }

  template <typename Group>
  std::enable_if_t<k_has_fields<Group>> read(const std::string& path, Group& group) {
    for_each_field<Group>([this, &path, &group](const auto& field) {
      this->read(joined(path, field.name), group.*field.member);
    });
  }

  void finish() const {
    if (!values_.empty()) {
      throw DescriptionError(name_ + ": unknown key " + values_.begin()->first);
    }
  }

 private:
  // Whether a path begins so, with a beginning that ends in ']' or '.'.
  [[nodiscard]] bool holds(const std::string& beginning) const {
    const auto first = values_.lower_bound(beginning);
    return first != values_.end() && first->first.compare(0, beginning.size(), beginning) == 0;
  }

  std::string take(const std::string& path) {
    const auto value = values_.find(path);
    if (value == values_.end()) {
      throw DescriptionError(name_ + ": the key " + path + " is missing");
    }
    return values_.extract(value).mapped();
  }

  [[noreturn]] void fail(const std::string& path, const std::string& text,
                         const char* allowed) const {
    throw DescriptionError(
        fmt::format("{}: {} is \"{}\" and must be {}", name_, path, text, allowed));
  }

  std::string name_;
  std::map<std::string, std::string> values_;
};

}  // namespace

std::string statistics_json(const Statistics& statistics) {
  Writer writer;
  writer.write(statistics);
  return writer.text + '\n';
}

Statistics parse_statistics(const std::string& json, const std::string& name) {
  return read_statistics(flatten_json(json, name), name);
}

Statistics read_statistics(const FlatValues& values, const std::string& name) {
  Reader reader(values, name);
  Statistics statistics;
  reader.read("", statistics);
  reader.finish();
  return statistics;
}

}  // namespace maquette::sim
