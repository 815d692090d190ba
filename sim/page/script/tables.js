// Tables that can be sorted by any column and filtered by words.

const factors = {
  ps: 1e-12, ns: 1e-9, us: 1e-6, ms: 1e-3, s: 1, min: 60, h: 3600, d: 86400, "%": 0.01,
  Hz: 1, kHz: 1e3, MHz: 1e6, GHz: 1e9, bytes: 1, KiB: 1024, MiB: 1048576,
};

// The number that a text means, with its units: "7 min 20.4 s" is 440.4; null where it is none.
export function quantity(text) {
  const parts = text.trim().match(/[-+]?[\d.]+(?:e[-+]?\d+)?\s*(?:[A-Za-z%]+)?/g);
  if (parts === null || parts.join(" ").replace(/\s/g, "") !== text.replace(/\s/g, "")) return null;
  let sum = 0;
  for (const part of parts) {
    const [, number, unit] = part.match(/^([-+]?[\d.]+(?:e[-+]?\d+)?)\s*([A-Za-z%]*)$/) ?? [];
    const factor = unit === "" ? 1 : factors[unit];
    if (number === undefined || factor === undefined || Number.isNaN(Number(number))) return null;
    sum += Number(number) * factor;
  }
  return sum;
}

// Before, after or equal: numbers among themselves, then texts, then what is empty.
export function compareTexts(first, second) {
  const rank = (text, number) => (text.trim() === "" ? 2 : number === null ? 1 : 0);
  const numbers = [quantity(first), quantity(second)];
  const ranks = [rank(first, numbers[0]), rank(second, numbers[1])];
  if (ranks[0] !== ranks[1]) return ranks[0] - ranks[1];
  return ranks[0] === 0 ? numbers[0] - numbers[1] : first.localeCompare(second, "en");
}

// The places of rows in the order of a column; equal ones stay as they are.
export function sortedOrder(rows, column, isAscending) {
  const sign = isAscending ? 1 : -1;
  return rows.map((_, place) => place)
    .sort((a, b) => sign * compareTexts(rows[a][column], rows[b][column]) || a - b);
}

// Whether a row has all words, in any cell; `name=value` asks for a whole cell of that column.
export function matches(cells, headings, filter) {
  return filter.toLowerCase().split(/\s+/).filter((word) => word !== "").every((word) => {
    const [name, value] = word.split("=");
    const column = value === undefined ? -1
      : headings.findIndex((heading) => heading.toLowerCase().split(" ")[0] === name);
    if (column >= 0) return cells[column].toLowerCase() === value;
    return cells.some((cell) => cell.toLowerCase().includes(word));
  });
}

// Hides a row for one of several reasons, and shows it again once there is none.
export function hide(row, reason, isHidden) {
  const reasons = new Set((row.dataset.hiddenBy ?? "").split(" ").filter((each) => each !== ""));
  if (isHidden) reasons.add(reason); else reasons.delete(reason);
  row.dataset.hiddenBy = [...reasons].join(" ");
  row.hidden = reasons.size > 0;
}

const textsOf = (row) => [...row.cells].map((cell) => cell.textContent);

function sortBy(table, heading, column) {
  const isAscending = heading.getAttribute("aria-sort") !== "ascending";
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  heading.setAttribute("aria-sort", isAscending ? "ascending" : "descending");
  const rows = [...table.tBodies[0].rows];
  const order = sortedOrder(rows.map(textsOf), column, isAscending);
  table.tBodies[0].append(...order.map((place) => rows[place]));
}

function addSorting(table, document) {
  [...table.tHead.rows[0].cells].forEach((heading, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = heading.textContent;
    button.addEventListener("click", () => sortBy(table, heading, column));
    heading.replaceChildren(button);
  });
}

function addFilter(table, document) {
  const headings = textsOf(table.tHead.rows[0]);
  const label = document.createElement("label");
  label.className = "controls";
  const input = document.createElement("input");
  input.type = "search";
  label.append("Rows with ", input);
  input.addEventListener("input", () => {
    for (const row of table.tBodies[0].rows) hide(row, "words", !matches(textsOf(row), headings, input.value));
    table.dispatchEvent(new document.defaultView.Event("filtered"));
  });
  table.parentElement.before(label);
}

export function enrichTables(document) {
  for (const table of document.querySelectorAll("table.filterable")) addFilter(table, document);
  for (const table of document.querySelectorAll("table.sortable")) addSorting(table, document);
}
