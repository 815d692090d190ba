import assert from "node:assert/strict";
import test from "node:test";
import { codesOf, colourOf, paint, toldValue, valueAt } from "../../../../sim/page/script/layers.js";

const layer = { unit: "s", is_name: false, names: "", low: 2, high: 4, step: 0.5,
                codes: Uint32Array.from([0, 1, 4, 0xffffff]) };

test("the colours of a picture are numbers of 24 bits", () => {
  assert.deepEqual([...codesOf([1, 2, 3, 255, 255, 255, 255, 255])], [0x010203, 0xffffff]);
});

test("a value is as many steps from the lowest as its number says", () => {
  assert.deepEqual([0, 1, 2, 3].map((place) => valueAt(layer, place)), [2, 2.5, 4, null]);
});

test("values are told with units, names by name", () => {
  assert.equal(toldValue(layer, 0.0025), "2.5 ms");
  assert.equal(toldValue(layer, 3.25e-6), "3.25 us");
  assert.equal(toldValue(layer, 0), "0 s");
  assert.equal(toldValue(layer, null), "none");
  assert.equal(toldValue({ ...layer, unit: "rays" }, 7), "7 rays");
  assert.equal(toldValue({ ...layer, unit: "1" }, 0.5), "0.5");
  assert.equal(toldValue({ ...layer, is_name: true, names: "red, blue" }, 1), "blue");
  assert.equal(toldValue({ ...layer, is_name: true }, 9), "9");
});

test("lightness grows along the scale", () => {
  const lightness = ([red, green, blue]) => 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  for (let i = 1; i <= 100; ++i) assert.ok(lightness(colourOf(i / 100)) > lightness(colourOf((i - 1) / 100)));
  assert.deepEqual(colourOf(-1), colourOf(0));
  assert.deepEqual(colourOf(2), colourOf(1));
});

test("a layer is painted from the lowest colour to the highest, grey without a value", () => {
  const bytes = [...paint(layer)];
  assert.deepEqual(bytes.slice(0, 4), [...colourOf(0), 255]);
  assert.deepEqual(bytes.slice(8, 12), [...colourOf(1), 255]);
  assert.deepEqual(bytes.slice(12, 16), [64, 64, 64, 255]);
});
