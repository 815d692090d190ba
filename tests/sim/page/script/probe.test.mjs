import assert from "node:assert/strict";
import test from "node:test";
import { colourAt, isIn, moved, reading } from "../../../../sim/page/script/probe.js";

const size = { width: 4, height: 3 };

test("arrow keys move by a pixel, with shift further, and never out of the picture", () => {
  assert.deepEqual(moved({ x: 1, y: 1 }, "ArrowRight", false, size), { x: 2, y: 1 });
  assert.deepEqual(moved({ x: 1, y: 1 }, "ArrowUp", false, size), { x: 1, y: 0 });
  assert.deepEqual(moved({ x: 1, y: 1 }, "ArrowLeft", true, size), { x: 0, y: 1 });
  assert.deepEqual(moved({ x: 3, y: 2 }, "ArrowDown", false, size), { x: 3, y: 2 });
  assert.deepEqual(moved({ x: 1, y: 1 }, "Enter", false, size), { x: 1, y: 1 });
  assert.deepEqual(moved({ x: 9, y: -4 }, "", false, size), { x: 3, y: 0 });
});

test("the zone has its first and not the pixel behind its last", () => {
  const zone = { column: 1, row: 1, width: 2, height: 1 };
  assert.ok(isIn(zone, { x: 1, y: 1 }) && isIn(zone, { x: 2, y: 1 }));
  assert.ok(!isIn(zone, { x: 3, y: 1 }) && !isIn(zone, { x: 1, y: 2 }) && !isIn(zone, { x: 0, y: 1 }));
});

test("a pixel's colour is that of its bytes", () => {
  const bytes = Uint8Array.from({ length: 4 * 4 * 3 }, (_, place) => place);
  assert.deepEqual(colourAt(bytes, 4, { x: 1, y: 2 }), { red: 36, green: 37, blue: 38 });
  const zone = { column: 0, row: 0, width: 1, height: 1 };
  const rows = new Map(reading({ ...size, zone }, bytes, [], { x: 1, y: 2 }));
  assert.equal(rows.get("Pixel"), "column 1, row 2");
  assert.equal(rows.get("Colour"), "red 36, green 37, blue 38 (#242526)");
  assert.match(rows.get("Useful zone"), /outside/);
});

test("within the zone the probe tells every layer, outside none", () => {
  const zone = { column: 1, row: 1, width: 2, height: 2 };
  const layer = { title: "Rays", unit: "rays", is_name: false, names: "", low: 0, high: 5, step: 1,
                  codes: Uint32Array.from([1, 2, 3, 0xffffff]) };
  const bytes = new Uint8Array(48);
  const told = (pixel) => new Map(reading({ ...size, zone }, bytes, [layer], pixel)).get("Rays");
  assert.equal(told({ x: 1, y: 1 }), "1 rays");
  assert.equal(told({ x: 1, y: 2 }), "3 rays");
  assert.equal(told({ x: 2, y: 2 }), "none");
  assert.equal(told({ x: 0, y: 1 }), undefined);
});
