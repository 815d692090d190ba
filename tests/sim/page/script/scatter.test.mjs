import assert from "node:assert/strict";
import test from "node:test";
import { plottableColumns, scatterOf } from "../../../../sim/page/script/scatter.js";

const headings = ["point", "arbitration", "same", "time_s [s]"];
const rows = [["0", "priority", "4", "1.5"], ["1", "in turn", "4", ""], ["2", "in turn", "4", "2"]];

test("columns of numbers that differ can be plotted", () => {
  assert.deepEqual(plottableColumns(headings, rows), [0, 3]);
});

test("rows that lack a value have no mark", () => {
  const chart = scatterOf(headings, rows, 0, 3, true);
  assert.deepEqual(chart.series[0].points.map(({ x, y }) => [x, y]), [[0, 1.5], [2, 2]]);
  assert.equal(chart.y_title, "time_s [s]");
  assert.ok(chart.logarithmic_x && chart.logarithmic_y);
  assert.equal(chart.series[0].points[1].label, "2 in turn 4");
});
