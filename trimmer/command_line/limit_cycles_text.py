"""Limit cycles as text for people and as JSON for machines."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from trimmer.balance.leakage import HARMONICS, harmonic_leakage
from trimmer.command_line.certificate_text import certificate_as_json, certificate_as_text
from trimmer.command_line.json_values import finite
from trimmer.command_line.table import table

if TYPE_CHECKING:
    import control

    from trimmer.balance.identification import IdentifiedTimeConstant
    from trimmer.balance.limit_cycle import HarmonicBalance, LimitCycle
    from trimmer.elements.element import Element

_HEADS = ("amplitude", "rad/s", "Hz", "stable", "angle, deg", *(f"harmonic {n}" for n in HARMONICS))


def as_text(G: control.lti.LTI, element: Element, balance: HarmonicBalance) -> str:
    """Return limit cycles as a table, followed by the certificate.

    Amplitudes are in the unit of the element's input, frequencies in rad/s and Hz, angles in degrees.
    """
    rows = [
        (*_cycle_row(cycle), *(f"{ratio:.3g}" for ratio in harmonic_leakage(G, element, cycle)))
        for cycle in balance.limit_cycles
    ]
    lines = [f"Limit cycles of {element!r}", *table(_HEADS, rows)]
    lines += certificate_as_text(balance.certificate)
    if any(cycle.near_tangency for cycle in balance.limit_cycles):
        lines.append(
            "an angle below 5 degrees: the curves nearly touch, so existence and stability are uncertain"
        )
    return "\n".join(lines)


def as_json(G: control.lti.LTI, element: Element, balance: HarmonicBalance) -> str:
    """Return limit cycles as JSON: full precision, SI units; what is infinite is null."""
    content = {
        "element": repr(element),
        "limit_cycles": [
            {
                **_cycle(cycle),
                "harmonic_leakage": dict(
                    zip(map(str, HARMONICS), harmonic_leakage(G, element, cycle), strict=True)
                ),
            }
            for cycle in balance.limit_cycles
        ],
        "certificate": certificate_as_json(balance.certificate),
    }
    return json.dumps(content, indent=2, allow_nan=False)


def identified_as_text(found: Sequence[IdentifiedTimeConstant]) -> str:
    """Return time constants, s, as a table with the limit cycle of each; a sentence if there are none."""
    if not found:
        return "no M/D gives a limit cycle at this frequency"
    rows = [(f"{each.time_constant:.6g}", *_cycle_row(each.limit_cycle)) for each in found]
    return "\n".join(["Time constants M/D", *table(("M/D, s", *_HEADS[:5]), rows)])


def identified_as_json(found: Sequence[IdentifiedTimeConstant]) -> str:
    """Return time constants, s, as JSON; an infinite one, which is inertia-controlled backlash, is null."""
    content = [
        {"time_constant": finite(each.time_constant), "limit_cycle": _cycle(each.limit_cycle)}
        for each in found
    ]
    return json.dumps({"time_constants": content}, indent=2, allow_nan=False)


def _cycle(cycle: LimitCycle) -> dict[str, float | bool]:
    return {
        "amplitude": cycle.amplitude,
        "omega": cycle.omega,
        "frequency": cycle.frequency,
        "stable": cycle.stable,
        "residual": cycle.residual,
        "crossing_angle": cycle.crossing_angle,
        "near_tangency": cycle.near_tangency,
        "other_unstable_poles": cycle.other_unstable_poles,
    }


def _cycle_row(cycle: LimitCycle) -> tuple[str, ...]:
    numbers = (cycle.amplitude, cycle.omega, cycle.frequency)
    stable = "yes" if cycle.stable else "no"
    return (*(f"{number:.6g}" for number in numbers), stable, f"{math.degrees(cycle.crossing_angle):.3g}")
