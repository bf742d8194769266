"""Kinds of motion in plain words, each with its colour and, where a grey print needs it, its hatching."""

from collections.abc import Sequence
from dataclasses import dataclass

from matplotlib.patches import Patch

from trimmer.maps.cell_motion import CellMotion, described, waited_for

PERIOD_COLOURS = ("#56B4E9", "#0072B2", "#009E73", "#F0E442", "#E69F00", "#D55E00")
"""Of motions of period 1, 2, ...: the colours of Okabe and Ito, which colour-blind readers tell apart."""
LONGER_COLOUR = "#CC79A7"
OTHER_COLOURS = {"rest": "#4B2E83", "torus": "#777777", "chaotic": "#222222", "diverging": "#B3261E"}
OTHER_COLOURS |= {"not settled": "#CCCCCC", "failed": "#FFFFFF"}
LONGER = f"period {len(PERIOD_COLOURS) + 1} or more"
HATCHES = {"period 3": "//", "period 5": "\\\\", "period 6": "xx", LONGER: "..", "torus": "--"}
HATCHES |= {"rest": "oo"}
HATCHES |= {"not settled": "||", "diverging": "++"}
"""Of kinds whose colours are as light as others'."""


@dataclass(frozen=True)
class Category:
    """A kind of motion in a map by name, with its colour and its hatching, empty for none."""

    name: str
    colour: str
    hatch: str = ""


def category(motion: CellMotion) -> Category:
    """Return the category of a motion."""
    name = described(motion)
    if name in OTHER_COLOURS:
        return _named(name, OTHER_COLOURS[name])
    if motion.period_count <= len(PERIOD_COLOURS):
        return _named(name, PERIOD_COLOURS[motion.period_count - 1])
    return _named(LONGER, LONGER_COLOUR)


def categories() -> list[Category]:
    """Return all categories in the order of the legend."""
    periods = {f"period {count}": colour for count, colour in enumerate(PERIOD_COLOURS, start=1)}
    return [_named(*each) for each in {**periods, LONGER: LONGER_COLOUR, **OTHER_COLOURS}.items()]


def _named(name: str, colour: str) -> Category:
    return Category(name, colour, HATCHES.get(name, ""))


def legend_of(legend: Sequence[Category], waited: str) -> list[Patch]:
    """Return a patch for each category; what had not settled says after how long."""
    return [
        Patch(
            facecolor=each.colour, edgecolor="0.4", hatch=2 * each.hatch, label=waited_for(each.name, waited)
        )
        for each in legend
    ]
