"use strict";
// Zoom and read-out of figures. A drawing names its axes in data-axes: boxes in the units of its viewBox, with limits,
// scale and label of x and y, curves as rows of (x, y, value along the curve), and the peaks of spectra.
{
  const REACH = 14; // how near the pointer has to be to a curve, in units of the viewBox
  const PEAK_REACH = 22; // and to a peak, which is met first
  const BESIDE = 4; // or how near to the line below it
  const SVG = "http://www.w3.org/2000/svg";
  const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

  // As many digits as a step of one unit of the viewBox tells apart.
  const written = (value, step) => {
    const digits = Math.ceil(Math.log10(Math.max(Math.abs(value), step) / step)) + 1;
    const text = Math.abs(value) < step / 2 ? "0" : value.toPrecision(clamp(digits, 2, 8));
    return text.includes("e") ? String(Number(text)).replace("e", " × 10^") : text.replace("-", "−");
  };

  const named = ({ label }, text) => {
    const [, name, unit] = label.match(/^(.*?)\s*(?:\[(.+)\])?$/);
    return `${name}${name ? " = " : ""}${text}${unit ? ` ${unit}` : ""}`;
  };

  const readAxes = (figure, panel, { x, y }) => {
    const [left, top, width, height] = panel.axes.box;
    const shares = { x: [(x - left) / width, 1 / width], y: [(top + height - y) / height, 1 / height] };
    return ["x", "y"].filter((direction) => panel.axes[direction].label).map((direction) => {
      const [share, unit] = shares[direction];
      const value = figure.valueAt(panel, direction, share);
      return named(panel.axes[direction], written(value, Math.abs(figure.valueAt(panel, direction, share + unit) - value)));
    }).join(", ");
  };

  // The nearest place on the curves of the axes, or nothing if none is near.
  const nearest = (panel, curves, point) => {
    let best = { distance: REACH };
    for (const curve of curves) {
      const { points } = curve;
      for (let i = 0; i + 5 < points.length; i += 3) {
        const start = panel.toShown({ x: points[i], y: points[i + 1] });
        const end = panel.toShown({ x: points[i + 3], y: points[i + 4] });
        const [value, nextValue] = [points[i + 2], points[i + 5]];
        const [dx, dy] = [end.x - start.x, end.y - start.y];
        const share = clamp(((point.x - start.x) * dx + (point.y - start.y) * dy) / (dx * dx + dy * dy || 1), 0, 1);
        const place = { x: start.x + share * dx, y: start.y + share * dy };
        const distance = Math.hypot(place.x - point.x, place.y - point.y);
        if (distance < best.distance && panel.contains(place)) {
          best = { distance, place, curve, value: value === null ? null : value + share * (nextValue - value) };
        }
      }
    }
    return best.place && best;
  };

  // The peak that is meant: the nearest one, or the one above the pointer.
  const peakNear = (panel, point) => {
    const places = panel.axes.peaks.map(([x, y]) => panel.toShown({ x, y })).filter(panel.contains);
    const far = ({ x, y }) => (Math.abs(x - point.x) <= BESIDE && y <= point.y ? Math.abs(x - point.x)
      : Math.hypot(x - point.x, y - point.y));
    const place = places.toSorted((one, other) => far(one) - far(other))[0];
    return place && far(place) <= PEAK_REACH ? { place, value: null, isPeak: true } : undefined;
  };

  const readCurve = ({ curve, value }) => {
    const number = Number(value.toPrecision(5));
    const hertz = curve.unit === "rad/s" ? ` (${Number((value / (2 * Math.PI)).toPrecision(5))} Hz)` : "";
    return `${curve.name ? `${curve.name}: ` : ""}${curve.quantity} = ${number} ${curve.unit}${hertz}`;
  };

  // Lines that the drawing gives no values for are read from their paths.
  const drawnLines = (svg, panel) => {
    const group = svg.querySelector(`[id$="-${panel.axes.name}"]`);
    const paths = [...group.querySelectorAll("g[id*=line2d] path")].filter((path) => !path.closest("defs, [id*='tick_']"));
    return paths.map((path) => {
      const numbers = path.getAttribute("d").match(/-?\d+(\.\d+)?/g)?.map(Number) ?? [];
      const points = [];
      for (let i = 0; i + 1 < numbers.length; i += 2) points.push(numbers[i], numbers[i + 1], null);
      return { points };
    });
  };

  const interactive = (paper, svg) => {
    const described = JSON.parse(svg.dataset.axes);
    const figure = zoomOf(svg, described);
    const lines = new Map();
    const { x: left, y: top, width, height } = svg.viewBox.baseVal;
    let point = { x: left + width / 2, y: top + height / 2 };

    paper.after(document.getElementById("figure-tools").content.cloneNode(true));
    const tools = paper.nextElementSibling;
    const output = tools.querySelector("output");
    const cross = document.createElementNS(SVG, "path");
    cross.setAttribute("class", "cross");
    const ring = document.createElementNS(SVG, "circle");
    ring.setAttribute("class", "ring");
    svg.append(cross, ring);

    const pointed = () => figure.panels.find((panel) => panel.contains(point));
    const near = (panel) => {
      const found = peakNear(panel, point) ?? nearest(panel, panel.axes.curves, point);
      if (found) return found;
      if (!lines.has(panel)) lines.set(panel, drawnLines(svg, panel));
      return nearest(panel, lines.get(panel), point);
    };
    const read = () => {
      const panel = pointed();
      const met = panel && near(panel);
      const at = met?.place ?? point;
      const arm = panel ? 5 : 0;
      cross.setAttribute("d", `M${point.x - arm},${point.y}h${2 * arm}M${point.x},${point.y - arm}v${2 * arm}`);
      ring.setAttribute("r", met ? 3.5 : 0);
      ring.setAttribute("cx", at.x);
      ring.setAttribute("cy", at.y);
      output.textContent = panel
        ? [(met?.isPeak ? "peak: " : "") + readAxes(figure, panel, at), met && met.value !== null && readCurve(met)]
          .filter(Boolean).join("; ")
        : "outside of the axes";
    };
    const look = () => {
      paper.classList.toggle("zoomed", !figure.isWhole());
      read();
    };
    // Zooming by a button or key keeps what is read in place, or else the middle of the first axes.
    const zoom = (factor, at = point) => {
      if (factor === 0) figure.whole(); else {
        const panel = figure.panels.find((each) => each.contains(at));
        const [x, y, across, down] = (panel ?? figure.panels[0]).axes.box;
        figure.zoom(panel ?? figure.panels[0], factor, panel ? at : { x: x + across / 2, y: y + down / 2 });
      }
      look();
    };
    const placed = (event) => new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());

    let held;
    svg.addEventListener("pointerdown", (event) => {
      point = placed(event);
      if (!figure.isWhole() && pointed()) {
        held = pointed();
        svg.setPointerCapture(event.pointerId);
      }
    });
    svg.addEventListener("pointerup", () => { held = undefined; });
    svg.addEventListener("pointercancel", () => { held = undefined; });
    svg.addEventListener("pointermove", (event) => {
      output.removeAttribute("aria-live");
      const before = point;
      point = placed(event);
      if (held) figure.move(held, before.x - point.x, point.y - before.y);
      read();
    });
    svg.addEventListener("click", (event) => { point = placed(event); read(); });
    svg.addEventListener("mousedown", (event) => { if (event.detail > 1) event.preventDefault(); }); // or it selects text
    svg.addEventListener("dblclick", (event) => { point = placed(event); zoom(2); });
    svg.addEventListener("wheel", (event) => {
      if (!event.ctrlKey) return; // without it, the wheel scrolls the page
      event.preventDefault();
      point = placed(event);
      zoom(event.deltaY < 0 ? 1.25 : 0.8);
    }, { passive: false });

    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const factors = { "+": 1.5, "=": 1.5, "-": 1 / 1.5, 0: 0 };
    // Where the part ends at which one looks, the keys move the part.
    const step = ([across, down], size) => {
      const panel = pointed();
      const next = { x: clamp(point.x + across * size, left, left + width), y: clamp(point.y + down * size, top, top + height) };
      if (panel && !panel.isWhole() && !panel.contains(next)) figure.move(panel, across * size, -down * size);
      else point = next;
    };
    paper.addEventListener("keydown", (event) => {
      if (event.key in arrows) step(arrows[event.key], (event.shiftKey ? 0.1 : 0.01) * width);
      else if (event.key in factors) zoom(factors[event.key]);
      else return;
      event.preventDefault();
      output.setAttribute("aria-live", "polite");
      read();
    });
    tools.addEventListener("click", (event) => {
      const factor = { in: 1.5, out: 1 / 1.5, whole: 0 }[event.target.name];
      if (factor !== undefined) zoom(factor);
    });
  };

  for (const paper of document.querySelectorAll(".drawing .paper")) {
    const svg = paper.querySelector("svg[data-axes]");
    if (svg) interactive(paper, svg);
  }
}
