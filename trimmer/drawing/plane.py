"""The plane of G and -1/N: loci of linear systems and of elements, with omega or amplitude along them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.drawing.along import Along, plot_along
from trimmer.linear.frequency_response import response_at

if TYPE_CHECKING:
    import control
    from matplotlib.axes import Axes

    from trimmer.arrays import Complexes, Reals
    from trimmer.elements.element import Element


def system_locus(axes: Axes, system: control.lti.LTI, omega: Reals, **look: Any) -> None:
    """Draw G(j omega); ``look`` are keywords of ``Axes.plot``."""
    plot_along(axes, response_at(system, omega), Along("ω", "rad/s", omega), **look)


def inverse(element: Element, ratios: Reals, omega: float | None = None) -> Complexes:
    """Return -1/N at u = amplitude_scale/amplitude.

    Args:
        element: The element.
        ratios: u, a number, (n,).
        omega: Angular frequency, rad/s, for an element that depends on it.
    """
    gain = element.describing_function(element.amplitude_scale / ratios, omega)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(-1.0 / gain)


def element_locus(
    axes: Axes, element: Element, ratios: Reals, along: Along, omega: float | None = None, **look: Any
) -> None:
    """Draw -1/N over u; ``along`` is what can be read off it, ``look`` are keywords of ``Axes.plot``."""
    plot_along(axes, inverse(element, ratios, omega), along, **look)
