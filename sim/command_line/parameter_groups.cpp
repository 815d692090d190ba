#include "sim/command_line/parameter_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "sim/command_line/common_options.hpp"
#include "sim/command_line/description_tables.hpp"
#include "sim/machine/machine_description.hpp"
#include "sim/scene/scene_description.hpp"
#include "sim/yaml/yaml_reader.hpp"

namespace maquette::sim {
namespace {

constexpr std::size_t k_line = 100;
constexpr std::size_t k_screen = 20;
constexpr std::size_t k_widest_path = 50;
constexpr std::size_t k_widest_value = 30;

struct Given {
  std::string path;
  std::string value;
  std::string meaning;
};

/// The beginning of a text that is too long, with dots.
std::string shortened(const std::string& text, std::size_t length) {
  constexpr std::string_view k_dots = "...";
  if (text.size() <= length) {
    return text;
  }
  // A letter of several bytes is not cut apart.
  std::size_t end = length > k_dots.size() ? length - k_dots.size() : 0;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    --end;
  }
  return text.substr(0, end) + std::string(k_dots);
}

/// What is told of a group; of many the first ones.
std::string group_text(const std::string& title, const std::vector<Given>& rows) {
  const std::size_t shown = std::min(k_screen, rows.size());
  std::size_t path_width = 0;
  std::size_t value_width = 0;
  for (std::size_t i = 0; i < shown; ++i) {
    path_width = std::max(path_width, std::min(rows[i].path.size(), k_widest_path));
    value_width = std::max(value_width, std::min(rows[i].value.size(), k_widest_value));
  }
  std::string text = "\n" + title + "\n";
  for (std::size_t i = 0; i < shown; ++i) {
    const Given& row = rows[i];
    // A path is told whole, since it is what is asked with.
    const std::size_t room = k_line - std::min(k_line, 2 + std::max(path_width, row.path.size()));
    const std::string value = shortened(row.value, row.meaning.empty() ? room - 2 : k_widest_value);
    std::string line = fmt::format("  {:<{}}  {:<{}}  ", row.path, path_width, value, value_width);
    line += line.size() < k_line ? shortened(row.meaning, k_line - line.size()) : "";
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return shown < rows.size() ? text + fmt::format("  and {} more with --all\n", rows.size() - shown)
                             : text;
}

std::string group_of(const std::string& path) {
  const std::size_t dot = path.find('.');
  return dot == std::string::npos ? "scene" : path.substr(0, dot);
}

/// Those that have a value of their own.
std::vector<Given> given(const std::vector<ParameterRow>& rows) {
  std::vector<Given> given;
  for (const ParameterRow& row : rows) {
    if (!row.value.empty() && row.value != row.default_value) {
      given.push_back({row.path, row.value, row.sentence});
    }
  }
  return given;
}

/// What a machine has other than the shipped ccett-1984; its name is told besides.
std::vector<Given> changed_from_prototype(const Machine& machine) {
  DescriptionSources sources;
  sources.data_directory = data_directory();
  std::vector<InputFile> read;
  std::vector<ParameterRow> rows = list_parameters(machine);
  const std::vector<ParameterRow> prototype = list_parameters(load_machine(sources, read));
  for (ParameterRow& row : rows) {
    const auto same =
        std::find_if(prototype.begin(), prototype.end(),
                     [&row](const ParameterRow& own) { return own.path == row.path; });
    row.default_value = same == prototype.end() ? "" : same->value;
  }
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [](const ParameterRow& row) { return row.path == "name"; }),
             rows.end());
  return given(rows);
}

}  // namespace

std::string wrapped(const std::string& text) {
  std::string lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    while (line.size() > k_line) {
      const std::size_t space = line.rfind(' ', k_line);
      if (space == std::string::npos || line.find_first_not_of(' ') > space) {
        break;
      }
      lines += line.substr(0, space) + "\n";
      line = "    " + line.substr(space + 1);
    }
    lines += line + "\n";
    begin = end + 1;
  }
  return lines;
}

std::string parameter_groups(const Description& description) {
  std::vector<Given> rows = given(list_parameters(description.scene));
  for (const auto& row : object_table(parse_yaml(description.input_files.front())).rows) {
    rows.push_back({row[0], row[1], ""});
  }
  std::vector<std::string> names;
  for (const Given& row : rows) {
    if (const std::string name = group_of(row.path);
        std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
    }
  }
  std::string text = "\nGiven, as --set and --vary take it; all parameters with --all\n";
  for (const std::string& name : names) {
    std::vector<Given> group;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(group),
                 [&name](const Given& row) { return group_of(row.path) == name; });
    text += group_text(name, group);
  }
  const std::vector<Given> changed = changed_from_prototype(description.machine);
  return text +
         group_text(fmt::format("machine {}, other than the prototype in {}",
                                description.machine.name, changed.empty() ? "nothing" : "these"),
                    changed);
}

}  // namespace maquette::sim
