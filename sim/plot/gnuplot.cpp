#include "sim/plot/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "sim/report/run_directory.hpp"
#include "sim/report/unfinished.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

constexpr int k_no_gnuplot = 127;  // as shells have it

/// Colours that people with any colour vision tell apart (Okabe and Ito 2008).
constexpr const char* k_style = R"(set encoding utf8
set linetype 1 linecolor rgb '#0072B2' linewidth 2 pointtype 7
set linetype 2 linecolor rgb '#D55E00' linewidth 2 pointtype 5
set linetype 3 linecolor rgb '#009E73' linewidth 2 pointtype 9
set linetype 4 linecolor rgb '#CC79A7' linewidth 2 pointtype 11
set linetype 5 linecolor rgb '#E69F00' linewidth 2 pointtype 13
set linetype 6 linecolor rgb '#56B4E9' linewidth 2 pointtype 15
set linetype 7 linecolor rgb '#444444' linewidth 2 pointtype 7
set linetype cycle 7
set border 3
set tics nomirror out
set grid linecolor rgb '#DDDDDD' linewidth 1 linetype 1
set key noenhanced
)";

/// Runs gnuplot in a directory, without the settings of its user; the exit code. Its locale is one
/// that every Debian has: in one without UTF-8 gnuplot 6 warns that it finds no degree sign.
int run_gnuplot(const fs::path& directory, const std::string& script) {
  const pid_t process = ::fork();
  if (process == 0) {
    if (::chdir(directory.c_str()) == 0 && ::setenv("LC_ALL", "C.UTF-8", 1) == 0) {
      ::execlp("gnuplot", "gnuplot", "--default-settings", script.c_str(), nullptr);
    }
    ::_exit(k_no_gnuplot);
  }
  int status = 0;
  while (process > 0 && ::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return process > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// A directory that goes away with its owner.
class Workplace {
 public:
  explicit Workplace(fs::path path) : path_(std::move(path)) { fs::create_directories(path_); }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  Workplace(Workplace&&) = delete;
  Workplace& operator=(Workplace&&) = delete;
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

std::string gnuplot_text(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) {
    if (letter == '\n') {
      result += R"('."\n".')";
    } else {
      result.append(letter == '\'' ? 2 : 1, letter);
    }
  }
  return result + "'";
}

std::string gnuplot_number(double value) {
  const bool is_large = value >= 1e4 || value <= -1e4;
  return fmt::format("{:.{}g}", value, is_large ? 8 : 4);
}

std::string gnuplot_data(const std::string& name, const std::vector<std::vector<double>>& rows) {
  std::string text = "$" + name + " << END\n";
  for (const std::vector<double>& row : rows) {
    const char* separator = "";
    for (const double number : row) {
      text += fmt::format("{}{}", separator, number);
      separator = " ";
    }
    text += '\n';
  }
  return text + "END\n";
}

std::string gnuplot_data(const std::string& name, const std::vector<PlotPoint>& points) {
  std::vector<std::vector<double>> rows;
  rows.reserve(points.size());
  for (const PlotPoint& point : points) {
    rows.push_back({point.x, point.y});
  }
  return gnuplot_data(name, rows);
}

std::string wrapped(const std::string& text, std::size_t width) {
  std::istringstream words(text);
  std::string result;
  std::size_t length = 0;
  for (std::string word; words >> word;) {
    const bool fits = length + 1 + word.size() <= width;
    if (!result.empty()) {
      result += fits ? ' ' : '\n';
    }
    length = result.empty() || !fits ? word.size() : length + 1 + word.size();
    result += word;
  }
  return result;
}

std::string gnuplot_script(const std::string& name, const std::string& settings,
                           const std::string& plot) {
  return fmt::format(
      "# Change it as you like; `gnuplot {0}.gp` draws it again.\n{1}{2}"
      "set terminal pngcairo noenhanced size 1280,800 font 'Sans,13'\n"
      "set output '{0}.png'\n{3}\n"
      "set terminal svg noenhanced size 1280,800 font 'Sans,17' background 'white' name "
      "'maquette'\n"
      "set output '{0}.svg'\nreplot\n",
      name, k_style, settings, plot);
}

void draw(const fs::path& directory, const std::string& name, const std::string& script) {
  clear_unfinished(directory, name);
  const Workplace workplace(directory / unfinished_name(name));
  write_files(workplace.path(), {{name + ".gp", script}});
  const int exit_code = run_gnuplot(workplace.path(), name + ".gp");
  if (exit_code != 0) {
    throw std::runtime_error(exit_code == k_no_gnuplot
                                 ? "gnuplot cannot be run; Debian's package gnuplot-nox has it"
                                 : "gnuplot could not draw " + name);
  }
  constexpr std::array k_endings{".gp", ".png", ".svg"};
  for (const char* ending : k_endings) {
    fs::rename(workplace.path() / (name + ending), directory / (name + ending));
  }
}

}  // namespace maquette::sim
