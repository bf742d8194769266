"""A sweep as text for people and as JSON for machines."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from trimmer.command_line.json_values import document
from trimmer.command_line.mechanisms.follow_text import branch_json
from trimmer.command_line.table import table
from trimmer.motion.units import with_unit

if TYPE_CHECKING:
    from trimmer.maps.jumps import Jump
    from trimmer.maps.swept import Sweep, SweepPoint


def as_text(sweep: Sweep) -> str:
    """Return a sweep as a table of its values, with jumps marked, and where both ways differ."""
    unit = f" ({sweep.unit})" if sweep.unit else ""
    sizes = [
        with_unit(f"{name}, {measure}", each)
        for name, each in sweep.units.items()
        for measure in ("peak to peak", "rms")
    ]
    own = ["frequency, Hz"] * sweep.by_itself
    heads = (f"{sweep.place}{unit}", "motion", *own, *sizes, "")
    lines = [*table(heads, list(_rows(sweep))), sweep.message]
    lines += [_jump(sweep, each) for each in sweep.jumps]
    lines += [
        f"Hysteresis of {each.output} from {each.lowest:.6g} to {each.highest:.6g}: the ways differ by up to "
        f"{_size(sweep, each.output, each.largest)} peak to peak."
        for each in sweep.hysteresis
    ]
    if sweep.branch is not None:
        marks = [f"{each.kind.word} at {each.value:.8g}" for each in sweep.branch.special]
        lines.append(
            f"Exact motions beside it: {', '.join(marks) or 'no special point'}; {sweep.branch.message}."
        )
    return "\n".join(lines)


def as_json(sweep: Sweep) -> str:
    """Return a sweep as JSON: full precision, SI units."""
    branch = None if sweep.branch is None else branch_json(sweep.branch)
    return document({**sweep.to_json(), "branch": branch})


def _rows(sweep: Sweep) -> Iterator[tuple[str, ...]]:
    jumped = {jump.point for jump in sweep.jumps}
    for number, point in enumerate(sweep.points):
        mark = ["back"] * point.back + ["jump"] * (number in jumped)
        kind = point.motion.kind.described(point.motion.periods)
        if sweep.by_itself and point.motion.period:
            kind = "repeats"
        own = [f"{1 / point.motion.period:.6g}" if point.motion.period else "-"] * sweep.by_itself
        yield f"{point.value:.8g}", kind, *own, *_sizes(sweep, point), " ".join(mark)


def _jump(sweep: Sweep, jump: Jump) -> str:
    way = ", on the way back" if sweep.points[jump.point].back else ""
    size = _size(sweep, jump.output, jump.change)
    return f"Jump of {jump.output} between {jump.before:.6g} and {jump.after:.6g}{way}: {size} peak to peak."


def _size(sweep: Sweep, output: str, size: float) -> str:
    return f"{size:.4g} {sweep.units[output]}".rstrip()


def _sizes(sweep: Sweep, point: SweepPoint) -> Iterator[str]:
    for name in sweep.units:
        found = point.motion.outputs.get(name)
        yield from ("-", "-") if found is None else (f"{found.peak_to_peak:.6g}", f"{found.rms:.6g}")
