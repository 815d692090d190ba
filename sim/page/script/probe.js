// A pixel of the picture, pointed at or reached by arrow keys: where it is and what is known of it.
import { addLayers, bytesOf, readLayers, toldValue, valueAt } from "#layers";
import { addMonitor } from "#monitor";

const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const fastStep = 16;

// Where a key leads from a pixel, within the picture; the same pixel for other keys.
export function moved(pixel, key, isFast, size) {
  const [x, y] = steps[key] ?? [0, 0];
  const step = isFast ? fastStep : 1;
  const within = (value, count) => Math.min(Math.max(value, 0), count - 1);
  return { x: within(pixel.x + step * x, size.width), y: within(pixel.y + step * y, size.height) };
}

export function isIn(zone, pixel) {
  return pixel.x >= zone.column && pixel.x < zone.column + zone.width &&
         pixel.y >= zone.row && pixel.y < zone.row + zone.height;
}

// The colour of a pixel in the bytes of a picture: red, green, blue, alpha in turn.
export function colourAt(bytes, width, pixel) {
  const place = 4 * (pixel.y * width + pixel.x);
  return { red: bytes[place], green: bytes[place + 1], blue: bytes[place + 2] };
}

// What the probe says of a pixel, of all layers as well where it is in the useful zone.
export function reading(data, bytes, layers, pixel) {
  const colour = colourAt(bytes, data.width, pixel);
  const hex = [colour.red, colour.green, colour.blue]
    .map((value) => value.toString(16).padStart(2, "0")).join("");
  const place = (pixel.y - data.zone.row) * data.zone.width + pixel.x - data.zone.column;
  const known = isIn(data.zone, pixel)
    ? layers.map((layer) => [layer.title, toldValue(layer, valueAt(layer, place))]) : [];
  return [
    ["Pixel", `column ${pixel.x}, row ${pixel.y}`],
    ["Colour", `red ${colour.red}, green ${colour.green}, blue ${colour.blue} (#${hex})`],
    ["Useful zone", isIn(data.zone, pixel) ? "within: a board synthesised it" : "outside: background"],
    ...known,
  ];
}

function cross(canvas, pixel) {
  const pen = canvas.getContext("2d");
  pen.clearRect(0, 0, canvas.width, canvas.height);
  for (const [colour, width] of [["#000000", 3], ["#ffffff", 1]]) {
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.strokeRect(pixel.x - 5.5, pixel.y - 5.5, 12, 12);
  }
}

function show(list, rows, document) {
  list.replaceChildren(...rows.flatMap(([term, meaning]) => {
    const [name, value] = [document.createElement("dt"), document.createElement("dd")];
    name.textContent = term;
    value.textContent = meaning;
    return [name, value];
  }));
}

function addMarker(figure, data, document) {
  const marker = document.createElement("canvas");
  marker.width = data.width;
  marker.height = data.height;
  marker.tabIndex = 0;
  marker.setAttribute("role", "application");
  marker.setAttribute("aria-label", "Probe of the picture: arrow keys move it, with shift by 16 pixels");
  figure.querySelector(".screen").append(marker);
  return marker;
}

function addReading(figure, document) {
  const list = document.createElement("dl");
  list.id = "probe-reading";
  list.setAttribute("aria-live", "polite");
  figure.append(list);
  return list;
}

export async function startProbe(document) {
  const figure = document.getElementById("probe");
  if (figure === null) return;
  const data = JSON.parse(document.getElementById("probe-data").textContent);
  const bytes = await bytesOf(figure.querySelector("img"), document);
  const layers = await readLayers(data.layers, document);
  addLayers(figure, data, layers, document);
  addMonitor(figure, data, document);
  const marker = addMarker(figure, data, document);
  const list = addReading(figure, document);
  let pixel = { x: Math.floor(data.zone.column + data.zone.width / 2),
                y: Math.floor(data.zone.row + data.zone.height / 2) };
  const probe = (next) => {
    pixel = next;
    cross(marker, pixel);
    show(list, reading(data, bytes, layers, pixel), document);
  };
  marker.addEventListener("keydown", (event) => {
    if (!(event.key in steps)) return;
    event.preventDefault();
    probe(moved(pixel, event.key, event.shiftKey, data));
  });
  marker.addEventListener("pointermove", (event) => {
    const frame = marker.getBoundingClientRect();
    probe(moved({ x: Math.floor((event.clientX - frame.left) * data.width / frame.width),
                  y: Math.floor((event.clientY - frame.top) * data.height / frame.height) }, "", false, data));
  });
  probe(moved(pixel, "", false, data));
}
