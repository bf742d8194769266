"""How a controlled mechanism follows a step, as text for people and as JSON for machines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trimmer.command_line.json_values import document
from trimmer.command_line.mechanisms.motion_text import motion_json
from trimmer.command_line.motion_summary import summary_lines
from trimmer.command_line.table import table
from trimmer.response.response_json import response_json

if TYPE_CHECKING:
    from trimmer.response.step import StepResponse

ROUNDING = 1e-9
"""Share of the step below which a final error is rounding, or what is left of the way to rest."""


def as_text(response: StepResponse) -> str:
    """Return what the output does after the step, and what the mechanism settles to."""
    found, (unit, force), size = response.measures, response.units, abs(response.step.size)
    rows = [
        ("rise time, from 10 % to 90 %", found.rise_time, "s"),
        ("overshoot", found.overshoot, "%"),
        ("settling time, to within 2 %", found.settling_time, "s"),
        ("final error", found.final_error if abs(found.final_error) > ROUNDING * size else 0.0, unit),
        ("largest control", found.largest_control, force),
        ("largest demand", found.largest_demand, force),
    ]
    if response.hunting is not None:
        rows += [
            ("hunting, amplitude", response.hunting.amplitude, unit),
            ("hunting, frequency", response.hunting.frequency, "Hz"),
            ("hunting, period", response.hunting.period, "s"),
        ]
    motion, step = response.motion, response.step
    ending = motion.message + (f", {response.ending}" if response.ending else "")
    events = ((event.part, event.kind.value) for event in motion.events)
    return "\n".join(
        [
            f"{response.output} of {response.controller} follows {response.reference}, "
            f"a step of {step.size:g} {unit} at {step.at:g} s",
            *table(("", "measured", ""), [(what, _number(what, value), unit) for what, value, unit in rows]),
            *summary_lines(motion.duration, ending, events)[:-1],
            response.settles_to.message,
        ]
    )


def _number(what: str, value: float | None) -> str:
    never = "not known" if what.startswith("hunting") else "never"
    return never if value is None else f"{value:.6g}"


def as_json(response: StepResponse) -> str:
    """Return the same as JSON, with all that ``trimmer simulate`` tells of the motion; SI units."""
    return document(
        {
            "reference": response.reference,
            "controller": response.controller,
            "output": response.output,
            "step": response.step.size,
            "at": response.step.at,
            **vars(response.measures),
            "hunting": None if response.hunting is None else vars(response.hunting),
            "ends": response.ending or None,
            "settles_to": response_json(response.settles_to),
            **motion_json(response.motion),
        }
    )
