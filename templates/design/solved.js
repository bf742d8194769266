"use strict";
// The sliders of a design: of the motions in solvedMotions the nearest one is shown, never one between them.
{
  const section = document.querySelector(".explorable");
  if (section) {
    const { sliders, result, panels, written, frame, path, follow } = slidersOf(section);
    const table = solvedMotions;
    const LOWEST = -65;
    const units = sliders.map((slider) => slider.dataset);

    const nearest = (values, value) => values.reduce((best, each, i) => (Math.abs(each - value) < Math.abs(values[best] - value) ? i : best), 0);
    const motionAt = (places) => table.motions[places.reduce((number, place, i) => number * table.values[i].length + place, 0)];
    const ownPlaces = table.own.map((value, i) => nearest(table.values[i], value));

    const curve = ([, , , duration, curves], signal) => {
      const [least, largest, steps] = curves[signal];
      return steps.map((step, i) => [
        i / (steps.length - 1) * duration * table.time,
        (least + step / table.levels * (largest - least)) * table.scales[signal],
      ]);
    };
    // Levels in dB over the largest line that the file's own motion has.
    const lines = ([, , , , , spectra], signal, frequency, largest) =>
      spectra[signal].filter(([, , size]) => size > 0).map(([p, k, size]) => [p / k * frequency, 20 * Math.log10(size / largest)]);
    const largestOf = ([, , , , , spectra], signal) => Math.max(...spectra[signal].map(([, , size]) => size)) || 1;

    // Limits hold both motions, so that what the sliders change is seen beside what the file has.
    const span = (numbers) => [Math.min(...numbers), Math.max(...numbers)];
    const wider = ([low, high], share) => {
      const room = share * (high - low) || Math.abs(high) || 1;
      return [low - room, high + room];
    };
    const drawCurves = (svg, curves) => {
      const points = curves.flatMap(([each]) => each);
      const within = frame(svg, [...span(points.map(([x]) => x)), ...wider(span(points.map(([, y]) => y)), 0.06)]);
      within.inner.replaceChildren(...curves.map(([each, name]) => path(within, each, name)));
    };
    const drawLines = (svg, spectra) => {
      const every = spectra.flatMap(([each]) => each);
      const [right, top] = [Math.max(1, ...every.map(([x]) => x)), Math.max(0, ...every.map(([, y]) => y))];
      const within = frame(svg, [0, 1.05 * right, LOWEST, top + 5]);
      const upright = ([x, y], name) => path(within, [[x, LOWEST], [x, Math.max(y, LOWEST)]], name);
      within.inner.replaceChildren(...spectra.flatMap(([each, name]) => each.map((line) => upright(line, name))));
    };

    const told = (motion, places, asked) => {
      const values = places.map((place, i) => table.values[i][place]);
      const at = values.map((value, i) => `${table.numbers[i]} ${written(value * Number(units[i].factor))}\u00a0${units[i].unit}`.trim());
      const between = values.some((value, i) => Math.abs(value - asked[i]) > 1e-9 * Math.abs(value));
      const own = places.every((place, i) => place === ownPlaces[i]) ? ", as in the file" : "";
      const head = `${between ? "The solved motion nearest to the sliders is shown" : "Shown is the motion solved for"}: ${at.join(", ")}${own}.`;
      if (motion.length === 1) return `${head}\n${motion[0]}`;
      const [kind, found, met] = motion;
      const rows = table.targets.map(({ name, wanted, factor, unit }, i) => {
        const value = unit === null ? "" : `${found[i] === null ? "none" : `${written(found[i] * factor)}\u00a0${unit}`.trim()}, `;
        return `${met[i] ? "✓" : "✗"} ${name}: ${value}${wanted} is wanted: ${met[i] ? "met" : "missed"}`;
      });
      return [head, `${kind[0].toUpperCase()}${kind.slice(1)}.`, ...rows].join("\n");
    };

    follow((asked) => {
      const places = asked.map((value, i) => nearest(table.values[i], value));
      const [motion, own] = [motionAt(places), motionAt(ownPlaces)];
      const frequencyOf = (which) => (table.frequencyAt === null ? table.frequency : table.values[table.frequencyAt][which[table.frequencyAt]]);
      const both = [[own, ownPlaces, "pin"], [motion, places, "load"]].filter(([each]) => each.length > 1);
      panels.forEach((svg, number) => {
        const signal = table.spectra ? Math.floor(number / 2) : number;
        if (both.length === 0) return svg.replaceChildren();
        const largest = largestOf(both[0][0], signal);
        if (table.spectra && number % 2) drawLines(svg, both.map(([each, where, name]) => [lines(each, signal, frequencyOf(where), largest), name]));
        else drawCurves(svg, both.map(([each, , name]) => [curve(each, signal), name]));
      });
      result.textContent = told(motion, places, asked);
    });
  }
}
