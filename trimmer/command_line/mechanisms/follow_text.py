"""A branch of periodic motions as text for people and as JSON for machines."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.table import table
from trimmer.motion.chosen import chosen_measure
from trimmer.motion.units import with_unit
from trimmer.response.flows import flow_of
from trimmer.response.periodic.pace import period_word, periods_of

if TYPE_CHECKING:
    from trimmer.branches import FollowedBranch, FollowedOrbit, SpecialPoint


def as_text(branch: FollowedBranch, harmonics: int | None, measures: Sequence[str] = ()) -> str:
    """Return a branch and those that part from it: stretches by stability, special points, how it ends."""
    return "\n".join(_lines(branch, harmonics, measures, ""))


def as_json(branch: FollowedBranch, harmonics: int | None, measures: Sequence[str] = ()) -> str:
    """Return a branch as JSON; arguments are those of ``as_text``."""
    return document(branch_json(branch, harmonics, measures))


def _lines(branch: FollowedBranch, harmonics: int | None, measures: Sequence[str], indent: str) -> list[str]:
    begun = "Periodic motions" if branch.parted is None else f"From {branch.parted.kind.word} at"
    at = "" if branch.parted is None else f" {branch.parted.value:.10g}"
    unit = f" ({branch.unit})" if branch.unit else ""
    lines = [f"{begun}{at} over {branch.map.place}{unit}: {_many(branch)}"]
    heads = ("from", "to", "orbits", "stable", *_heads(branch), *_units(branch, measures))
    lines += table(heads, _stretches(branch, measures))
    if branch.special:
        special = ("special", "value", "parts and what happens")
        lines += ["Special points, in their order:", *table(special, [_row(each) for each in branch.special])]
    if harmonics is not None:
        lines.append(_balance(branch, harmonics))
    if branch.points:
        lines.append(f"Searched: {branch.searched}")
    lines = [indent + line for line in [*lines, f"End: {branch.message}"]]
    for other in branch.branches:
        lines += _lines(other, harmonics, measures, indent + "    ")
    return lines


def _many(branch: FollowedBranch) -> str:
    """Say how many orbits a branch has, and how long they are."""
    count, periods = len(branch.points), branch.periods
    orbits = f"{count} orbit" if count == 1 else f"{count} orbits"
    if branch.finds_period:
        return f"{orbits} with a period of their own" + (", which has doubled" if periods > 1 else "")
    word = period_word(branch.map.subject)
    once = "the drive's period" if word == "drive period" else f"the period of one {word}"
    return f"{orbits} with " + (once if periods == 1 else periods_of(branch.map.subject, periods))


def _heads(branch: FollowedBranch) -> list[str]:
    """Return the headings of the ranges: of the period, unless a drive gives it, and of each output."""
    own = ["period, s"] if branch.finds_period else []
    return [*own, *(with_unit(f"{name}, peak to peak", unit) for name, unit in branch.units.items())]


def _units(branch: FollowedBranch, measures: Sequence[str]) -> list[str]:
    flow = flow_of(branch.map.subject)
    return [with_unit(key, chosen_measure(flow, key).unit) for key in measures]


def _stretches(branch: FollowedBranch, measures: Sequence[str]) -> list[tuple[str, ...]]:
    """Return the stretches on which stability does not change, their orbits, and the ranges of measures."""
    rows = []
    for stable, group in itertools.groupby(branch.points, key=lambda point: point.stable):
        points = list(group)
        columns = [[point.period for point in points]] if branch.finds_period else []
        for name in branch.units:
            columns.append([point.outputs[name].peak_to_peak for point in points])
        columns += [[point.measure(key) for point in points] for key in measures]
        ranges = [f"{min(values):.6g} to {max(values):.6g}" for values in columns]
        ends = (f"{points[0].value:.8g}", f"{points[-1].value:.8g}")
        rows.append((*ends, str(len(points)), "yes" if stable else "no", *ranges))
    return rows


def _row(special: SpecialPoint) -> tuple[str, ...]:
    return special.kind.word, f"{special.value:.12g}", special.note


def _balance(branch: FollowedBranch, harmonics: int) -> str:
    balances = [point.balanced(harmonics) for point in branch.points]
    found = [each.distance for each in balances if each.converged]
    if not found:
        return f"Harmonic balance with {harmonics} harmonics converged at no point"
    return (
        f"Harmonic balance with {harmonics} harmonics: {len(found)} of {len(balances)} points, "
        f"off by {min(found):.2g} to {max(found):.2g} (rms, relative)"
    )


def branch_json(
    branch: FollowedBranch, harmonics: int | None = None, measures: Sequence[str] = ()
) -> dict[str, object]:
    """Return a branch as data for JSON; arguments are those of ``as_text``."""
    return {
        "place": branch.map.place,
        "unit": branch.unit,
        "period_count": branch.periods,
        **picked(branch, "reason", "success", "message", "searched"),
        "parted": None if branch.parted is None else _special(branch.parted),
        "points": [_point(point, harmonics, measures) for point in branch.points],
        "special": [_special(each) for each in branch.special],
        "branches": [branch_json(other, harmonics, measures) for other in branch.branches],
    }


def _special(special: SpecialPoint) -> dict[str, object]:
    return picked(special, "kind", "value", "parts", "note")


def _point(point: FollowedOrbit, harmonics: int | None, measures: Sequence[str]) -> dict[str, object]:
    balance = None if harmonics is None else point.balanced(harmonics)
    return {
        **picked(point, "value", "period", "stable", "multipliers", "events_per_period"),
        "outputs": {
            name: picked(measure, "advance", "peak_to_peak", "harmonics")
            for name, measure in point.outputs.items()
        },
        "measures": {key: point.measure(key) for key in measures},
        "balance": None if balance is None else picked(balance, "distance", "converged"),
    }
