"use strict";
// The explorable: sliders move the locus of G, the contour of -1/N, their intersections and the motion. All formulas are
// in explorableFormulas, which SymPy printed; here are only the search for solutions and the drawing.
const explorableModel = (formulas) => {
  const TURN = 2 * Math.PI;
  const spaced = (first, last, count) => Array.from({ length: count + 1 }, (_, i) => first + (last - first) * i / count);
  const OMEGAS = spaced(Math.log(60), Math.log(1500), 240).map((each) => TURN * Math.exp(each));
  const FLIGHTS = spaced(0.05, Math.PI, 72);
  const cross = ([a, b], [c, d]) => a * d - b * c;
  const size = ([a, b]) => Math.hypot(a, b);

  // N + 1/G with its slopes by the angle of flight and by the frequency; complex numbers are pairs. Friction rubs between
  // cutter and guard: its N_f, by way of the response H to this pair of forces, counts as N_f H / G at the pin.
  const linear = ({ damping, share }, omega) =>
    [formulas.inverseResponse(omega, damping, share), formulas.rubbing(omega, damping, share)];
  const residual = (settings, flight, omega, known) => {
    const { gap, load, force } = settings;
    const gamma = load * omega;
    const element = formulas.element(flight, gamma);
    const amplitude = gap / element.ratio;
    const friction = formulas.friction(force, amplitude);
    const [g, place] = known ?? linear(settings, omega);
    const amplitudeBy = (ratioBy) => -amplitude * ratioBy / element.ratio;
    const [byFlight, byGamma] = [element.ratioByFlight, element.ratioByGamma].map(amplitudeBy);
    // j times a factor, seen from the pin.
    const rubbed = (factor, { real, imaginary } = place) => [-factor * imaginary, factor * real];
    const byAmplitude = rubbed(friction.imaginaryByAmplitude);
    const moved = rubbed(friction.imaginary, { real: place.realByOmega, imaginary: place.imaginaryByOmega });
    const seen = rubbed(friction.imaginary);
    const gain = [element.real + seen[0], element.imaginary + seen[1]];
    return {
      gamma, amplitude, gain, ratio: element.ratio, separation: element.separation, inverse: [g.real, g.imaginary],
      backlash: [element.real, element.imaginary], rubbing: friction.imaginary,
      value: [gain[0] + g.real, gain[1] + g.imaginary],
      byFlight: [
        element.realByFlight + byAmplitude[0] * byFlight,
        element.imaginaryByFlight + byAmplitude[1] * byFlight,
      ],
      byOmega: [
        load * (element.realByGamma + byAmplitude[0] * byGamma) + moved[0] + g.realByOmega,
        load * (element.imaginaryByGamma + byAmplitude[1] * byGamma) + moved[1] + g.imaginaryByOmega,
      ],
    };
  };

  const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
  const over = ([a, b], [c, d]) => [(a * c + b * d) / (c * c + d * d), (b * c - a * d) / (c * c + d * d)];

  // Poles of 1 + N G + N_f H, both N frozen, that oscillate and grow, besides the limit cycle's own: the roots of a
  // polynomial, all at once by Durand and Kerner's method, with the limit cycle's frequency as unit.
  const otherGrowingPoles = ({ damping, share }, gain, rubbing, omega) => {
    const named = formulas.polynomials(damping, share);
    const powers = [8, 7, 6, 5, 4, 3, 2, 1, 0];
    const scaled = powers.map((power) => times(
      [named[`a${power}`] + gain[0] * named[`b${power}`], gain[1] * named[`b${power}`] + rubbing * named[`h${power}`]],
      [omega ** (power - 8), 0]));
    const polynomial = scaled.map((each) => over(each, scaled[0]));
    const value = (z) => polynomial.reduce((sum, each) => [0, 1].map((part) => times(sum, z)[part] + each[part]), [0, 0]);
    let roots = powers.slice(1).map((power) => [1.1 * Math.cos(0.8 * power + 0.4), 1.1 * Math.sin(0.8 * power + 0.4)]);
    for (let turn = 0; turn < 400; turn += 1) {
      const steps = roots.map((root, i) => over(value(root), roots.reduce(
        (product, other, k) => (k === i ? product : times(product, [root[0] - other[0], root[1] - other[1]])), [1, 0])));
      roots = roots.map((root, i) => [root[0] - steps[i][0], root[1] - steps[i][1]]);
      if (Math.max(...steps.map(size)) < 1e-13) break;
    }
    const own = roots.reduce((best, root) => (Math.hypot(root[0], root[1] - 1) < Math.hypot(best[0], best[1] - 1) ? root : best));
    return roots.filter((root) => root !== own && root[0] > 1e-9 && root[1] > 1e-9).length;
  };

  // Newton's method from one guess; nothing if it leaves the domain or does not settle.
  const polished = (settings, flight, omega) => {
    for (let turn = 0; turn < 40; turn += 1) {
      const at = residual(settings, flight, omega);
      const span = cross(at.byFlight, at.byOmega);
      const [dFlight, dOmega] = [cross(at.byOmega, at.value) / span, -cross(at.byFlight, at.value) / span];
      if (!Number.isFinite(dFlight + dOmega)) return undefined;
      const near = Math.min(1, 0.3 / Math.abs(dFlight), 0.1 * omega / Math.abs(dOmega));
      flight += near * dFlight;
      omega += near * dOmega;
      if (!(flight > 0.01 && flight < Math.PI && omega > OMEGAS[0] / 2 && omega < 2 * OMEGAS.at(-1))) return undefined;
      if (Math.abs(dFlight) < 1e-14 * flight + 1e-15 && Math.abs(dOmega) < 1e-14 * omega) break;
    }
    const at = residual(settings, flight, omega);
    if (size(at.value) > 1e-9 * size(at.gain)) return undefined;
    // Loeb's rule; the amplitude falls as the flight grows longer.
    const returns = cross(at.byFlight, at.byOmega) < 0;
    const others = otherGrowingPoles(settings, at.backlash, at.rubbing, omega);
    return { ...at, flight, omega, frequency: omega / TURN, returns, others, stable: returns && others === 0 };
  };

  // All solutions between 60 and 1500 Hz: cells in which both parts change their sign, then Newton's method.
  const solve = (settings) => {
    const rows = OMEGAS.map((omega) => {
      const known = linear(settings, omega);
      return FLIGHTS.map((flight) => residual(settings, flight, omega, known).value);
    });
    const found = [];
    for (let i = 0; i + 1 < OMEGAS.length; i += 1) {
      for (let k = 0; k + 1 < FLIGHTS.length; k += 1) {
        const corners = [rows[i][k], rows[i][k + 1], rows[i + 1][k], rows[i + 1][k + 1]];
        const changes = (part) => corners.some((each) => each[part] > 0) && corners.some((each) => each[part] <= 0);
        if (!changes(0) || !changes(1)) continue;
        const one = polished(settings, (FLIGHTS[k] + FLIGHTS[k + 1]) / 2, (OMEGAS[i] + OMEGAS[i + 1]) / 2);
        const known = one && found.some((other) => Math.abs(other.omega / one.omega - 1) + Math.abs(other.flight - one.flight) < 1e-6);
        if (one && !known) found.push(one);
      }
    }
    return found.sort((one, other) => one.omega - other.omega);
  };

  const response = ({ damping, share }, omega) => {
    const { real, imaginary } = formulas.inverseResponse(omega, damping, share);
    return [real / (real * real + imaginary * imaginary), -imaginary / (real * real + imaginary * imaginary)];
  };
  const locus = (settings) => spaced(Math.log(60), Math.log(1500), 3000).map((each) => response(settings, TURN * Math.exp(each)));
  // -1/N for a frequency that is kept, as a contour is drawn.
  const contour = (settings, omega) => spaced(0.03, Math.PI, 200).map((flight) => {
    const [real, imaginary] = residual(settings, flight, omega).gain; // with friction as seen from the pin
    return [-real / (real * real + imaginary * imaginary), imaginary / (real * real + imaginary * imaginary)];
  });
  // Pin and load over one period, over A: flight and contact, then both with the other sign.
  const motion = ({ flight, gamma, ratio, separation }) => {
    const half = [
      ...spaced(separation, separation + flight, 60).map((phase) => [phase, formulas.flight(phase, gamma, ratio).position]),
      ...spaced(separation + flight, separation + Math.PI, 60).map((phase) => [phase, formulas.contact(phase, gamma, ratio).position]),
    ];
    return [...half, ...half.map(([phase, position]) => [phase + Math.PI, -position])];
  };
  return { solve, response, locus, contour, motion };
};

