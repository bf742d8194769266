"""What a mechanism or a loop settles to, as text for people and as JSON for machines."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from trimmer.command_line.json_values import document
from trimmer.command_line.table import or_rounding, table
from trimmer.mechanism.cut_waveforms import told_of_waveforms
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.part_measures import ContactMeasures
from trimmer.motion.units import with_unit
from trimmer.response.flows import flow_of
from trimmer.response.periodic.pace import pace_of, period_word
from trimmer.response.results.response import MotionKind
from trimmer.response.results.response_json import response_json
from trimmer.showing.shown import counted

if TYPE_CHECKING:
    from trimmer.motion.flow import Flow
    from trimmer.response.results.response import Response, SettledMotion
    from trimmer.response.statistics.estimate import Estimate
    from trimmer.response.without_events.rest import Rest

LARGE_LINES = 6  # Lines of a spectrum that are shown, the largest ones
SMALL = 1e-9  # Share of the largest line below which one is rounding


def as_text(response: Response) -> str:
    """Return what something settles to: first what it is, then tables of what it does."""
    lines, flow = [response.message], flow_of(response.subject)
    if isinstance(response.subject, Mechanism):
        lines += told_of_waveforms(response.subject)
    for number, motion in enumerate(response.motions, start=1):
        if len(response.motions) > 1:
            mirrored = ", the mirror image of one before" if motion.mirrored else ""
            lines += ["", f"Motion {number}, {motion.share:.0%} of the starts{mirrored}"]
            lines += [motion.message] if number > 1 else []
        lines += _motion(motion, flow)
    if response.starts > 1:
        lines += ["", _box(response)]
    return "\n".join(lines)


def as_json(response: Response) -> str:
    """Return what something settles to as JSON: full precision, SI units."""
    return document(response_json(response))


def _box(response: Response) -> str:
    units = flow_of(response.subject).axis_units
    reach = ", ".join(
        f"{name} {' and '.join(map(_with_unit, sizes, units[name]))}" for name, sizes in response.box.items()
    )
    return f"Random starts lie within {reach} on either side of rest (seed {response.seed})."


def _with_unit(size: float, unit: str) -> str:
    return f"{size:.3g} {unit}".rstrip()


def _motion(motion: SettledMotion, flow: Flow) -> Iterator[str]:
    if motion.rest is not None:
        yield from rest_lines(motion.rest)
        return
    if motion.orbit is None and motion.window is None and motion.linear is None:
        return
    word = period_word(flow.subject)
    yield from _facts(motion, word)
    driven = motion.orbit is None or motion.orbit.periods > 0
    of = f"p/k of the {word.removesuffix(' period')}" if driven else "multiples of its own frequency"
    if _has_peaks_alone(motion):
        of = "frequency"
    units = {name: each.unit for name, each in flow.outputs.items()}
    advance, unit = _advance(motion, units, word), _common(units.values())
    sizes = (with_unit(head, unit) for head in ("peak to peak", "rms", f"lines as {of}: amplitude"))
    heads = ("output", *advance, *sizes)
    rows = [
        (
            name if unit else with_unit(name, units[name]),
            *(each[name] for each in advance.values()),
            f"{motion.peak_to_peak[name]:.9g}",
            _number(rms),
            _lines(motion, name),
        )
        for name, rms in motion.rms.items()
    ]
    yield from table(heads, rows)
    yield from _sums(motion, units)
    accelerations = {name: _number(each) for name, each in motion.rms_acceleration.items()}
    if accelerations:
        bodies = {name: flow.units_of_body(name).acceleration for name in accelerations}
        yield from _valued("body", "rms acceleration", accelerations, bodies)
    yield from _parts(motion, flow)


def _common(units: Iterable[str]) -> str:
    """Return the unit that all have in common; empty if they have none."""
    found = set(units)
    return found.pop() if len(found) == 1 else ""


def _advance(motion: SettledMotion, units: Mapping[str, str], word: str) -> dict[str, dict[str, str]]:
    """Return the column of advances with its heading; none if they are rounding."""
    largest = max(motion.peak_to_peak.values(), default=0.0)
    shown = {name: 0.0 if abs(each) <= SMALL * largest else each for name, each in motion.advance.items()}
    if not any(shown.values()):
        return {}
    per = "period" if motion.orbit is not None else word
    if motion.window is not None and not motion.window.flow.period:
        per = "s"
    head = with_unit(f"advance per {per}", _common(units.values()))
    return {head: {name: f"{each:.9g}" for name, each in shown.items()}}


def _facts(motion: SettledMotion, word: str) -> Iterator[str]:
    if motion.orbit is not None:
        largest = abs(motion.orbit.nontrivial_multipliers).max(initial=0.0)
        per, size = word if motion.orbit.periods else "period", or_rounding(largest, ".6g")
        events = counted(f"{motion.events_per_period:g}", "event")
        yield f"  {events} per {per}; largest multiplier {size}"
    elif motion.linear is not None:
        yield "  no events; figures are exact, of all time"
    else:
        events = counted(f"{motion.events_per_period:.4g}", "event")
        per = word if motion.window is None or motion.window.flow.period else "return"
        yield f"  {events} per {per}; figures are those of the window"


def rest_lines(rest: Rest) -> Iterator[str]:
    """Return where all rests, and what each part bears there."""
    flow = rest.flow
    bodies = isinstance(flow.subject, Mechanism)
    where, force = (("body", "displacement"), "force") if bodies else (("signal", "value"), "output")
    units = {
        name: flow.units_of_body(name).length if bodies else flow.outputs[name].unit
        for name in rest.positions
    }
    yield from _valued(*where, _written(rest.positions), units)
    head = f"mean {force} over a {period_word(flow.subject)}" if rest.forces_change else force
    forces = {name: flow.force_unit(name) for name in rest.forces}
    yield from _valued("part", head, _written(rest.forces), forces)


def _written(values: Mapping[str, float]) -> dict[str, str]:
    return {name: f"{each:.9g}" for name, each in values.items()}


def _valued(what: str, head: str, values: Mapping[str, str], units: Mapping[str, str]) -> Iterator[str]:
    """Return a table of values by name, the unit at its head if it is that of all."""
    unit = _common(units.values())
    rows = [(name if unit else with_unit(name, units[name]), each) for name, each in values.items()]
    yield from table((what, with_unit(head, unit)), rows)


def _number(estimate: Estimate) -> str:
    if estimate.uncertainty == 0:
        return f"{estimate.value:.9g}"
    low, high = estimate.interval
    return f"{estimate.value:.6g} (95 %: {low:.6g} to {high:.6g})"


def _has_peaks_alone(motion: SettledMotion) -> bool:
    """Say whether lines of a window are not counted from a drive."""
    window = motion.window
    return window is not None and (pace_of(window.flow.subject) > 1 or not window.flow.period)


def _lines(motion: SettledMotion, name: str) -> str:
    """Return the largest lines of an output, in order of frequency."""
    window = motion.window
    if window is not None and _has_peaks_alone(motion):
        peaks = sorted(window.peaks[name])[:LARGE_LINES]
        return ", ".join(f"{frequency:.6g} Hz: {size:.6g}" for frequency, size in peaks) or "none"
    if motion.orbit is not None:
        lines = motion.orbit.measures.outputs[name].lines
    else:
        lines = [(place + 1, 1, size) for place, size in enumerate(motion.harmonics[name].tolist())]
    largest = max((size for *_, size in lines), default=0.0)
    shown = sorted(lines, key=lambda line: -line[2])[:LARGE_LINES]
    kept = sorted(line for line in shown if line[2] > SMALL * largest)
    return ", ".join(f"{Fraction(p, k)}: {size:.6g}" for p, k, size in kept) or "none"


def _sums(motion: SettledMotion, units: Mapping[str, str]) -> Iterator[str]:
    """Say of which sums of two frequencies the lines of a torus are."""
    window = motion.window
    if motion.kind is not MotionKind.TORUS or window is None:
        return
    for name, (own, sums) in window.combinations.items():
        if own is not None:
            named = sorted(zip(window.peaks[name], sums, strict=True))
            told = (
                f"{frequency:.6g} Hz ({'no sum' if each is None else f'{each[0]}, {each[1]}'}) {size:.3g}"
                for (frequency, size), each in named
            )
            unit = f" {units[name]}" if units[name] else ""
            first = f"i x {1 / window.unit:.6g} Hz, the drive, + j x {own:.6g} Hz"
            yield f"  lines of {name} at {first}: {', '.join(told)}{unit}"


def _headed(head: str, units: Mapping[str, str]) -> tuple[str, Mapping[str, str]]:
    """Return a heading with the unit of all, or what follows each value where they differ."""
    unit = _common(units.values())
    return with_unit(head, unit), {name: "" if unit else f" {each}".rstrip() for name, each in units.items()}


def _parts(motion: SettledMotion, flow: Flow) -> Iterator[str]:
    for name, each in motion.contacts.items():
        if each.completed:
            yield f"  on {name} an infinite chatter is completed, {each.completed:g} per period"
    if motion.contacts:
        forces = any(each.largest_force is not None for each in motion.contacts.values())
        units = {name: flow.units_of_part(name) for name in motion.contacts}
        force, newton = _headed("largest force", {name: each.force for name, each in units.items()})
        speed, per_second = _headed("largest speed", {name: each.speed for name, each in units.items()})
        walls = flow.subject.walls if isinstance(flow.subject, Mechanism) else ()
        yield from table(
            ("contact", "impacts per period", speed, *([force] if forces else []), "time in contact"),
            [
                (
                    name,
                    f"{each.impacts:g}",
                    f"{each.impact_speed:.6g}{per_second[name]}",
                    *([] if each.largest_force is None else [_force(each, name in walls, newton[name])]),
                    f"{each.share:.2%}",
                )
                for name, each in motion.contacts.items()
            ],
        )
    if motion.frictions:
        work = with_unit("work per period", flow.units.work)
        power = with_unit("power", flow.units.power)
        yield from table(
            ("friction", work, power, "time in stick"),
            [
                (name, f"{each.work:.6g}", f"{each.power:.6g}", f"{each.stick:.2%}")
                for name, each in motion.frictions.items()
            ],
        )


def _force(each: ContactMeasures, rigid: bool, unit: str) -> str:
    return "an impulse" if rigid and each.impacts else f"{each.largest_force:.6g}{unit}"
