// The picture as a monitor of 1984 shows it: 4:3 whatever its pixels are, a field of every other line at a time.

export const ways = [["the pixels", ""], ["as on a monitor, 4:3", "monitor"], ["4:3, the lines of one field", "monitor lines"]];

// A line that is shown and one that is not, in shares of the height of the picture, as CSS has it.
export function pairHeight(rows) {
  return `${200 / rows}%`;
}

export function addMonitor(figure, data, document) {
  const screen = figure.querySelector(".screen");
  const label = document.createElement("label");
  label.className = "controls";
  const choice = document.createElement("select");
  choice.id = "monitor";
  for (const [name] of ways) choice.append(new document.defaultView.Option(name));
  label.append("Shape ", choice);
  const lines = document.createElement("div");
  lines.className = "scan";
  lines.style.backgroundSize = `100% ${pairHeight(data.height)}`;
  screen.append(lines);
  choice.addEventListener("change", () => {
    screen.className = `screen ${ways[choice.selectedIndex][1]}`.trim();
  });
  figure.prepend(label);
}
