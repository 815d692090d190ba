import assert from "node:assert/strict";
import test from "node:test";
import { pairHeight, ways } from "../../../../sim/page/script/monitor.js";

test("as many pairs of lines as the picture has fill its height", () => {
  for (const rows of [1, 72, 575]) assert.ok(Math.abs((rows / 2) * Number.parseFloat(pairHeight(rows)) - 100) < 1e-9);
});

test("the pixels themselves are shown first, and lines only on a monitor", () => {
  assert.equal(ways[0][1], "");
  for (const [, name] of ways) assert.ok(!name.includes("lines") || name.includes("monitor"));
});
