#include "sim/trace/svg_chart.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "sim/report/seconds.hpp"

namespace maquette::sim {

namespace {

using models::Duration;
using models::Instant;

constexpr double k_height = 720;
constexpr double k_left = 110;
constexpr double k_right = 1250;
constexpr double k_least_text = 9;
constexpr int k_columns = static_cast<int>(k_right - k_left);
constexpr double k_least_share = 0.01;  // of a column that is drawn

// Colours of Okabe and Ito, which people of any colour vision tell apart, and patterns besides.
constexpr std::string_view k_head =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1280 720" font-family="sans-serif">
<defs>
<pattern id="stripes" width="6" height="6" patternUnits="userSpaceOnUse"
 patternTransform="rotate(45)"><rect width="6" height="6" fill="#e69f00"/>
<rect width="2" height="6" fill="#fff"/></pattern>
<pattern id="dots" width="5" height="5" patternUnits="userSpaceOnUse">
<rect width="5" height="5" fill="#cc79a7"/><circle cx="2" cy="2" r="1.1" fill="#fff"/></pattern>
</defs>
<style>
.compute {{ fill: #b8d8ea; }} .wait {{ fill: url(#stripes); }} .transfer {{ fill: #0072b2; }}
.idle, .free {{ fill: #f0f0f0; }} .arbitration {{ fill: url(#dots); }} .kept {{ fill: #d5e8d4; }}
.odd {{ fill: #009e73; }} .even {{ fill: #56b4e9; }}
.queue {{ fill: none; stroke: #000; stroke-width: 1.5; }} .axis {{ stroke: #888; stroke-width: 1; }}
</style>
<rect width="1280" height="720" fill="#fff"/>
<title>{0}</title>
<text x="110" y="34" font-size="20">{0}</text>
)svg";

constexpr std::string_view k_arrow_head =
    R"svg(<defs><marker id="head" viewBox="0 0 6 6" refX="6" refY="3" markerWidth="6" markerHeight="6"
 orient="auto"><path d="M0,0 L6,3 L0,6 z" fill="#d55e00"/></marker></defs>
<style>.errand { stroke: #d55e00; stroke-width: 1; marker-end: url(#head); }</style>
)svg";

/// The step between marks of an axis: 1, 2 or 5 times a power of ten, at most some ten of them.
Duration step_of(Duration span) {
  constexpr int k_marks = 10;
  std::int64_t step = 1;
  while (true) {
    for (const std::int64_t factor : {1, 2, 5}) {
      if (span.count() / (factor * step) <= k_marks) {
        return Duration(factor * step);
      }
    }
    step *= 10;
  }
}

using Shares = std::map<std::string_view, double>;

/// The shares of a column's time by state; small ones are not seen.
Shares shares_between(Instant from, Instant to, std::vector<ChartStay>::const_iterator& stay,
                      std::vector<ChartStay>::const_iterator end) {
  const auto column = static_cast<double>(std::max<std::int64_t>(1, (to - from).count()));
  Shares shares;
  for (; stay != end && stay->from < to; ++stay) {
    const Duration time = std::min(to, stay->to) - std::max(from, stay->from);
    shares[stay->kind] += std::max(0.0, static_cast<double>(time.count()) / column);
    if (stay->to > to) {
      break;
    }
  }
  for (auto share = shares.begin(); share != shares.end();) {
    share = share->second < k_least_share ? shares.erase(share) : std::next(share);
  }
  return shares;
}

}  // namespace

SvgChart::SvgChart(const TraceWindow& window, const std::string& title, std::ostream& stream)
    : window_(window), text_(stream) {
  text_.add(k_head, title);
}

double SvgChart::x_of(Instant instant) const {
  const double span = static_cast<double>((window_.to - window_.from).count());
  const double part = static_cast<double>((window_.clip(instant) - window_.from).count());
  return span > 0 ? k_left + (k_right - k_left) * part / span : k_left;
}

Instant SvgChart::column_start(int column) const {
  const double span = static_cast<double>((window_.to - window_.from).count());
  return window_.from + Duration(static_cast<Duration::rep>(span * column / k_columns));
}

void SvgChart::box(std::string_view kind, double x0, double x1, double y, double height) {
  text_.add(R"(<rect class="{}" x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}"/>)"
            "\n",
            kind, x0, y, x1 - x0, height);
}

void SvgChart::name(const ChartBand& band, const std::string& name) {
  if (band.height >= k_least_text) {
    text_.add(R"(<text x="{}" y="{:.1f}" font-size="{:.0f}" text-anchor="end">{}</text>)"
              "\n",
              k_left - 8, band.top + band.height / 2 + 5, std::min(14.0, band.height), name);
  }
}

void SvgChart::track(const ChartBand& band, const std::string& text,
                     const std::vector<ChartStay>& stays) {
  name(band, text);
  if (stays.size() > static_cast<std::size_t>(k_columns)) {
    shares(band, stays);
    return;
  }
  for (const ChartStay& stay : stays) {
    if (window_.clip(stay.from) < window_.clip(stay.to)) {
      box(stay.kind, x_of(stay.from), x_of(stay.to), band.top, band.height);
    }
  }
}

void SvgChart::shares(const ChartBand& band, const std::vector<ChartStay>& stays) {
  std::string_view whole;  // the one state of all columns from `first` on
  int first = 0;
  const auto draw_whole = [&](int end) {
    if (!whole.empty()) {
      box(whole, k_left + first, k_left + end, band.top, band.height);
    }
    whole = {};
  };
  auto stay = stays.begin();
  for (int column = 0; column < k_columns; ++column) {
    const Shares shares =
        shares_between(column_start(column), column_start(column + 1), stay, stays.end());
    const bool is_whole = shares.size() == 1 && shares.begin()->second > 1 - k_least_share;
    if (!is_whole || shares.begin()->first != whole) {
      draw_whole(column);
    }
    if (is_whole) {
      first = whole.empty() ? column : first;
      whole = shares.begin()->first;
      continue;
    }
    double y = band.top;
    for (const auto& [kind, share] : shares) {
      box(kind, k_left + column, k_left + column + 1, y, band.height * share);
      y += band.height * share;
    }
  }
  draw_whole(k_columns);
}

void SvgChart::steps(const ChartBand& band, const std::string& text,
                     const std::vector<std::pair<Instant, int>>& values) {
  name(band, text);
  int most = 1;
  std::map<double, int> at;  // the largest from each place on
  const bool is_dense = values.size() > static_cast<std::size_t>(k_columns);
  for (const auto& [instant, value] : values) {
    const double x = is_dense ? std::floor(x_of(instant)) : x_of(instant);
    most = std::max(most, value);
    int& shown = at.try_emplace(x, value).first->second;
    shown = is_dense ? std::max(shown, value) : value;
  }
  std::string path;
  const auto y_of = [&](int value) {
    return band.top + band.height * (1 - static_cast<double>(value) / most);
  };
  int before = 0;
  for (const auto& [x, value] : at) {
    path += fmt::format("{}{:.2f},{:.2f} {:.2f},{:.2f}", path.empty() ? "" : " ", x, y_of(before),
                        x, y_of(value));
    before = value;
  }
  text_.add(R"(<polyline class="queue" points="{} {},{:.2f}"/>)"
            "\n",
            path, k_right, y_of(before));
  text_.add(R"(<text x="{}" y="{:.1f}" font-size="12">{}</text>)"
            "\n",
            k_right + 5, band.top + 5, most);
}

void SvgChart::label(const ChartBand& band, const std::string& text, Instant from, Instant to) {
  constexpr double k_letter = 8;
  if (x_of(to) - x_of(from) > k_letter * static_cast<double>(text.size() + 1)) {
    text_.add(R"(<text x="{:.1f}" y="{:.1f}" font-size="13" text-anchor="middle">{}</text>)"
              "\n",
              (x_of(from) + x_of(to)) / 2, band.top + band.height / 2 + 5, text);
  }
}

void SvgChart::arrows(const std::vector<ChartArrow>& arrows) {
  if (!arrows.empty()) {
    text_.add("{}", k_arrow_head);
  }
  for (const ChartArrow& arrow : arrows) {
    const bool is_down = arrow.from.top < arrow.to.top;
    text_.add(R"(<line class="errand" x1="{:.2f}" y1="{:.2f}" x2="{:.2f}" y2="{:.2f}"/>)"
              "\n",
              x_of(arrow.sent), is_down ? arrow.from.top + arrow.from.height : arrow.from.top,
              x_of(arrow.arrived), is_down ? arrow.to.top : arrow.to.top + arrow.to.height);
  }
}

void SvgChart::axis(double top) {
  const Duration step = step_of(window_.to - window_.from);
  for (Instant at{}; at <= window_.to - window_.from; at += step) {
    const double x = x_of(window_.from + at);
    text_.add(
        R"(<line class="axis" x1="{0:.2f}" x2="{0:.2f}" y1="50" y2="{1:.1f}" stroke-opacity="0.4"/>)"
        R"(<text x="{0:.2f}" y="{2:.1f}" font-size="13" text-anchor="middle">{3}</text>)"
        "\n",
        x, top, top + 18, at.count() == 0 ? "0" : readable_duration(at));
    if (step.count() == 0) {
      break;
    }
  }
  text_.add(
      R"(<text x="{}" y="{:.1f}" font-size="13" text-anchor="end">time after {} s of the frame</text>)"
      "\n",
      k_right, top + 38, format_seconds(window_.from));
}

void SvgChart::finish(double axis_top,
                      const std::vector<std::pair<std::string_view, std::string>>& legend) {
  axis(axis_top);
  constexpr double k_letter = 8;
  double x = k_left;
  for (const auto& [kind, meaning] : legend) {
    box(kind, x, x + 18, k_height - 34, 18);
    text_.add(R"(<text x="{:.1f}" y="{}" font-size="14">{}</text>)"
              "\n",
              x + 24, k_height - 20, meaning);
    x += 24 + k_letter * static_cast<double>(meaning.size() + 3);
  }
  text_.add("</svg>\n");
}

}  // namespace maquette::sim