{
  const section = document.querySelector(".explorable");
  if (section) {
    const { solve, locus, contour, motion } = explorableModel(explorableFormulas);
    const { sliders, result, panels, written, draw, frame, path, follow } = slidersOf(section);
    const frames = panels.map((svg) => frame(svg, svg.dataset.limits.split(" ").map(Number)));

    const dots = (within, cycles) => cycles.map((cycle) => {
      const [real, imaginary] = cycle.inverse;
      const [cx, cy] = within.place([real / (real ** 2 + imaginary ** 2), -imaginary / (real ** 2 + imaginary ** 2)]);
      return draw("circle", { class: cycle.stable ? "stable" : "unstable", cx, cy, r: 4.5 });
    });

    const verdict = ({ stable, returns }) => {
      if (stable) return "stable";
      return returns ? "unstable, as another pair of poles grows" : "unstable by Loeb’s rule";
    };
    const told = (cycles, shown) => {
      if (cycles.length === 0) return "No intersection between 60 and 1500 Hz: harmonic balance predicts no limit cycle.";
      const lines = cycles.map((cycle) =>
        `${cycle.stable ? "●" : "○"} ${cycle.frequency.toFixed(2)}\u00a0Hz, amplitude ${written(1 / cycle.ratio, 4)}\u00a0gaps = ` +
        `${written(1e6 * cycle.amplitude, 4)}\u00a0µm, ${verdict(cycle)}` +
        `${cycle === shown && cycles.length > 1 ? "; its motion and contour are drawn" : ""}`);
      return lines.join("\n");
    };

    follow((values) => {
      const settings = Object.fromEntries(sliders.map((slider, i) => [slider.name, values[i]]));
      const cycles = solve(settings);
      const shown = cycles.findLast((cycle) => cycle.stable) ?? cycles.at(-1);
      const [curve, line] = [locus(settings), contour(settings, shown?.omega ?? 2 * Math.PI * 735)];
      for (const plane of frames.slice(0, 2)) {
        const [x, y] = plane.place([-1, 0]);
        plane.inner.replaceChildren(path(plane, curve, "plant"), path(plane, line, "element"),
          draw("path", { class: "critical", d: `M${x - 5},${y}h10M${x},${y - 5}v10` }), ...dots(plane, cycles));
      }
      const last = frames[2];
      const phases = Array.from({ length: 241 }, (_, i) => i / 120 * Math.PI);
      const pin = phases.map((phase) => [phase, Math.sin(phase)]);
      const load = shown ? motion(shown) : [];
      const wrapped = [...load.map(([phase, y]) => [phase - 2 * Math.PI, y]), ...load];
      last.inner.replaceChildren(path(last, pin, "pin"), ...(shown ? [path(last, wrapped, "load")] : []));
      result.textContent = told(cycles, shown);
    });
  }
}
