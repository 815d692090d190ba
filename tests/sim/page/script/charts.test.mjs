import assert from "node:assert/strict";
import test from "node:test";
import { colours, configuration, heightOf, zoomed } from "../../../../sim/page/script/charts.js";

const bars = {
  kind: "bars", x_title: "s", y_title: "", logarithmic_x: false, logarithmic_y: false,
  labels: ["board0", "board1"],
  series: [{ name: "compute", values: [3, 4], points: [] }, { name: "idle", values: [1, 0], points: [] }],
};
const marks = {
  kind: "scatter", x_title: "a", y_title: "b", logarithmic_x: true, logarithmic_y: false, labels: [],
  series: [{ name: "all", values: [], points: [{ x: 1, y: 2, label: "first" }] }],
};
const plain = (colour, index) => `${colour} ${index}`;

test("bars of several series are stacked along the labels", () => {
  const chart = configuration(bars, colours(false), plain);
  assert.equal(chart.type, "bar");
  assert.equal(chart.options.indexAxis, "y");
  assert.equal(chart.options.scales.y.type, "category");
  assert.equal(chart.options.scales.x.type, "linear");
  assert.ok(chart.options.scales.x.stacked);
  assert.deepEqual(chart.data.datasets.map((series) => series.data), [[3, 4], [1, 0]]);
  assert.ok(chart.options.plugins.legend.display);
});

test("one series needs no legend", () => {
  const chart = configuration({ ...bars, series: bars.series.slice(0, 1) }, colours(false), plain);
  assert.ok(!chart.options.plugins.legend.display);
  assert.ok(!chart.options.scales.x.stacked);
});

test("scattered marks have logarithmic axes where the page says so, and are called by name", () => {
  const chart = configuration(marks, colours(true), plain);
  assert.equal(chart.type, "scatter");
  assert.equal(chart.options.scales.x.type, "logarithmic");
  assert.equal(chart.options.scales.y.type, "linear");
  const label = chart.options.plugins.tooltip.callbacks.label;
  assert.equal(label({ raw: marks.series[0].points[0], dataset: {} }), "first: 1, 2");
  assert.equal(label({ raw: 3, dataset: { label: "compute" } }), "compute: 3");
});

test("series differ in colour, filling and mark", () => {
  const { datasets } = configuration(bars, colours(false), plain).data;
  assert.notEqual(datasets[0].backgroundColor, datasets[1].backgroundColor);
  assert.notEqual(datasets[0].borderColor, datasets[1].borderColor);
  assert.notEqual(datasets[0].pointStyle, datasets[1].pointStyle);
});

test("more bars take more room", () => {
  assert.ok(heightOf(bars) < heightOf({ ...bars, labels: ["a", "b", "c"] }));
  assert.ok(heightOf(marks) > 0);
});

test("two sliders leave a part of an axis, in either order, and never nothing", () => {
  assert.deepEqual(zoomed(10, 20, 0, 1), { min: 10, max: 20 });
  assert.deepEqual(zoomed(10, 20, 0.5, 0.25), { min: 12.5, max: 15 });
  const least = zoomed(10, 20, 0.5, 0.5);
  assert.ok(least.max > least.min);
});
