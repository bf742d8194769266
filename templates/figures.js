"use strict";
// Zoom and read-out of figures. A drawing names its axes in data-axes: boxes in the units of its viewBox, with limits,
// scale and label of x and y, and curves as rows of (x, y, value along the curve).
{
  const REACH = 14; // how near the pointer has to be to a curve, in units of the viewBox
  const SVG = "http://www.w3.org/2000/svg";
  const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

  const valueAt = ({ limits: [low, high], scale }, share) =>
    (scale === "log" ? low * (high / low) ** share : low + (high - low) * share);

  // As many digits as a step of one unit of the viewBox tells apart.
  const written = (axis, share, size) => {
    const value = valueAt(axis, share);
    const step = Math.abs(valueAt(axis, share + 1 / size) - value);
    const digits = Math.ceil(Math.log10(Math.max(Math.abs(value), step) / step)) + 1;
    const text = Math.abs(value) < step / 2 ? "0" : value.toPrecision(clamp(digits, 2, 8));
    return text.includes("e") ? String(Number(text)).replace("e", " × 10^") : text.replace("-", "−");
  };

  const named = ({ label }, text) => {
    const [, name, unit] = label.match(/^(.*?)\s*(?:\[(.+)\])?$/);
    return `${name}${name ? " = " : ""}${text}${unit ? ` ${unit}` : ""}`;
  };

  const readAxes = ({ box: [left, top, width, height], x, y }, point) => [
    named(x, written(x, (point.x - left) / width, width)),
    named(y, written(y, (top + height - point.y) / height, height)),
  ].join(", ");

  const contains = ({ box: [left, top, width, height] }, { x, y }) =>
    x >= left && x <= left + width && y >= top && y <= top + height;

  // The nearest place on the curves of the axes, or nothing if none is near.
  const nearest = (curves, point, reach) => {
    let best = { distance: reach };
    for (const curve of curves) {
      const { points } = curve;
      for (let i = 0; i + 5 < points.length; i += 3) {
        const [x, y, value, nextX, nextY, nextValue] = points.slice(i, i + 6);
        const [dx, dy] = [nextX - x, nextY - y];
        const share = clamp(((point.x - x) * dx + (point.y - y) * dy) / (dx * dx + dy * dy || 1), 0, 1);
        const place = { x: x + share * dx, y: y + share * dy };
        const distance = Math.hypot(place.x - point.x, place.y - point.y);
        if (distance < best.distance) {
          best = { distance, place, curve, value: value === null ? null : value + share * (nextValue - value) };
        }
      }
    }
    return best.place && best;
  };

  const readCurve = ({ curve, value }) => {
    const number = Number(value.toPrecision(5));
    const hertz = curve.unit === "rad/s" ? ` (${Number((value / (2 * Math.PI)).toPrecision(5))} Hz)` : "";
    return `${curve.name ? `${curve.name}: ` : ""}${curve.quantity} = ${number} ${curve.unit}${hertz}`;
  };

  // Lines that the drawing gives no values for are read from their paths, so that the read-out meets their peaks.
  const drawnLines = (svg, axes) => [...svg.querySelectorAll("g[id*=line2d] > path[clip-path]")].map((path) => {
    const numbers = path.getAttribute("d").match(/-?\d+(\.\d+)?/g)?.map(Number) ?? [];
    const points = [];
    for (let i = 0; i + 1 < numbers.length; i += 2) points.push(numbers[i], numbers[i + 1], null);
    return { points };
  }).filter(({ points: [x, y] }) => axes.some((one) => one.box && contains(one, { x, y })));

  const interactive = (paper, svg) => {
    const axes = JSON.parse(svg.dataset.axes);
    const given = axes.flatMap(({ curves }) => curves ?? []);
    let lines;
    const whole = svg.viewBox.baseVal;
    const full = { x: whole.x, y: whole.y, width: whole.width, height: whole.height };
    let view = { ...full };
    let point = { x: full.x + full.width / 2, y: full.y + full.height / 2 };

    paper.after(document.getElementById("figure-tools").content.cloneNode(true));
    const tools = paper.nextElementSibling;
    const output = tools.querySelector("output");
    const cross = document.createElementNS(SVG, "path");
    cross.setAttribute("class", "cross");
    const ring = document.createElementNS(SVG, "circle");
    ring.setAttribute("class", "ring");
    svg.append(cross, ring);

    const look = () => {
      svg.setAttribute("viewBox", `${view.x} ${view.y} ${view.width} ${view.height}`);
      paper.classList.toggle("zoomed", view.width < full.width);
    };
    const zoom = (factor, at) => {
      const width = clamp(view.width / factor, full.width / 40, full.width);
      const ratio = width / view.width;
      view = { ...view, width, height: view.height * ratio,
        x: at.x - (at.x - view.x) * ratio, y: at.y - (at.y - view.y) * ratio };
      shift(0, 0);
    };
    const shift = (dx, dy) => {
      view.x = clamp(view.x + dx, full.x, full.x + full.width - view.width);
      view.y = clamp(view.y + dy, full.y, full.y + full.height - view.height);
      look();
    };
    const follow = () => shift(
      Math.min(0, point.x - view.x) + Math.max(0, point.x - view.x - view.width),
      Math.min(0, point.y - view.y) + Math.max(0, point.y - view.y - view.height));

    const read = () => {
      const own = axes.find((one) => contains(one, point));
      const scale = view.width / full.width;
      const near = own && (nearest(given, point, REACH * scale)
        ?? nearest(lines ??= drawnLines(svg, axes), point, REACH * scale));
      const at = near?.place ?? point;
      const arm = own ? 5 * scale : 0;
      cross.setAttribute("d", `M${point.x - arm},${point.y}h${2 * arm}M${point.x},${point.y - arm}v${2 * arm}`);
      ring.setAttribute("r", near ? 3.5 * scale : 0);
      ring.setAttribute("cx", at.x);
      ring.setAttribute("cy", at.y);
      output.textContent = own
        ? [readAxes(own, at), near && near.value !== null && readCurve(near)].filter(Boolean).join("; ")
        : "outside of the axes";
    };
    // Zooming by a button or key keeps what is read in place, or else the middle of what is seen.
    const kept = () => (axes.some((one) => contains(one, point)) ? point
      : { x: view.x + view.width / 2, y: view.y + view.height / 2 });
    const placed = (event) => new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());

    let held;
    svg.addEventListener("pointerdown", (event) => {
      if (view.width < full.width) {
        held = placed(event);
        svg.setPointerCapture(event.pointerId);
      }
    });
    svg.addEventListener("pointerup", () => { held = undefined; });
    svg.addEventListener("pointercancel", () => { held = undefined; });
    svg.addEventListener("pointermove", (event) => {
      output.removeAttribute("aria-live");
      point = placed(event);
      if (held) shift(held.x - point.x, held.y - point.y); else read();
    });
    svg.addEventListener("click", (event) => { point = placed(event); read(); });
    svg.addEventListener("dblclick", (event) => zoom(2, placed(event)));
    svg.addEventListener("wheel", (event) => {
      if (!event.ctrlKey) return; // without it, the wheel scrolls the page
      event.preventDefault();
      zoom(event.deltaY < 0 ? 1.25 : 0.8, placed(event));
    }, { passive: false });

    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    paper.addEventListener("keydown", (event) => {
      const step = (event.shiftKey ? 0.1 : 0.01) * view.width;
      if (event.key in arrows) {
        const [across, down] = arrows[event.key];
        point = { x: clamp(point.x + across * step, full.x, full.x + full.width),
          y: clamp(point.y + down * step, full.y, full.y + full.height) };
        follow();
      } else if (event.key === "+" || event.key === "=") {
        zoom(1.5, kept());
      } else if (event.key === "-") {
        zoom(1 / 1.5, kept());
      } else if (event.key === "0") {
        zoom(0, kept());
      } else {
        return;
      }
      event.preventDefault();
      output.setAttribute("aria-live", "polite");
      read();
    });
    tools.addEventListener("click", (event) => {
      const factor = { in: 1.5, out: 1 / 1.5, whole: 0 }[event.target.name];
      if (factor !== undefined) zoom(factor, kept());
    });
  };

  for (const paper of document.querySelectorAll(".paper")) {
    const svg = paper.querySelector("svg[data-axes]");
    if (svg) interactive(paper, svg);
  }
}
