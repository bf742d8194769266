"""How a controlled mechanism follows a step, as text for people and as JSON for machines."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.mechanisms.motion_text import motion_json
from trimmer.command_line.motion_summary import summary_lines
from trimmer.command_line.table import table
from trimmer.design.analysis.found_step import ROUNDING, found_step
from trimmer.design.specification.targets import OF_STEP, Measure, Target
from trimmer.design.verdict import JudgedTarget
from trimmer.response.results.response_json import response_json

if TYPE_CHECKING:
    from trimmer.response.step.step import StepResponse


def as_text(response: StepResponse, targets: Sequence[Target] = ()) -> str:
    """Return what the output does after the step, what is wanted of it, and what it settles to."""
    found, (unit, force), size = response.measures, response.units, abs(response.step.size)
    hunting, judged = response.hunting, {each.target.measure: each for each in _judged(response, targets)}
    rows: list[tuple[str, float | None, str, Measure | None]] = [
        ("rise time, from 10 % to 90 %", found.rise_time, "s", Measure.RISE_TIME),
        ("overshoot", found.overshoot, "%", Measure.OVERSHOOT),
        ("settling time, to within 2 %", found.settling_time, "s", Measure.SETTLING_TIME),
        ("final error", _beyond_rounding(found.final_error, size), unit, Measure.FINAL_ERROR),
        ("largest control", found.largest_control, force, Measure.LARGEST_CONTROL),
        ("largest demand", found.largest_demand, force, None),
    ]
    if hunting is not None or Measure.HUNTING in judged:
        rows.append(("hunting, amplitude", hunting.amplitude if hunting else 0.0, unit, Measure.HUNTING))
    if hunting is not None:
        rows += [
            ("hunting, frequency", hunting.frequency, "Hz", None),
            ("hunting, period", hunting.period, "s", None),
        ]
    motion, step = response.motion, response.step
    ending = motion.message + (f", {response.ending}" if response.ending else "")
    events = ((event.part, event.kind.value) for event in motion.events)
    heads = ("", "measured", "", *(("at most", "") if judged else ()))
    lines = [(what, _number(what, value), unit, *_verdict(judged, of)) for what, value, unit, of in rows]
    return "\n".join(
        [
            f"{response.output} of {response.controller} follows {response.reference}, "
            f"a step of {step.size:g} {unit} at {step.at:g} s",
            *table(heads, lines),
            *summary_lines(motion.duration, ending, events)[:-1],
            response.settles_to.message,
        ]
    )


def _beyond_rounding(error: float, size: float) -> float:
    return error if abs(error) > ROUNDING * size else 0.0


def _judged(response: StepResponse, targets: Sequence[Target]) -> Iterator[JudgedTarget]:
    """Yield the targets of the controller that follows the step, with what was found."""
    found = found_step(response)
    for each in targets:
        if each.part == response.controller and each.measure in OF_STEP:
            value = found.value(each.measure)
            yield JudgedTarget(each, value, each.met_by(value))


def _verdict(judged: Mapping[Measure, JudgedTarget], measure: Measure | None) -> tuple[str, ...]:
    """Return bound and verdict of a row; none at all without targets."""
    if not judged:
        return ()
    if measure is None or measure not in judged:
        return "", ""
    return f"{judged[measure].target.bound:.6g}", "met" if judged[measure].met else "missed"


def _number(what: str, value: float | None) -> str:
    never = "not known" if what.startswith("hunting") else "never"
    return never if value is None else f"{value:.6g}"


def as_json(response: StepResponse, targets: Sequence[Target] = ()) -> str:
    """Return the same as JSON, with all that ``trimmer simulate`` tells of the motion; SI units."""
    return document(
        {
            **picked(response, "reference", "controller", "output"),
            "step": response.step.size,
            "at": response.step.at,
            **vars(response.measures),
            "hunting": None if response.hunting is None else vars(response.hunting),
            "targets": [
                {**picked(each.target, "key", "part", "bound"), **picked(each, "value", "met")}
                for each in _judged(response, targets)
            ],
            "ends": response.ending or None,
            "settles_to": response_json(response.settles_to),
            **motion_json(response.motion),
        }
    )
