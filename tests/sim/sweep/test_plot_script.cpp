#include <filesystem>

#include "sim/plot/gnuplot.hpp"
#include "sim/report/quantile.hpp"
#include "sim/sweep/plot_script.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

using namespace maquette::sim;

namespace {

Study study_of(StudyDesign design) {
  Study study;
  study.name = "it's a `date` of $table \"quoted\" \\n";
  study.design = design;
  study.axes = {parse_axis("a=1..2"), parse_axis("b=x,y")};
  return study;
}

const Table k_table{{{"point", "", ""}, {"a", "us", "how long"}, {"b", "", ""}, {"t", "s", ""}},
                    {{"0", "5", "w", "10"},
                     {"1", "1", "w", "7"},
                     {"2", "2", "w", "11"},
                     {"3", "5", "x", "30"},
                     {"4", "5", "y", ""}}};

Plot plot_of(PlotKind kind) {
  Plot plot;
  plot.kind = kind;
  plot.x = "a";
  plot.y = "t";
  plot.band = "t";
  plot.band_low = 7;
  plot.band_high = 20;
  return plot;
}

std::string script_of(PlotKind kind, StudyDesign design) {
  const Study study = study_of(design);
  return plot_script(plot_of(kind), {study, k_table, {true, false, false, false, false}});
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("texts of users cannot run anything in gnuplot") {
  CHECK(gnuplot_text("it's `date`") == "'it''s `date`'");
  CHECK(gnuplot_text("a\nb") == "'a'.\"\\n\".'b'");
}

TEST_CASE("long texts are wrapped between words") {
  CHECK(wrapped("one two three", 7) == "one two\nthree");
  CHECK(wrapped("incomprehensible", 4) == "incomprehensible");
  CHECK(wrapped("", 4).empty());
}

TEST_CASE("quantiles interpolate between sorted values") {
  CHECK(quantile({1, 2, 3, 4, 5}, 0.5) == 3);
  CHECK(quantile({1, 2, 3, 4, 5}, 0.05) == Approx(1.2));
  CHECK(quantile({7}, 0.95) == 7);
}

TEST_CASE("a tornado has the longest bar on top, with the values that make its ends") {
  const std::string script = script_of(PlotKind::tornado, StudyDesign::one_at_a_time);
  CHECK(contains(script, "set ytics ('b' 2, 'a' 1)"));
  CHECK(contains(script, "set label '1 us' at 7, 1 right"));
  CHECK(contains(script, "set label '2 us' at 11, 1 left"));
  CHECK(contains(script, "set label 'x' at 30, 2 left"));
  CHECK(contains(script, "'as described: 10 s'"));
}

TEST_CASE("a histogram leaves out the point that varies nothing") {
  const std::string script = script_of(PlotKind::histogram, StudyDesign::latin_hypercube);
  CHECK(contains(script, "'points, of 3'"));
  CHECK(contains(script, "median 11 s"));
}

TEST_CASE("a scatter plot tells points within the band from the others") {
  const std::string script = script_of(PlotKind::scatter, StudyDesign::latin_hypercube);
  CHECK(contains(script, "$inside << END\n1 7\n2 11\nEND"));
  CHECK(contains(script, "$outside << END\n5 30\nEND"));
  CHECK(contains(script, "t within 7 to 20 s: 2 of 3 points"));
}

TEST_CASE("lines have one curve per series and mark the prototype") {
  Plot plot = plot_of(PlotKind::lines);
  plot.series = "b";
  const Study study = study_of(StudyDesign::grid);
  const std::string script =
      plot_script(plot, {study, k_table, {true, false, false, false, false}});
  CHECK(contains(script, "$series0 << END\n5 10\n1 7\n2 11\nEND"));
  CHECK(contains(script, "$series1 << END\n5 30\nEND"));
  CHECK(contains(script, "$prototype << END\n5 10\nEND"));
  CHECK(contains(script, "set xlabel 'a [us]: how long'"));
}

TEST_CASE("every kind is drawn, the same bytes each time, and nothing else is left") {
  for (const PlotKind kind :
       {PlotKind::lines, PlotKind::tornado, PlotKind::histogram, PlotKind::scatter}) {
    const std::string script = script_of(kind, StudyDesign::one_at_a_time);
    const std::string name = file_name_of(plot_of(kind));
    const maquette::tests::ScratchDirectory scratch;
    for (const char* place : {"one", "two"}) {
      draw(scratch.path() / place, name, script);
    }
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path() / "one")) {
      INFO(entry.path().string());
      CHECK(read_text(entry.path()) == read_text(scratch.path() / "two" / entry.path().filename()));
      CHECK_FALSE(read_text(entry.path()).empty());
      ++files;
    }
    CHECK(files == 3);
  }
  const maquette::tests::ScratchDirectory scratch;
  CHECK_THROWS_AS(draw(scratch.path(), "wrong", "plot nonsense("), std::runtime_error);
}
