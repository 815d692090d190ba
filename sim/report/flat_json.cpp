#include "sim/report/flat_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

using Json = nlohmann::json;

// Receives the parser's events; numbers come with the digits of the text.
class Flattener : public nlohmann::json_sax<Json> {
 public:
  Flattener(const std::string& text, const std::string& name) : text_(text), name_(name) {}

  FlatValues values;

  bool null() override { return add("null"); }
  bool boolean(bool value) override { return add(value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override { return add(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add(std::to_string(value)); }
  bool number_float(number_float_t /*value*/, const string_t& digits) override {
    return add(digits);
  }
  bool string(string_t& value) override { return add(value); }
  bool binary(binary_t& /*value*/) override { return false; }

  bool start_object(std::size_t /*size*/) override { return open(-1); }
  bool start_array(std::size_t /*size*/) override { return open(0); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    groups_.back().key = name;
    return true;
  }

  bool parse_error(std::size_t offset, const std::string& /*token*/,
                   const Json::exception& error) override {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text_.size()));
    const auto line_start = std::find(std::make_reverse_iterator(end), text_.rend(), '\n').base();
    const auto line = 1 + std::count(text_.begin(), end, '\n');
    // The library's message begins with the place in words: leave that out.
    const std::string message = error.what();
    throw DescriptionError(
        {name_, static_cast<int>(line), std::max(1, static_cast<int>(end - line_start))},
        "is not JSON: " + message.substr(message.find(": ") + 2));
  }

 private:
  struct Group {
    int index;  // of the next value in an array; negative in an object
    std::string key;
  };

  [[nodiscard]] std::string path() const {
    std::string path;
    for (const auto& group : groups_) {
      if (group.index >= 0) {
        path += "[" + std::to_string(group.index) + "]";
      } else {
        path += (path.empty() ? "" : ".") + group.key;
      }
    }
    return path;
  }

  bool add(const std::string& value) {
    values.emplace_back(path(), value);
    return next();
  }

  bool next() {
    if (!groups_.empty() && groups_.back().index >= 0) {
      ++groups_.back().index;
    }
    return true;
  }

  bool open(int index) {
    groups_.push_back({index, {}});
    return true;
  }

  bool close() {
    groups_.pop_back();
    return next();
  }

  const std::string& text_;
  const std::string& name_;
  std::vector<Group> groups_;
};

}  // namespace

FlatValues flatten_json(const std::string& text, const std::string& name) {
  Flattener flattener(text, name);
  Json::sax_parse(text, &flattener);
  return std::move(flattener.values);
}

}  // namespace maquette::sim
