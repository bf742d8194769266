"""What the report says of controllers that follow steps: sentences, tables and pictures."""

import math
from collections.abc import Iterator
from functools import partial

from report.design.figures.hunting import hunting_map
from report.design.figures.over_time import motion_over_time
from report.design.quantities import percent, place_words, shown, written
from report.pages.drawing.drawn import drawn
from report.pages.figure import Figure
from trimmer.contact.control_loops import ControlLoops, instability_of, loops_of
from trimmer.design import Design, DesignMap, FoundMotion, FoundStep, LinearState
from trimmer.design.specification.targets import OF_STEP, Measure, unit_of_measure
from trimmer.linear.margins import Margins
from trimmer.mechanism.mechanism import Mechanism
from trimmer.messages import listed
from trimmer.response.results.response import MotionKind

Rows = list[list[str]]
MEASURES = {
    Measure.RISE_TIME: "rise time",
    Measure.OVERSHOOT: "overshoot",
    Measure.SETTLING_TIME: "settling time",
    Measure.FINAL_ERROR: "final error",
    Measure.LARGEST_CONTROL: "largest control",
    Measure.HUNTING: "hunting",
}
"""What each measure of a step is called."""
NEVER = {
    Measure.RISE_TIME: "it does not rise",
    Measure.SETTLING_TIME: "it does not settle",
    Measure.HUNTING: "none: it rests",
}
"""What is said of a time that does not come, and of hunting that is none."""


def step_value(measure: Measure, value: float, unit: str) -> str:
    """Return a measure of a step as plain text."""
    if math.isinf(value) or (measure is Measure.HUNTING and value == 0):
        return NEVER[measure]
    return shown(value, unit)


def hunting_words(motion: FoundMotion) -> str:
    """Say whether what follows steps rests or hunts, as plain text."""
    told = [f"{each.output} {_hunts(each)}" for each in motion.steps.values()]
    return listed(told)


def _hunts(step: FoundStep) -> str:
    if not step.hunting:
        return "comes to rest"
    size = shown(step.hunting, step.signals.units[step.output])
    if step.period is None:
        return f"hunts by ±{size} without repeating"
    return f"hunts by ±{size}, once in {shown(step.period, 's', 4)}"


def step_sentences(design: Design) -> str:
    """Say what each output does after its step."""
    motion = design.motion
    told = []
    for name, each in motion.steps.items() if motion else ():
        unit = each.signals.units[each.output] if each.signals else ""
        size, at = shown(each.step.size, unit), shown(each.step.at, "s")
        ends = f" The picture ends {each.ends}." if each.ends and each.hunting else ""
        told.append(
            f"The controller {name} makes {each.output} follow a step of {size} at {at} in {each.reference}. "
            f"After it {each.output} {_hunts(each)}.{ends}"
        )
    return " ".join(told)


def step_rows(design: Design) -> Rows:
    """Return all measures of each step."""
    motion, mechanism = design.motion, design.file.mechanism
    names = list(motion.steps) if motion else []
    rows = [["Measure", *names]]
    for measure in OF_STEP:
        cells = [
            step_value(measure, motion.measure(measure, name), unit_of_measure(mechanism, measure, name))
            for name in names
            if motion is not None
        ]
        rows.append([MEASURES[measure].capitalize(), *cells])
    return rows


def step_figures(design: Design) -> Iterator[Figure]:
    """Draw how each controller follows its step."""
    motion = design.motion
    for number, (name, each) in enumerate(motion.steps.items() if motion else (), start=1):
        end = "some periods of the hunting" if each.hunting else "the way to rest"
        yield drawn(
            f"step-{number}",
            f"How {each.output} follows {each.reference}",
            f"Above reference and output, below what the controller {name} acts with, after its limit; "
            f"at the bottom when parts touch and stick. It shows {end}.",
            f"Curves of reference, output and control over time; the output {_hunts(each)}.",
            partial(motion_over_time, each.signals),
        )


def hunting_figure(each: DesignMap, number: int) -> Figure:
    """Draw over which numbers an axis rests, hunts evenly, or hunts without repeating."""
    first, second = place_words(each.first.place), place_words(each.second.place)
    rows, columns = each.result.shape
    kinds = [cell.motions[0].kind for cell in each.result.cells]
    share = percent(sum(kind is MotionKind.REST for kind in kinds) / len(kinds))
    return drawn(
        f"hunting-{number}",
        f"Rest and hunting over the {first} and the {second}",
        f"Whether the machine comes to rest after its step, or hunts: {columns} × {rows} cells, each one "
        "motion from the start. It hunts evenly where it comes to a motion that repeats. "
        "The circle is the file’s own point. Edges are known to a cell’s width.",
        f"A map of areas. In {share} of the cells it comes to rest.",
        partial(hunting_map, each),
    )


def instability_sentence(mechanism: Mechanism) -> str:
    """Say that the linear loop grows, which no gap and no friction has caused; empty if it does not."""
    told = instability_of(mechanism)
    return f"{told[:1].upper()}{told[1:]}. Choose other gains before another gap or friction." if told else ""


def loop_rows(state: LinearState, mechanism: Mechanism) -> Rows:
    """Return the margins of the loops of controllers in a state of the contacts, below a head."""
    rows = [["Loop of", "Gain margin", "Phase margin", "Modulus margin", "Closed"]]
    for found in loops_of(mechanism, state.open):
        if found is not None:
            rows += [[name, *_margins(each, found), _closed(found)] for name, each in found.loops.items()]
    return rows


def _closed(found: ControlLoops) -> str:
    return f"grows by e in {shown(1.0 / found.grows, 's')}" if found.grows else found.marginal or "stable"


def _margins(loop: Margins, found: ControlLoops) -> tuple[str, str, str]:
    way = ("may rise to" if loop.gain.value >= 1 else "may fall to") if found.stable else "limit at"
    gain = f"{way} {written(loop.gain.value)} times" if math.isfinite(loop.gain.value) else "any gain"
    phase = f"{written(math.degrees(loop.phase.value))}° at {_hertz(loop.phase.omega)}"
    return (
        f"{gain}{f', {_hertz(loop.gain.omega)}' if math.isfinite(loop.gain.omega) else ''}",
        phase if math.isfinite(loop.phase.value) else "any phase",
        f"{written(loop.modulus.value)} at {_hertz(loop.modulus.omega)}",
    )


def _hertz(omega: float) -> str:
    return shown(omega / math.tau, "Hz")


def loop_sentence(mechanism: Mechanism) -> str:
    """Say what margins leave out; empty without a controller."""
    controllers = mechanism.controllers
    if not controllers:
        return ""
    sampled = {name: each.sample for name, each in controllers.items() if each.sample is not None}
    told = (
        "Margins are of the loop opened where the controller acts, with friction and limits left out: they "
        "do not tell of hunting, which comes of these."
    )
    if len(set(sampled.values())) > 1:
        alone = f"Sampled controllers ({listed(sampled)}) have no margins here, since their samples differ."
        told = alone if len(sampled) == len(controllers) else f"{told} {alone}"
    elif sampled:
        told += (
            f" Those of sampled controllers ({listed(sampled)}) are exact, from sample to sample, and opened "
            "at what is demanded at a sample."
        )
    if 0 < len(sampled) < len(controllers):
        hold = f"{listed(sampled)} {'holds' if len(sampled) == 1 else 'hold'}"
        told += f" Those of other controllers are taken while {hold} what was given last."
    return told
