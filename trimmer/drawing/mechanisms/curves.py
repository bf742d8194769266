"""Curves on which special points lie, over two numbers of a mechanism; by themselves, or over a map."""

from collections.abc import Iterable
from itertools import cycle
from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike

from trimmer.branches.loci.locus import Locus
from trimmer.drawing.axes import add_legend
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK
from trimmer.drawing.units import name_axis
from trimmer.maps.special_curve import SpecialCurve, SpecialCurves

Dashes = Literal["-", "--", "-.", ":"]

STYLES: tuple[Dashes, ...] = ("-", "--", "-.", ":")


@draw.register(Locus)
def draw_locus(locus: Locus, axes: Axes) -> None:
    """Draw a locus over both numbers."""
    draw_curves(axes, [(locus.name, locus.values)], locus.places, locus.units)


@draw.register(SpecialCurve)
def draw_special_curve(curve: SpecialCurve, axes: Axes) -> None:
    """Draw a curve over both numbers."""
    draw_special_curves(SpecialCurves((curve,), ""), axes)


@draw.register(SpecialCurves)
def draw_special_curves(curves: SpecialCurves, axes: Axes) -> None:
    """Draw the curves over both numbers."""
    draw_curves(axes, curves.drawn, *curves.places_and_units)


def draw_curves(
    axes: Axes, curves: Iterable[tuple[str, ArrayLike]], places: tuple[str, str], units: tuple[str, str]
) -> None:
    """Draw curves, (points, 2), over two numbers, SI units; the limits of axes that hold a map stay."""
    held = axes.has_data()
    handles = add_curves(axes, curves, hold=held)
    if not held:
        name_axis(axes.xaxis, places[0], units[0])
        name_axis(axes.yaxis, places[1], units[1])
        axes.grid(alpha=0.3)
    legend = axes.get_legend()
    before = [] if legend is None else list(legend.legend_handles)
    add_legend(axes, [*(each for each in before if each is not None), *handles])


def add_curves(axes: Axes, curves: Iterable[tuple[str, ArrayLike]], *, hold: bool) -> list[Line2D]:
    """Draw curves with a light border, so that they show on any colour; return lines for the legend."""
    limits = axes.get_xlim(), axes.get_ylim()
    styles: dict[str, Dashes] = {}
    rest = cycle(STYLES)
    for name, points in curves:
        style = styles[name] if name in styles else styles.setdefault(name, next(rest))
        first, second = np.asarray(points, dtype=float).T
        axes.plot(first, second, "-", color="white", linewidth=2.6)
        axes.plot(first, second, style, color=BLACK, linewidth=1.2)
    if hold:
        axes.set_xlim(limits[0])
        axes.set_ylim(limits[1])
    return [Line2D([], [], color=BLACK, linestyle=style, label=name) for name, style in styles.items()]
