"""Which function draws which result: ``draw`` is chosen by the class, as the modules of pictures tell it.

A module of pictures registers its functions when it is imported, which is when a result of its room is
first drawn: a picture of a signal needs no mechanism.
"""

from collections.abc import Mapping
from functools import singledispatch
from importlib import import_module
from types import MappingProxyType
from typing import Any

from matplotlib.axes import Axes

from trimmer.arguments import require_instance

PICTURES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "balance": ("identification", "locus"),
        "branches": ("mechanisms.branch", "mechanisms.curves"),
        "elements": ("describing_function",),
        "fitting": ("signals.fit",),
        "linear": ("frequency_response",),
        "maps": ("mechanisms.curves", "mechanisms.motion_map", "mechanisms.sweep"),
        "loops": ("loop_motion",),
        "orbits": ("orbit",),
        "response": ("mechanisms.motions", "mechanisms.response"),
        "signals": ("signals.samples",),
        "uncertainty": ("mechanisms.scatter",),
        "spectra": ("signals.comparison", "signals.spectrum"),
    }
)
"""The modules here that draw the results of a room."""


@singledispatch
def draw(result: object, axes: Axes, **options: Any) -> None:
    """Draw a result into axes, by the function that is registered for its class, with its options."""
    raise TypeError(f"there is no picture of {type(result).__name__}")


def plot(result: object, ax: Axes | None = None, **options: Any) -> Axes:
    """Draw a result into axes that are given, or into those of a new figure of pyplot, and return them."""
    _import_pictures(type(result))
    if ax is None:
        return _in_new_figure(result, options)
    require_instance("ax", ax, Axes, "Matplotlib axes, such as those of plt.subplots()")
    draw(result, ax, **options)
    return ax


def _in_new_figure(result: object, options: dict[str, Any]) -> Axes:
    """Draw into a figure that notebooks show; none is left of a result that cannot be drawn."""
    from matplotlib import pyplot

    figure = pyplot.figure(layout="constrained")
    axes = figure.add_subplot()
    try:
        draw(result, axes, **options)
    except BaseException:
        pyplot.close(figure)
        raise
    return axes


def _import_pictures(kind: type) -> None:
    for each in kind.__mro__:
        package, _, place = each.__module__.partition(".")
        if package == "trimmer":
            for module in PICTURES.get(place.partition(".")[0], ()):
                import_module(f"trimmer.drawing.{module}")
