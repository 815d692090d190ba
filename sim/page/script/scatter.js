// Any column of a table over any other, as marks; filtered rows are left out.
import { colours, configuration } from "#charts";
import { choosePointSoon } from "#points";
import { quantity } from "#tables";

// The columns that hold numbers in every row that says anything, and not the same everywhere.
export function plottableColumns(headings, rows) {
  return headings.map((_, column) => column).filter((column) => {
    const texts = rows.map((row) => row[column]).filter((text) => text.trim() !== "");
    return new Set(texts).size > 1 && texts.every((text) => quantity(text) !== null);
  });
}

// The columns that are shown first: over the first one behind the number of a row the frame time,
// or an error.
export function firstAxes(headings, columns) {
  const x = columns.find((column) => column > 0) ?? columns[0];
  const others = columns.filter((column) => column !== x);
  const named = (pattern) => others.find((column) => pattern.test(headings[column]));
  return [x, named(/^frame\.time_s/) ?? named(/error/) ?? others[0]];
}

// The configuration of Chart.js for such a chart: a mark that is chosen is larger, and one that is clicked gets chosen.
export function withChoice(configuration, points, chosen, onChosen) {
  const [marks] = configuration.data.datasets;
  marks.pointRadius = points.map(({ name }) => (name === chosen ? 10 : 5));
  configuration.options.onClick = (event, hits) => hits.length > 0 && onChosen(points[hits[0].index].name);
  return configuration;
}

// The chart of one column over another; each mark is called by the first cells of its row.
export function scatterOf(headings, rows, x, y, isLogarithmic) {
  const points = rows
    .map((row) => ({ x: quantity(row[x]), y: quantity(row[y]), label: row.slice(0, 3).join(" "), name: row[0] }))
    .filter((point) => point.x !== null && point.y !== null);
  return { kind: "scatter", x_title: headings[x], y_title: headings[y],
           logarithmic_x: isLogarithmic, logarithmic_y: isLogarithmic, labels: [],
           series: [{ name: headings[y], values: [], points }] };
}

const textsOf = (row) => [...row.cells].map((cell) => cell.textContent);

function choiceOf(name, headings, columns, chosen, document) {
  const label = document.createElement("label");
  const choice = document.createElement("select");
  for (const column of columns) {
    choice.append(new document.defaultView.Option(headings[column], String(column), false, column === chosen));
  }
  label.append(`${name} `, choice);
  return [label, choice];
}

function addScatter(table, document, window) {
  const headings = textsOf(table.tHead.rows[0]);
  const shownRows = () => [...table.tBodies[0].rows].filter((row) => !row.hidden).map(textsOf);
  const columns = plottableColumns(headings, shownRows());
  if (columns.length < 2) return;
  const [startX, startY] = firstAxes(headings, columns);
  const [xLabel, x] = choiceOf("Across", headings, columns, startX, document);
  const [yLabel, y] = choiceOf("Up", headings, columns, startY, document);
  const logLabel = document.createElement("label");
  const log = document.createElement("input");
  log.type = "checkbox";
  logLabel.append(log, " logarithmic");
  const controls = document.createElement("div");
  controls.className = "controls";
  controls.append(xLabel, yLabel, logLabel);
  const plot = document.createElement("div");
  plot.className = "plot";
  plot.style.height = "340px";
  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  plot.append(canvas);
  table.parentElement.before(controls, plot);
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  let [drawn, chosen] = [null, ""];
  const draw = () => {
    drawn?.destroy();
    const chart = scatterOf(headings, shownRows(), Number(x.value), Number(y.value), log.checked);
    canvas.setAttribute("aria-label", `${chart.y_title} over ${chart.x_title}. The table below has it.`);
    drawn = new window.Chart(canvas, withChoice(configuration(chart, colours(dark.matches), (colour) => colour),
                                                chart.series[0].points, chosen, (name) => choosePointSoon(document, name)));
  };
  for (const control of [x, y, log]) control.addEventListener("change", draw);
  table.addEventListener("filtered", draw);
  document.addEventListener("point", ({ detail }) => { chosen = detail; draw(); });
  dark.addEventListener("change", draw);
  draw();
}

export function addScatters(document, window) {
  for (const table of document.querySelectorAll("table.plotted")) addScatter(table, document, window);
}
