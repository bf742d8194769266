"use strict";
// A section whose sliders move drawings: its form, what its sliders say, and panels with a grid in which curves are drawn.
const slidersOf = (section) => {
  const SVG = "http://www.w3.org/2000/svg";
  section.replaceChildren(document.getElementById("explorable-tools").content.cloneNode(true));
  const form = section.querySelector("form");
  const sliders = [...form.querySelectorAll("input[type=range]")];

  const valueOf = (slider) => (slider.dataset.logarithmic ? 10 ** Number(slider.value) : Number(slider.value));
  const written = (value, digits = 3) => Number(value.toPrecision(digits)).toLocaleString("en-GB", { maximumSignificantDigits: digits, useGrouping: false });
  const draw = (name, attributes) => {
    const element = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return element;
  };

  // A panel maps its limits to its box; curves outside are cut off by the nested svg.
  const frame = (svg, [left, right, bottom, top]) => {
    const box = { x: 46, y: 8, width: 300, height: 208 };
    const place = ([x, y]) => [(x - left) / (right - left) * box.width, (top - y) / (top - bottom) * box.height];
    const ticks = (first, last) => {
      const rough = (last - first) / 5;
      const power = 10 ** Math.floor(Math.log10(rough));
      const step = power * [1, 2, 5, 10].find((each) => each * power >= rough);
      return Array.from({ length: Math.floor(last / step) - Math.ceil(first / step) + 1 }, (_, i) => (Math.ceil(first / step) + i) * step);
    };
    const grid = draw("g", { class: "grid" });
    for (const x of ticks(left, right)) {
      const at = box.x + place([x, 0])[0];
      grid.append(draw("path", { d: `M${at},${box.y}v${box.height}` }));
      grid.append(Object.assign(draw("text", { x: at, y: box.y + box.height + 15, class: "middle" }), { textContent: written(x).replace("-", "−") }));
    }
    for (const y of ticks(bottom, top)) {
      const at = box.y + place([0, y])[1];
      grid.append(draw("path", { d: `M${box.x},${at}h${box.width}` }));
      grid.append(Object.assign(draw("text", { x: box.x - 6, y: at + 4, class: "end" }), { textContent: written(y).replace("-", "−") }));
    }
    const inner = draw("svg", { x: box.x, y: box.y, width: box.width, height: box.height, overflow: "hidden" });
    svg.replaceChildren(grid, inner);
    return { inner, place };
  };

  const path = (within, points, name) => draw("path", {
    class: name,
    d: points.map((point, i) => `${i ? "L" : "M"}${within.place(point).map((each) => each.toFixed(2)).join(",")}`).join(""),
  });

  // Each slider says its value; then all is shown that follows.
  const follow = (show) => {
    const moved = () => {
      for (const slider of sliders) {
        const text = `${written(valueOf(slider) * Number(slider.dataset.factor))} ${slider.dataset.unit}`.trim();
        slider.nextElementSibling.textContent = text;
        slider.setAttribute("aria-valuetext", text);
      }
      show(sliders.map(valueOf));
    };
    form.addEventListener("input", moved);
    form.addEventListener("reset", () => setTimeout(moved));
    form.addEventListener("submit", (event) => event.preventDefault());
    moved();
  };
  return { sliders, result: section.querySelector("output.cycles"), panels: [...section.querySelectorAll("svg")], written, draw, frame, path, follow };
};
