import assert from "node:assert/strict";
import test from "node:test";
import { compareTexts, matches, quantity, sortedOrder } from "../../../../sim/page/script/tables.js";

const near = (first, second) => Math.abs(first - second) <= 1e-12 * Math.abs(second);

test("quantities are read with their units", () => {
  assert.ok(near(quantity("7 min 20.4 s"), 440.4));
  assert.ok(near(quantity("8.75 us"), 8.75e-6));
  assert.ok(near(quantity("35.33 %"), 0.3533));
  assert.ok(near(quantity("-1e-9"), -1e-9));
  assert.ok(near(quantity("128 KiB"), 131072));
  for (const text of ["", "board0", "1.2.3", "7 of 9", "a 3"]) assert.equal(quantity(text), null, text);
});

test("numbers go by value and before texts, and what is empty goes last", () => {
  const sorted = ["b", "10", "", "9", "1 ms", "a", "2 us"].sort(compareTexts);
  assert.deepEqual(sorted, ["2 us", "1 ms", "9", "10", "a", "b", ""]);
});

test("sorting keeps equal rows in their order, both ways", () => {
  const rows = [["a", "2"], ["b", "1"], ["c", "2"], ["d", "10"]];
  assert.deepEqual(sortedOrder(rows, 1, true), [1, 0, 2, 3]);
  assert.deepEqual(sortedOrder(rows, 1, false), [3, 0, 2, 1]);
});

test("sorting is a permutation that holds the order, for many random columns", () => {
  let seed = 5;
  const random = (count) => {
    seed = (seed * 48271) % 2147483647;
    return seed % count;
  };
  for (let round = 0; round < 200; ++round) {
    const rows = Array.from({ length: random(30) }, () => [String(random(20) - 10)]);
    const order = sortedOrder(rows, 0, true);
    assert.deepEqual([...order].sort((a, b) => a - b), rows.map((_, place) => place));
    for (let i = 1; i < order.length; ++i) {
      assert.ok(Number(rows[order[i - 1]][0]) <= Number(rows[order[i]][0]));
    }
  }
});

test("a filter wants every word, and a column's whole value where it names one", () => {
  const headings = ["point", "processors", "frame.time_s [s]"];
  const cells = ["3", "16", "110.5"];
  assert.ok(matches(cells, headings, ""));
  assert.ok(matches(cells, headings, "processors=16"));
  assert.ok(!matches(cells, headings, "processors=1"));
  assert.ok(matches(cells, headings, "110 16"));
  assert.ok(!matches(cells, headings, "110 17"));
});
