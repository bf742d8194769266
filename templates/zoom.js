"use strict";
// Zoom of a drawing: each of its axes shows a part of what it holds. Frame, labels and sizes of texts and symbols stay
// as they are, and the numbers at the axes become those of the part. Axes that share a range are zoomed together.
const zoomOf = (() => {
  const SVG = "http://www.w3.org/2000/svg";
  const LARGEST = 40; // beyond it, a curve shows how coarsely it was drawn
  const SHORT = 24; // an arrow up to this length, in units of the viewBox, keeps its shape
  const WHOLE = { from: 0, to: 1 };
  const TOKEN = /[a-z]|-?[\d.]+(?:e[-+]?\d+)?/gi;
  const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

  const valueAt = ({ limits: [low, high], scale }, share) =>
    (scale === "log" ? low * (high / low) ** share : low + (high - low) * share);
  const shareOf = ({ limits: [low, high], scale }, value) =>
    (scale === "log" ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low));

  const raised = (exponent) => String(exponent).replace(/./g, (sign) => "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"["0123456789-".indexOf(sign)]);

  // Round values of an axis between two shares of it, some five of them, each with its text.
  const ticks = (axis, { from, to }) => {
    const [low, high] = [valueAt(axis, from), valueAt(axis, to)];
    const decades = axis.scale === "log" ? Math.log10(high / low) : 0;
    if (decades > 1.5) {
      const step = Math.ceil(decades / 5);
      const first = Math.ceil(Math.log10(low) / step) * step;
      const powers = Array.from({ length: Math.floor((Math.log10(high) - first) / step) + 1 }, (_, k) => first + k * step);
      return powers.map((power) => ({ value: 10 ** power, text: `10${raised(power)}` }));
    }
    const rough = Math.abs(high - low) / 6;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = power * [1, 2, 5, 10].find((factor) => factor * power >= rough);
    const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    const first = Math.ceil(Math.min(low, high) / step - 1e-9);
    const last = Math.floor(Math.max(low, high) / step + 1e-9);
    return Array.from({ length: last - first + 1 }, (_, k) => {
      const value = (first + k) * step;
      const text = Math.abs(value) >= 1e5 || (digits > 5) ? value.toExponential().replace("e", "·10^") : value.toFixed(digits);
      return { value, text: text.replace(/-/g, "−") };
    });
  };

  const made = (name, attributes, text = "") => {
    const element = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.textContent = text;
    return element;
  };

  // One pair of axes: what is drawn in it, and the part that is seen.
  const panel = (svg, axes, ranges) => {
    const group = svg.querySelector(`[id$="-${axes.name}"]`);
    const [left, top, width, height] = axes.box;
    const bottom = top + height;
    const locked = { x: axes.x.label === "", y: axes.y.label === "" };
    const range = (direction) => ranges[direction].get(axes[direction].shared);
    const factor = (direction) => 1 / (range(direction).to - range(direction).from);
    const toShown = ({ x, y }) => ({
      x: left + ((x - left) / width - range("x").from) * factor("x") * width,
      y: bottom - ((bottom - y) / height - range("y").from) * factor("y") * height,
    });
    const toWhole = ({ x, y }) => ({
      x: left + (range("x").from + (x - left) / width / factor("x")) * width,
      y: bottom - (range("y").from + (bottom - y) / height / factor("y")) * height,
    });
    const contains = ({ x, y }) => x >= left - 0.5 && x <= left + width + 0.5 && y >= top - 0.5 && y <= bottom + 0.5;
    const isTick = (element) => element.closest("[id*='tick_']");

    // What is clipped to the axes is wrapped, so that it moves behind its window; symbols move without growing.
    let parts;
    const wrapped = () => [...group.querySelectorAll("[clip-path]")].filter((element) => !isTick(element)).map((element) => {
      const frame = made("g", { "clip-path": element.getAttribute("clip-path") });
      element.replaceWith(frame);
      element.removeAttribute("clip-path");
      frame.append(element);
      const uses = [...element.querySelectorAll("use")];
      const symbols = uses.filter((use) => use.getAttribute("x") !== "0").map((use) => ({
        use, place: { x: Number(use.getAttribute("x")), y: Number(use.getAttribute("y")) },
      }));
      return { element, symbols, tokens: element.localName === "path" ? element.getAttribute("d").match(TOKEN) : [] };
    });
    // The line of a path is written anew, so that neither its width nor its dashes grow.
    const redrawn = (tokens) => {
      const written = [];
      let x;
      for (const token of tokens) {
        if (/[a-z]/i.test(token)) written.push(token);
        else if (x === undefined) x = Number(token);
        else {
          const shown = toShown({ x, y: Number(token) });
          written.push(shown.x.toFixed(2), shown.y.toFixed(2));
          x = undefined;
        }
      }
      return written.join(" ");
    };
    const placed = () => axes.placed.map(([name, ...places]) => ({
      places, elements: [...group.querySelectorAll(`[id$="-${name}"], [id$="-${name}_arrow"]`)],
    }));

    const moveTexts = () => {
      for (const { places, elements } of parts.placed) {
        const [before, other] = places.map(([x, y]) => ({ x: x ?? left, y: y ?? top }));
        const after = toShown(before);
        const [across, up] = places[0].map((each, k) => (each === null ? 0 : k ? after.y - before.y : after.x - before.x));
        const isLong = other && Math.hypot(other.x - before.x, other.y - before.y) > SHORT;
        for (const element of elements) {
          element.setAttribute("transform", isLong ? affine() : `translate(${across} ${up})`);
          element.style.visibility = contains({ x: before.x + across, y: before.y + up }) || isLong ? "" : "hidden";
        }
      }
    };
    const affine = () => {
      const origin = toShown({ x: 0, y: 0 });
      return `matrix(${factor("x")} 0 0 ${factor("y")} ${origin.x} ${origin.y})`;
    };

    const numbers = (direction) => {
      const axis = axes[direction];
      const old = [...group.querySelectorAll(`[id*="-${direction}tick_"]`)];
      const isNumbered = old.some((tick) => tick.querySelector("[id*='text_']"));
      return ticks(axis, range(direction)).map(({ value, text }) => {
        const share = (shareOf(axis, value) - range(direction).from) * factor(direction);
        const [x, y] = direction === "x" ? [left + share * width, bottom] : [left, bottom - share * height];
        const grid = direction === "x" ? `M${x},${bottom}V${top}` : `M${left},${y}H${left + width}`;
        const mark = direction === "x" ? `M${x},${bottom}v3.5` : `M${left},${y}h-3.5`;
        const place = direction === "x" ? { x, y: y + 13, "text-anchor": "middle" } : { x: x - 6, y: y + 3, "text-anchor": "end" };
        return [made("path", { d: grid, class: "zoom-grid" }), made("path", { d: mark, class: "zoom-tick" }),
          ...(isNumbered ? [made("text", { ...place, class: "zoom-number" }, text)] : [])];
      }).flat();
    };

    const isWhole = () => factor("x") === 1 && factor("y") === 1;
    const show = () => {
      if (isWhole() && !parts) return;
      parts ??= { wrapped: wrapped(), placed: placed(), ticks: group.insertBefore(made("g", {}), group.children[1]) };
      for (const { element, symbols, tokens } of parts.wrapped) {
        if (tokens.length > 0) element.setAttribute("d", redrawn(tokens));
        else if (symbols.length === 0) element.setAttribute("transform", affine());
        for (const { use, place } of symbols) {
          const { x, y } = toShown(place);
          use.setAttribute("x", x);
          use.setAttribute("y", y);
        }
      }
      moveTexts();
      const changed = ["x", "y"].filter((direction) => factor(direction) !== 1);
      parts.ticks.replaceChildren(...changed.flatMap(numbers));
      for (const direction of ["x", "y"]) {
        const isChanged = changed.includes(direction);
        const own = `[id*="-${direction}tick_"]`;
        for (const axis of group.querySelectorAll("[id*='-matplotlib.axis_']")) {
          if (!axis.querySelector(own)) continue;
          for (const part of axis.children) {
            if (!/-label_/.test(part.id)) part.style.visibility = isChanged ? "hidden" : "";
          }
        }
      }
    };
    return { axes, contains, toShown, toWhole, show, isWhole, range, factor, locked };
  };

  return (svg, described) => {
    const ranges = { x: new Map(), y: new Map() };
    for (const axes of described) {
      for (const direction of ["x", "y"]) ranges[direction].set(axes[direction].shared, { ...WHOLE });
    }
    const panels = described.map((axes) => panel(svg, axes, ranges));
    const show = () => { for (const each of panels) each.show(); };
    const set = (one, direction, from, size) => {
      if (one.locked[direction]) return;
      const start = clamp(from, 0, 1 - size);
      Object.assign(one.range(direction), size >= 1 ? WHOLE : { from: start, to: start + size });
    };
    const sized = (one, direction) => one.range(direction).to - one.range(direction).from;
    return {
      panels,
      isWhole: () => panels.every((each) => each.isWhole()),
      // Zoom one of the axes by a factor; the place, in units of the viewBox, stays where it is.
      zoom(one, factor, at) {
        const [left, top, width, height] = one.axes.box;
        const whole = one.toWhole(at);
        const shares = { x: (whole.x - left) / width, y: (top + height - whole.y) / height };
        for (const direction of ["x", "y"]) {
          const size = clamp(sized(one, direction) / factor, 1 / LARGEST, 1);
          const { from } = one.range(direction);
          set(one, direction, shares[direction] - (shares[direction] - from) * size / sized(one, direction), size);
        }
        show();
      },
      // Move what is seen, by distances in units of the viewBox.
      move(one, across, up) {
        const [, , width, height] = one.axes.box;
        set(one, "x", one.range("x").from + across / width * sized(one, "x"), sized(one, "x"));
        set(one, "y", one.range("y").from + up / height * sized(one, "y"), sized(one, "y"));
        show();
      },
      whole() {
        for (const each of panels) for (const direction of ["x", "y"]) set(each, direction, 0, 1);
        show();
      },
      valueAt: ({ axes, range }, direction, share) =>
        valueAt(axes[direction], range(direction).from + share * (range(direction).to - range(direction).from)),
    };
  };
})();
