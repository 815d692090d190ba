// Maps of the pixels as layers over the picture: values from the colours of PNGs, and colours for values.

const noValue = 0xffffff;
// Stops of viridis, which is perceptually uniform (S. van der Walt, N. Smith).
const stops = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129],
               [92, 200, 99], [170, 220, 50], [253, 231, 37]];
const nameColours = [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [184, 134, 11], [86, 180, 233],
                     [240, 228, 66], [120, 120, 120]];

// The 24-bit numbers that the colours of a picture are.
export function codesOf(bytes) {
  return Uint32Array.from({ length: bytes.length / 4 }, (_, place) =>
    (bytes[4 * place] << 16) + (bytes[4 * place + 1] << 8) + bytes[4 * place + 2]);
}

// The value of the pixel at a place in the zone; null where there is none.
export function valueAt(layer, place) {
  const code = layer.codes[place];
  return code === noValue ? null : layer.low + code * layer.step;
}

// A time in a unit in which it has few digits.
function toldTime(seconds) {
  const size = Math.abs(seconds);
  const [factor, unit] = size >= 1 || size === 0 ? [1, "s"] : size >= 1e-3 ? [1e3, "ms"]
    : size >= 1e-6 ? [1e6, "us"] : [1e9, "ns"];
  return `${Number((seconds * factor).toPrecision(6))} ${unit}`;
}

export function toldValue(layer, value) {
  if (value === null) return "none";
  if (layer.is_name) return layer.names === "" ? `${value}` : layer.names.split(", ")[value] ?? `${value}`;
  if (layer.unit === "s") return toldTime(value);
  return `${Number(value.toPrecision(6))} ${layer.unit === "1" ? "" : layer.unit}`.trim();
}

// The colour of a share of the scale, 0 to 1.
export function colourOf(share) {
  const place = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const below = Math.min(Math.floor(place), stops.length - 2);
  return stops[below].map((value, i) => Math.round(value + (place - below) * (stops[below + 1][i] - value)));
}

// The bytes of a picture of the page, which is drawn once where nobody sees it.
export async function bytesOf(image, document) {
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = image.naturalWidth;
  canvas.height = image.naturalHeight;
  const pen = canvas.getContext("2d", { willReadFrequently: true });
  pen.drawImage(image, 0, 0);
  return pen.getImageData(0, 0, canvas.width, canvas.height).data;
}

export async function readLayers(layers, document) {
  return Promise.all(layers.map(async (layer) => {
    const image = document.createElement("img");
    image.src = layer.png;
    return { ...layer, codes: codesOf(await bytesOf(image, document)) };
  }));
}

// The bytes of a layer as a picture; a pixel without a value is grey.
export function paint(layer) {
  const bytes = new Uint8ClampedArray(4 * layer.codes.length);
  const range = layer.high > layer.low ? layer.high - layer.low : 1;
  for (let place = 0; place < layer.codes.length; ++place) {
    const value = valueAt(layer, place);
    const colour = value === null ? [64, 64, 64]
      : layer.is_name ? nameColours[value % nameColours.length] : colourOf((value - layer.low) / range);
    bytes.set([...colour, 255], 4 * place);
  }
  return bytes;
}

function show(canvas, legend, layer, zone, window) {
  const pen = canvas.getContext("2d");
  pen.clearRect(0, 0, canvas.width, canvas.height);
  legend.hidden = layer === undefined;
  if (layer === undefined) return;
  pen.putImageData(new window.ImageData(paint(layer), zone.width, zone.height), zone.column, zone.row);
  const scale = Array.from({ length: 9 }, (_, i) => `rgb(${colourOf(i / 8).join(",")})`).join(",");
  legend.querySelector(".scale").style.background = `linear-gradient(90deg, ${scale})`;
  legend.querySelector(".scale").hidden = layer.is_name;
  const [low, high] = legend.querySelectorAll("span");
  low.textContent = layer.is_name ? `${layer.title}: a colour for each` : `${layer.title}: ${toldValue(layer, layer.low)} `;
  high.textContent = layer.is_name ? "" : ` ${toldValue(layer, layer.high)}`;
}

function legendIn(figure, document) {
  const legend = document.createElement("p");
  legend.hidden = true;
  legend.id = "layer-legend";
  const scale = document.createElement("i");
  scale.className = "scale";
  legend.append(document.createElement("span"), scale, document.createElement("span"));
  figure.append(legend);
  return legend;
}

// Lets the reader choose what lies over the picture; nothing without layers.
export function addLayers(figure, data, layers, document) {
  if (layers.length === 0) return;
  const canvas = document.createElement("canvas");
  canvas.className = "layer";
  canvas.width = data.width;
  canvas.height = data.height;
  figure.querySelector(".screen").append(canvas);
  const label = document.createElement("label");
  label.className = "controls";
  const choice = document.createElement("select");
  choice.id = "layer";
  for (const title of ["the picture", ...layers.map((layer) => layer.title)]) {
    choice.append(new document.defaultView.Option(title));
  }
  label.append("Show ", choice);
  figure.prepend(label);
  const legend = legendIn(figure, document);
  choice.addEventListener("change", () =>
    show(canvas, legend, layers[choice.selectedIndex - 1], data.zone, document.defaultView));
}
