"""Limit cycles of the thesis's loop over friction and gap: exact, and by harmonic balance."""

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP, LARGE_GAP
from report.numbers.twin.closed_loop import FORCES, LEAST_GAP
from report.numbers.twin.kept_branch import KeptBranch
from report.pages.drawing.style import BLACK, FAINT, LINES, panels
from trimmer.arrays import Reals

MICRO: Final = 1e6
EVERY: Final = 4  # One of so many solutions of harmonic balance is marked
CROSS: Final = {"color": BLACK, "marker": "x", "markersize": 4.0, "linestyle": "none", "markeredgewidth": 0.9}


@figure("twin-loop-branches")
def loop_branches(known: Evidence) -> Figure:
    """Draw both panels."""
    drawn, (over_force, over_gap) = panels(3.6, 1, 2)
    balance, numbers = known.cycles.equivalent.in_place, known.twin.loop
    sides, largest = (balance.stable, balance.unstable), numbers.largest.amplitude
    _branch(over_force, numbers.over_force, 1.0, LARGE_GAP * largest, BLACK)
    for side in sides:
        forces, amplitudes = side.force_per_gap[::EVERY], side.amplitude[::EVERY]
        over_force.plot(LARGE_GAP * forces, MICRO * LARGE_GAP * amplitudes, **CROSS)
    for branch, force, line in zip(numbers.over_gap, FORCES, LINES, strict=False):
        (fold,) = branch.special_of("fold")
        _branch(over_gap, branch, MICRO, fold * largest, str(line["color"]), f"{force:g} N")
        for side in sides:
            gaps = force / side.force_per_gap[EVERY::EVERY]
            amplitudes, shown = gaps * side.amplitude[EVERY::EVERY], gaps <= EXPERIMENT_GAP
            over_gap.plot(MICRO * gaps[shown], MICRO * amplitudes[shown], **CROSS)
    _without_friction(over_gap, known)
    over_gap.set(xscale="log", yscale="log", xlabel="gap [µm]", title="over the gap")
    over_gap.set_xticks([10, 20, 50, 100, 200], ["10", "20", "50", "100", "200"])
    over_gap.set_yticks([10, 100, 1000], ["10", "100", "1000"])
    over_gap.minorticks_off()
    over_gap.legend(loc="upper left")
    over_force.set(xlabel="friction [N]", ylabel="amplitude [µm]", title="over the friction, 40 µm")
    over_force.set(xlim=(0, None), ylim=(0, None))
    over_force.plot([], [], color=BLACK, label="stable")
    over_force.plot([], [], color=BLACK, linestyle=":", label="unstable")
    over_force.plot([], [], "D", color=BLACK, markersize=4.5, label="fold")
    over_force.plot([], [], label="harmonic balance", **CROSS)
    over_force.legend(loc="upper right")
    return drawn


def _branch(
    axes: Axes, branch: KeptBranch, unit: float, at_fold: float, colour: str, label: str | None = None
) -> None:
    values, amplitudes, stable = unit * branch.values, MICRO * branch.strokes / 2, branch.stable
    (fold,) = branch.special_of("fold")
    end = (unit * fold, MICRO * at_fold)
    for chosen, look in ((stable, "-"), (~stable, ":")):
        x, y = values[chosen], amplitudes[chosen]
        # Both sides of the branch end in the fold.
        at = len(x) if chosen[0] else 0
        x, y = np.insert(x, at, end[0]), np.insert(y, at, end[1])
        axes.plot(x, y, color=colour, linestyle=look, linewidth=1.6, label=label if look == "-" else None)
    axes.plot(*end, "D", color=BLACK, markersize=4.5)


def _without_friction(axes: Axes, known: Evidence) -> None:
    gaps: Reals = np.array([LEAST_GAP, EXPERIMENT_GAP])
    for orbit in (known.orbits.friction.stable, known.orbits.friction.unstable):
        axes.plot(MICRO * gaps, MICRO * gaps * orbit.amplitude, **FAINT)
