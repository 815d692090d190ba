import assert from "node:assert/strict";
import test from "node:test";
import { colours } from "../../../../sim/page/script/charts.js";
import { axesOf, firstAxesOf, isWithin, parallelOf, shareOn, summaryOf } from "../../../../sim/page/script/parallel.js";

const headings = ["point", "processors", "bus.arbitration", "status", "frame.time_s [s]", "same", "bus.wait_mean_s [s]"];
const rows = [["0", "1", "priority", "done", "4", "7", "0.5"], ["1", "2", "in turn", "done", "2", "7", ""],
              ["2", "4", "priority", "failed", "", "7", "1"]];
const axes = axesOf(headings, rows);

test("columns that differ are axes, of numbers or of names, the number of a row is none", () => {
  assert.deepEqual(axes.map(({ heading }) => heading),
                   ["processors", "bus.arbitration", "status", "frame.time_s [s]", "bus.wait_mean_s [s]"]);
  assert.deepEqual(axes[1].names, ["priority", "in turn"]);
});

test("what was varied is shown first, and what usually matters", () => {
  assert.deepEqual(firstAxesOf(axes, headings).map(({ column }) => column), [1, 2, 4, 6]);
});

test("a column of many names is no axis", () => {
  const many = Array.from({ length: 13 }, (_, row) => [`${row}`, `name ${row}`]);
  assert.deepEqual(axesOf(["point", "machine"], many), []);
});

test("shares run from the lowest to the highest, and nothing is nowhere", () => {
  assert.deepEqual(rows.map((row) => shareOn(axes[0], row)), [0, 1 / 3, 1]);
  assert.deepEqual(rows.map((row) => shareOn(axes[1], row)), [0, 1, 0]);
  assert.equal(shareOn(axes[3], rows[2]), null);
});

test("ranges leave what lies between them, in either order, and the whole leaves all", () => {
  const range = (axis, from, to) => ({ axis, from, to });
  const left = (...ranges) => rows.filter((row) => isWithin(ranges, row)).map((row) => row[0]);
  assert.deepEqual(left(range(axes[0], 0, 1), range(axes[3], 0, 1)), ["0", "1", "2"]);
  assert.deepEqual(left(range(axes[0], 0.4, 0)), ["0", "1"]);
  assert.deepEqual(left(range(axes[0], 0, 0.4), range(axes[1], 1, 1)), ["1"]);
  assert.deepEqual(left(range(axes[3], 0, 0.9)), ["1"]);
});

test("every row is a line that a gap breaks; hidden ones are thin, the chosen one is thick", () => {
  const look = (place) => ({ isHidden: place === 2, isChosen: place === 1 });
  const { data } = parallelOf([axes[0], axes[3]], rows, look, colours(false));
  assert.deepEqual(data.datasets.map((line) => line.data), [[0, 1], [1 / 3, 0], [1, null]]);
  const [plain, chosen, hidden] = data.datasets.map((line) => line.borderWidth);
  assert.ok(hidden < plain && plain < chosen);
});

test("the words say how many points, which columns and their ends", () => {
  const said = summaryOf([axes[0], axes[1]], 2, 3);
  for (const part of ["2 of 3 points", "processors from 1 to 4", "bus.arbitration from priority to in turn"]) {
    assert.ok(said.includes(part), said);
  }
});
