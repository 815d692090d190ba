// Parallel coordinates: an axis for each column of a table, and a line through them for each of its rows.
import { colours } from "#charts";
import { colourOf } from "#layers";
import { choosePointSoon } from "#points";
import { hide, quantity } from "#tables";

const mostNames = 12;
const mostAxes = 7;
const usual = [/^speed_up/, /^frame\.time_s/, /^bus\.occupied/, /^bus\.wait_mean_s/, /^frame\.imbalance/];

// The columns that differ from row to row, as axes: of numbers, else of a few names in the order of the rows.
export function axesOf(headings, rows) {
  return headings.map((heading, column) => {
    const texts = rows.map((row) => row[column]).filter((text) => text.trim() !== "");
    const names = [...new Set(texts)];
    const numbers = texts.map(quantity);
    if (column === 0 || names.length < 2) return null;
    if (numbers.every((number) => number !== null)) {
      const [low, high] = [numbers.reduce((a, b) => Math.min(a, b)), numbers.reduce((a, b) => Math.max(a, b))];
      return { heading, column, names: null, low, high };
    }
    return names.length <= mostNames ? { heading, column, names, low: 0, high: names.length - 1 } : null;
  }).filter((axis) => axis !== null);
}

// The axes that are shown at first: what was varied, and some of what came of it.
export function firstAxesOf(axes, headings) {
  const status = headings.indexOf("status");
  const varied = axes.filter(({ column }) => column < status);
  const results = usual.map((pattern) => axes.find(({ heading }) => pattern.test(heading))).filter(Boolean);
  const chosen = new Set([...varied, ...results].slice(0, mostAxes));
  return axes.filter((axis) => chosen.has(axis));
}

// Where a row crosses an axis, 0 to 1; null where it says nothing.
export function shareOn(axis, row) {
  const text = row[axis.column];
  if (text.trim() === "") return null;
  const value = axis.names === null ? quantity(text) : axis.names.indexOf(text);
  return axis.high > axis.low ? (value - axis.low) / (axis.high - axis.low) : 0.5;
}

// Whether a row lies in the range of every axis; where it says nothing it lies nowhere but in the whole.
export function isWithin(ranges, row) {
  return ranges.every(({ axis, from, to }) => {
    const share = shareOn(axis, row);
    if (share === null) return from <= 0 && to >= 1;
    return share >= Math.min(from, to) - 1e-9 && share <= Math.max(from, to) + 1e-9;
  });
}

const toldEnd = (axis, end) => (axis.names === null ? `${Number(axis[end].toPrecision(5))}` : axis.names[axis[end]]);

// What the plot says to those who do not see it.
export function summaryOf(axes, shown, all) {
  const told = axes.map((axis) => `${axis.heading} from ${toldEnd(axis, "low")} to ${toldEnd(axis, "high")}`);
  return `Parallel coordinates of ${shown} of ${all} points: ${told.join("; ")}. The table below has every value.`;
}

// The configuration of Chart.js; `look` says of each row whether it is hidden and whether it is chosen.
export function parallelOf(axes, rows, look, palette) {
  const [low, high] = palette.scale;
  const datasets = rows.map((row, place) => {
    const { isHidden, isChosen } = look(place);
    const share = shareOn(axes[0], row) ?? 0;
    return {
      label: row[0],
      data: axes.map((axis) => shareOn(axis, row)),
      borderColor: isHidden ? palette.line : isChosen ? palette.ink : `rgb(${colourOf(low + (high - low) * share).join(",")})`,
      borderWidth: isHidden ? 0.5 : isChosen ? 4 : 1.5,
      pointRadius: isHidden ? 0 : 2.5,
      pointHitRadius: 6,
      order: isChosen ? 0 : isHidden ? 2 : 1,
    };
  });
  const told = (item) => `${rows[item.datasetIndex][0]}: ${rows[item.datasetIndex][axes[item.dataIndex].column]}`;
  return {
    type: "line",
    data: { labels: axes.map((axis) => axis.heading.split(" ")), datasets },
    options: {
      animation: false, responsive: true, maintainAspectRatio: false,
      scales: {
        x: { ticks: { color: palette.ink, autoSkip: false }, grid: { color: palette.ink } },
        y: { min: 0, max: 1, ticks: { color: palette.ink, callback: (share) => ({ 0: "lowest", 1: "highest" })[share] ?? "" },
             grid: { color: palette.line } },
      },
      plugins: { legend: { display: false }, tooltip: { callbacks: { label: told } } },
    },
  };
}

