// The plots: from the data that the page carries to configurations of Chart.js.

const lightColours = {
  ink: "#1a1a1a", line: "#d4d4d4", ground: "#ffffff", scale: [0, 0.8],
  series: ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b8860b", "#56b4e9"],
};
const darkColours = {
  ink: "#ececec", line: "#3c3f44", ground: "#16181b", scale: [0.3, 1],
  series: ["#56b4e9", "#f0a35e", "#4fc7a4", "#e3a7c7", "#f0e442", "#8fb7ff"],
};
const pointStyles = ["circle", "rect", "triangle", "rectRot", "cross", "star"];

export function colours(isDark) {
  return isDark ? darkColours : lightColours;
}

// The height that a plot takes, in pixels.
export function heightOf(chart) {
  return chart.kind === "bars" ? 110 + 26 * chart.labels.length : 340;
}

// Series differ by pattern as well as by colour: the first is plain, the others hatched in turn.
function patternOf(context, colour, index, ground) {
  if (index === 0) return colour;
  const size = 8;
  const tile = context.canvas.ownerDocument.createElement("canvas");
  tile.width = size;
  tile.height = size;
  const pen = tile.getContext("2d");
  pen.fillStyle = colour;
  pen.fillRect(0, 0, size, size);
  pen.strokeStyle = ground;
  pen.lineWidth = 1.5;
  pen.beginPath();
  if (index % 3 === 1) { pen.moveTo(0, size); pen.lineTo(size, 0); }
  if (index % 3 === 2) { pen.moveTo(0, size / 2); pen.lineTo(size, size / 2); }
  if (index % 3 === 0) { pen.moveTo(size / 2, 0); pen.lineTo(size / 2, size); }
  pen.stroke();
  return context.createPattern(tile, "repeat");
}

function axis(title, type, isStacked, palette) {
  return {
    type,
    stacked: isStacked,
    title: { display: title !== "", text: title, color: palette.ink },
    ticks: { color: palette.ink },
    grid: { color: palette.line },
  };
}

function labelOf(item) {
  const point = item.raw;
  if (point !== null && typeof point === "object") return `${point.label}: ${point.x}, ${point.y}`;
  return `${item.dataset.label}: ${point}`;
}

// The configuration of Chart.js for a chart of the page; `fill` gives the filling of a series.
export function configuration(chart, palette, fill) {
  const isBars = chart.kind === "bars" || chart.kind === "columns";
  const isHorizontal = chart.kind === "bars";
  const typeOf = (isOfLabels, isLogarithmic) =>
    isOfLabels ? "category" : isLogarithmic ? "logarithmic" : "linear";
  const isStacked = isBars && chart.series.length > 1;
  const datasets = chart.series.map((series, index) => {
    const colour = palette.series[index % palette.series.length];
    return {
      label: series.name,
      data: isBars ? series.values : series.points,
      backgroundColor: fill(colour, index),
      borderColor: colour,
      borderWidth: isBars ? 0 : 2,
      pointStyle: pointStyles[index % pointStyles.length],
      pointRadius: chart.kind === "scatter" ? 5 : 0,
      showLine: chart.kind === "lines",
    };
  });
  return {
    type: isBars ? "bar" : "scatter",
    data: { labels: chart.labels, datasets },
    options: {
      animation: false,
      responsive: true,
      maintainAspectRatio: false,
      indexAxis: isHorizontal ? "y" : "x",
      scales: {
        x: axis(chart.x_title, typeOf(chart.kind === "columns", chart.logarithmic_x), isStacked, palette),
        y: axis(chart.y_title, typeOf(chart.kind === "bars", chart.logarithmic_y), isStacked, palette),
      },
      plugins: {
        legend: { display: chart.series.length > 1,
                  labels: { color: palette.ink, usePointStyle: !isBars } },
        tooltip: { callbacks: { label: labelOf } },
      },
    },
  };
}

// The part of an axis that two sliders leave, as shares of its whole; never nothing.
export function zoomed(low, high, from, to) {
  const [first, last] = [Math.min(from, to), Math.max(from, to)];
  const end = Math.max(last, first + 0.01);
  return { min: low + first * (high - low), max: low + end * (high - low) };
}

// Two sliders that choose which part of the time a chart of lines shows.
function addZoom(figure, document, onChange) {
  const controls = document.createElement("div");
  controls.className = "controls";
  const sliders = [["From", 0], ["To", 1]].map(([name, value]) => {
    const label = document.createElement("label");
    const slider = document.createElement("input");
    Object.assign(slider, { type: "range", min: 0, max: 1, step: 0.01, value });
    label.append(`${name} `, slider);
    controls.append(label);
    return slider;
  });
  for (const slider of sliders) {
    slider.addEventListener("input", () => onChange(...sliders.map((it) => Number(it.value))));
  }
  figure.append(controls);
}

function drawChart(figure, window, palette) {
  const chart = JSON.parse(figure.querySelector("script").textContent);
  const canvas = figure.querySelector("canvas");
  canvas.parentElement.style.height = `${heightOf(chart)}px`;
  const context = canvas.getContext("2d");
  const fill = (colour, index) => patternOf(context, colour, index, palette.ground);
  return new window.Chart(canvas, configuration(chart, palette, fill));
}

// Draws all charts, and again when the colours change; on paper in those of light.
export function drawCharts(document, window) {
  const figures = [...document.querySelectorAll("figure.chart")];
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  let drawn = [];
  figures.forEach((figure, place) => {
    const chart = JSON.parse(figure.querySelector("script").textContent);
    if (chart.kind !== "lines") return;
    const times = chart.series.flatMap((series) => series.points.map((point) => point.x));
    addZoom(figure, document, (from, to) => {
      Object.assign(drawn[place].options.scales.x, zoomed(Math.min(...times), Math.max(...times), from, to));
      drawn[place].update();
    });
  });
  const draw = (isDark) => {
    for (const chart of drawn) chart.destroy();
    drawn = figures.map((figure) => drawChart(figure, window, colours(isDark)));
  };
  dark.addEventListener("change", () => draw(dark.matches));
  window.addEventListener("beforeprint", () => dark.matches && draw(false));
  window.addEventListener("afterprint", () => dark.matches && draw(true));
  draw(dark.matches);
}
