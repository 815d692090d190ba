#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace maquette::tests {

/// The rows of numbers of the data block `$name` of a gnuplot script; none when there is no such.
inline std::vector<std::vector<double>> data_block(const std::string& script,
                                                   const std::string& name) {
  std::istringstream lines(script);
  std::string line;
  while (std::getline(lines, line) && line != "$" + name + " << END") {
  }
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line) && line != "END") {
    std::istringstream cells(line);
    std::vector<double> row;
    for (double number = 0; cells >> number;) {
      row.push_back(number);
    }
    rows.push_back(row);
  }
  return rows;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Whether one of the lines of a text is this.
inline bool has_line(const std::string& text, const std::string& line) {
  return contains("\n" + text, "\n" + line + "\n");
}

}  // namespace maquette::tests
