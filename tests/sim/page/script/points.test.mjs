import assert from "node:assert/strict";
import test from "node:test";
import { commandOf, factsOf, titleOf } from "../../../../sim/page/script/points.js";
import { withChoice } from "../../../../sim/page/script/scatter.js";
import { hide } from "../../../../sim/page/script/tables.js";

const headings = ["point", "processors", "bus.arbitration", "status", "reason", "frame.time_s [s]", "units [1]"];

test("a row tells what is varied, how it ended, and what came of it", () => {
  const facts = factsOf(headings, ["3", "4", "priority", "done", "", "440.2", ""]);
  assert.deepEqual(facts.varied, [["processors", "4"], ["bus.arbitration", "priority"]]);
  assert.deepEqual([facts.name, facts.status, facts.reason], ["3", "done", ""]);
  assert.deepEqual(facts.results, [["frame.time_s [s]", "440.2"]]);
  assert.equal(titleOf(facts), "3: processors 4, bus.arbitration priority");
});

test("a failed point has a reason and no results", () => {
  const facts = factsOf(headings, ["0", "256", "priority", "failed", "no place", "", ""]);
  assert.deepEqual([facts.status, facts.reason, facts.results], ["failed", "no place", []]);
});

test("the command names the point wherever it needs to", () => {
  assert.equal(commandOf("run --point POINT --outdir point-POINT", "12"), "run --point 12 --outdir point-12");
});

test("a click on a mark chooses its point, beside one nothing, and the chosen mark is larger", () => {
  const chosen = [];
  const points = [{ name: "0" }, { name: "7" }];
  const made = withChoice({ data: { datasets: [{}] }, options: {} }, points, "7", (name) => chosen.push(name));
  made.options.onClick({}, []);
  made.options.onClick({}, [{ index: 1 }]);
  assert.deepEqual(chosen, ["7"]);
  const [first, second] = made.data.datasets[0].pointRadius;
  assert.ok(second > first);
});

test("a row is shown again when no reason hides it", () => {
  const row = { dataset: {}, hidden: false };
  hide(row, "words", true);
  hide(row, "range", true);
  hide(row, "words", false);
  assert.equal(row.hidden, true);
  hide(row, "range", false);
  assert.equal(row.hidden, false);
});