const textsOf = (row) => [...row.cells].map((cell) => cell.textContent);

function checkboxes(axes, shown, document, onChange) {
  const [details, summary] = [document.createElement("details"), document.createElement("summary")];
  details.className = "controls";
  summary.textContent = "Choose the columns";
  details.append(summary);
  for (const axis of axes) {
    const [label, box] = [document.createElement("label"), document.createElement("input")];
    Object.assign(box, { type: "checkbox", checked: shown.has(axis) });
    box.addEventListener("change", () => {
      if (box.checked) shown.add(axis); else shown.delete(axis);
      onChange();
    });
    label.append(box, ` ${axis.heading}`);
    details.append(label);
  }
  return details;
}

// Two sliders for an axis, which leave the rows between them.
function rangeOf(axis, document, onChange) {
  const group = document.createElement("fieldset");
  const legend = document.createElement("legend");
  legend.textContent = `${axis.heading}: ${toldEnd(axis, "low")} to ${toldEnd(axis, "high")}`;
  group.append(legend);
  const range = { axis, from: 0, to: 1 };
  for (const [end, value] of [["from", 0], ["to", 1]]) {
    const [label, slider] = [document.createElement("label"), document.createElement("input")];
    Object.assign(slider, { type: "range", min: 0, max: 1, step: 0.01, value });
    slider.addEventListener("input", () => {
      range[end] = Number(slider.value);
      onChange();
    });
    label.append(`${end} `, slider);
    group.append(label);
  }
  return { group, range };
}

function placesIn(table, document) {
  const [plot, canvas, ranges] = ["div", "canvas", "div"].map((name) => document.createElement(name));
  plot.className = "plot";
  plot.id = "parallel";
  plot.style.height = "340px";
  canvas.setAttribute("role", "img");
  plot.append(canvas);
  ranges.className = "controls ranges";
  table.parentElement.before(plot, ranges);
  return { canvas, ranges };
}

function addParallel(table, document, window) {
  const headings = textsOf(table.tHead.rows[0]);
  const elements = [...table.tBodies[0].rows];
  const rows = elements.map(textsOf);
  const axes = axesOf(headings, rows);
  const shown = new Set(firstAxesOf(axes, headings));
  if (shown.size < 2) return;
  const { canvas, ranges } = placesIn(table, document);
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  let [drawn, chosen, within] = [null, "", []];
  const draw = () => {
    const axesShown = axes.filter((axis) => shown.has(axis));
    const look = (place) => ({ isHidden: elements[place].hidden, isChosen: rows[place][0] === chosen });
    canvas.setAttribute("aria-label", summaryOf(axesShown, elements.filter((row) => !row.hidden).length, rows.length));
    drawn?.destroy();
    const configuration = parallelOf(axesShown, rows, look, colours(dark.matches));
    configuration.options.onClick = (event, hits) => hits.length > 0 && choosePointSoon(document, rows[hits[0].datasetIndex][0]);
    drawn = new window.Chart(canvas, configuration);
  };
  const filter = () => {
    elements.forEach((row, place) => hide(row, "range", !isWithin(within, rows[place])));
    table.dispatchEvent(new window.Event("filtered"));
  };
  const arrange = () => {
    const made = axes.filter((axis) => shown.has(axis)).map((axis) => rangeOf(axis, document, filter));
    within = made.map(({ range }) => range);
    ranges.replaceChildren(...made.map(({ group }) => group));
    filter();
  };
  ranges.before(checkboxes(axes, shown, document, () => shown.size > 0 && arrange()));
  table.addEventListener("filtered", draw);
  document.addEventListener("point", ({ detail }) => { chosen = detail; draw(); });
  dark.addEventListener("change", draw);
  arrange();
}

export function addParallels(document, window) {
  for (const table of document.querySelectorAll("table.parallel")) addParallel(table, document, window);
}
