"""Exact orbits as text for people and as JSON for machines."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.loops.limit_cycles_text import certificate_as_json, certificate_as_text
from trimmer.command_line.table import or_rounding, table

if TYPE_CHECKING:
    from trimmer.balance.limit_cycle import HarmonicBalance, LimitCycle
    from trimmer.elements.element import Element
    from trimmer.orbits import PeriodicOrbit, PeriodicOrbits

HEADS = ("amplitude", "Hz", "stable", "multiplier", "predicted amplitude", "error", "predicted Hz", "error")


def as_text(element: Element, predictions: HarmonicBalance, orbits: PeriodicOrbits) -> str:
    """Return orbits as a table, each beside its prediction, followed by the certificate of the predictions.

    Amplitudes are in the unit of the element's input, frequencies in Hz.
    """
    lines = [f"Exact limit cycles of {element!r}", *table(HEADS, [_row(orbit) for orbit in orbits])]
    lines += [
        f"predicted, but not found: amplitude {each.amplitude:.6g} at {each.frequency:.6g} Hz"
        for each in _without_orbit(predictions.limit_cycles, orbits)
    ]
    searched, *undecided = certificate_as_text(predictions.certificate)
    lines += [f"predictions {searched}", *undecided, orbits.search.sentence]
    lines += [f"{family.sentence[0].upper()}{family.sentence[1:]}." for family in orbits.families]
    lines += [
        f"of amplitude {orbit.amplitude:.6g} at {orbit.frequency:.6g} Hz: {orbit.edge.told}"
        for orbit in orbits
        if orbit.edge is not None
    ]
    if orbits:
        lines.append("multiplier: what is left of a disturbance after one period; above 1 it grows")
    return "\n".join(lines)


def as_json(element: Element, predictions: HarmonicBalance, orbits: PeriodicOrbits) -> str:
    """Return orbits as JSON: full precision, SI units."""
    content = {
        "element": repr(element),
        "orbits": [_entry(orbit) for orbit in orbits],
        "families": [
            {"amplitude": each.member.amplitude, "met": each.met, "amplitudes": each.amplitudes}
            for each in orbits.families
        ],
        "not_found": [
            picked(each, "amplitude", "frequency")
            for each in _without_orbit(predictions.limit_cycles, orbits)
        ],
        "certificate": certificate_as_json(predictions.certificate),
        "search": orbits.search.sentence,
        "success": orbits.success,
    }
    return document(content)


def _row(orbit: PeriodicOrbit) -> tuple[str, ...]:
    prediction = orbit.prediction
    measured = (
        *(f"{orbit.amplitude:.6g}", f"{orbit.frequency:.6g}", _stable(orbit)),
        or_rounding(orbit.largest_multiplier, ".4g"),
    )
    if prediction is None:
        return (*measured, "none", "", "", "")
    return (
        *measured,
        *(f"{prediction.amplitude:.6g}", f"{orbit.amplitude_error:+.2%}"),
        *(f"{prediction.frequency:.6g}", f"{orbit.frequency_error:+.3%}"),
    )


def _stable(orbit: PeriodicOrbit) -> str:
    return "yes" if orbit.stable else "neutral" if orbit.neutral else "no"


def _entry(orbit: PeriodicOrbit) -> dict[str, object]:
    names = ("amplitude", "period", "frequency", "stable", "neutral", "one_sided", "multipliers")
    return {
        **picked(orbit, *names),
        "harmonics": [abs(value) for value in orbit.harmonics.tolist()],
        **picked(orbit, "switching_times", "residual", "amplitude_error", "frequency_error"),
    }


def _without_orbit(predictions: Sequence[LimitCycle], orbits: Sequence[PeriodicOrbit]) -> list[LimitCycle]:
    found = [orbit.prediction for orbit in orbits]
    return [each for each in predictions if each not in found]
