import assert from "node:assert/strict";
import test from "node:test";
import { firstAxes, plottableColumns, scatterOf } from "../../../../sim/page/script/scatter.js";

const headings = ["point", "arbitration", "same", "time_s [s]"];
const rows = [["0", "priority", "4", "1.5"], ["1", "in turn", "4", ""], ["2", "in turn", "4", "2"]];

test("the frame time is shown first, else an error, never a column over itself", () => {
  assert.deepEqual(firstAxes(["point", "processors", "wait_s", "frame.time_s [s]"], [0, 1, 2, 3]), [1, 3]);
  assert.deepEqual(firstAxes(["ladder", "level", "host_time_s [s]", "repeats", "error"], [2, 3, 4]), [2, 4]);
  assert.deepEqual(firstAxes(["frame_time_s [s]", "other"], [0, 1]), [1, 0]);
  assert.deepEqual(firstAxes(["a", "frame.time_s [s]", "b"], [1, 2]), [1, 2]);
});

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
