// A point of a sweep, chosen in its table, in a plot or by its name: what it varies, what came of it, how it runs again.

const cellOf = (headings, cells, name) => cells[headings.findIndex((heading) => heading === name)];

// What a row of the table says of its point: varied parameters stand before the status, results behind it.
export function factsOf(headings, cells) {
  const status = headings.indexOf("status");
  const pairs = headings.map((heading, column) => [heading, cells[column]]);
  const isTold = ([, value]) => value.trim() !== "";
  return {
    name: cells[0],
    varied: pairs.slice(1, status),
    status: cellOf(headings, cells, "status"),
    reason: cellOf(headings, cells, "reason") ?? "",
    results: pairs.slice(status + 2).filter(isTold),
  };
}

// How a point is called in a list.
export function titleOf(facts) {
  return `${facts.name}: ${facts.varied.map(([name, value]) => `${name} ${value}`).join(", ")}`;
}

// The command for a point, from that of the point 0 that the page has.
export function commandOf(template, name) {
  return template.replaceAll("POINT", name);
}

// Tells all who show points that one was chosen.
export function choosePoint(document, name) {
  document.dispatchEvent(new document.defaultView.CustomEvent("point", { detail: name }));
}

// The same once a plot has done with its event: it is drawn anew then.
export function choosePointSoon(document, name) {
  document.defaultView.setTimeout(() => choosePoint(document, name));
}

const textsOf = (row) => [...row.cells].map((cell) => cell.textContent);

function definitionsOf(pairs, document) {
  const list = document.createElement("dl");
  for (const [term, meaning] of pairs) {
    const [name, value] = [document.createElement("dt"), document.createElement("dd")];
    name.textContent = term;
    value.textContent = meaning;
    list.append(name, value);
  }
  return list;
}

function folded(title, content, document) {
  const [details, summary] = [document.createElement("details"), document.createElement("summary")];
  summary.textContent = title;
  details.append(summary, content);
  return details;
}

function show(shown, facts, template, document) {
  document.querySelector("#chosen-point > .command").textContent = commandOf(template, facts.name);
  const told = [["Point", facts.name], ...facts.varied, ["Status", `${facts.status} ${facts.reason}`.trim()]];
  const results = facts.results.length === 0 ? []
    : [folded(`Its ${facts.results.length} results`, definitionsOf(facts.results, document), document)];
  shown.replaceChildren(definitionsOf(told, document), ...results);
  for (const kept of document.querySelectorAll("figure.kept")) kept.hidden = kept.dataset.point !== facts.name;
}

// Lets each row of the table choose its point.
function addButtons(rows, document) {
  for (const row of rows) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = row.cells[0].textContent;
    button.setAttribute("aria-label", `choose point ${row.cells[0].textContent}`);
    button.addEventListener("click", () => choosePoint(document, button.textContent));
    row.cells[0].replaceChildren(button);
  }
}

export function startPoints(document) {
  const section = document.getElementById("chosen-point");
  if (section === null) return;
  const table = document.querySelector("table.plotted");
  const headings = textsOf(table.tHead.rows[0]);
  const rows = [...table.tBodies[0].rows];
  const facts = rows.map((row) => factsOf(headings, textsOf(row)));
  const label = document.createElement("label");
  const choice = document.createElement("select");
  label.className = "controls";
  choice.id = "point-choice";
  for (const each of facts) choice.append(new document.defaultView.Option(titleOf(each), each.name));
  label.append("Point ", choice);
  const shown = document.createElement("div");
  shown.id = "point-shown";
  shown.setAttribute("aria-live", "polite");
  section.prepend(label, shown);
  choice.addEventListener("change", () => choosePoint(document, choice.value));
  document.addEventListener("point", ({ detail }) => {
    choice.value = detail;
    for (const row of rows) row.classList.toggle("chosen", row.cells[0].textContent === detail);
    const chosen = facts.find(({ name }) => name === detail);
    if (chosen !== undefined) show(shown, chosen, section.dataset.command, document);
  });
  addButtons(rows, document);
  if (facts.length > 0) choosePoint(document, facts[0].name);
}
