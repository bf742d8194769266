"""The pictures of an element: its describing function over the amplitude, and the locus of -1/N."""

import numpy as np
from matplotlib.axes import Axes

from trimmer.arrays import Complexes, Reals
from trimmer.drawing.axes import label
from trimmer.drawing.dispatch import draw
from trimmer.drawing.locus import draw_element_curve, ratios_of
from trimmer.drawing.look import line
from trimmer.drawing.marks import arrow, critical_point
from trimmer.drawing.plane import inverse, show
from trimmer.elements.element import Element, ElementLocus

LARGEST = 1e2  # Largest amplitude that is shown over the smallest one, or the scale over the smallest one
POINTS = 1000
MARGIN = 10.0  # Degrees of free room above and below the phase
SHOWN = 20.0  # |1/N| that is shown of a locus at most, over its smallest
LEAST = 3.0  # |1/N| up to which it is shown in any case, so that -1 is seen


@draw.register(Element)
def draw_describing_function(element: Element, axes: Axes, omega: float | None = None) -> None:
    """Draw |N| over the amplitude, and the phase with an axis at the right."""
    amplitude = amplitudes_of(element, omega)
    gain = element.describing_function(amplitude, omega)
    axes.semilogx(amplitude, abs(gain), **line(0))
    label(axes, "amplitude A, unit of the input", "|N| (solid)")
    axes.set_ylim(bottom=0.0)
    phases = axes.twinx()
    phases.set_ylabel("phase of N (dashed), degrees")
    degrees = np.degrees(np.unwrap(np.angle(gain)))
    phases.semilogx(amplitude, degrees, **line(1))
    phases.set_ylim(min(float(degrees.min()), 0.0) - MARGIN, max(float(degrees.max()), 0.0) + MARGIN)


def amplitudes_of(element: Element, omega: float | None) -> Reals:
    """Return amplitudes from the smallest of the domain on, in equal ratios; without one around the scale."""
    largest = float(element.domain(omega))
    scale = element.amplitude_scale
    if np.isinf(largest):
        return np.geomspace(scale / LARGEST, scale * LARGEST, POINTS)
    smallest = scale / largest
    near = smallest * (1.0 + np.geomspace(1e-6, 0.1, POINTS // 4))
    return np.concatenate([near, np.geomspace(1.1 * smallest, LARGEST * smallest, POINTS)[1:]])


@draw.register(ElementLocus)
def draw_element_locus(locus: ElementLocus, axes: Axes) -> None:
    """Draw -1/N in the complex plane, with an arrow towards larger amplitudes."""
    element, omega = locus.element, locus.omega
    draw_element_curve(axes, element, omega, "−1/N(A)", 1)
    curve = inverse(element, ratios_of(element, omega)[::-1], omega)  # by rising amplitude
    curve = curve[np.isfinite(curve)]
    curve = curve[abs(curve) <= max(LEAST, SHOWN * abs(curve).min())]
    critical_point(axes)
    show(axes, np.append(curve, -1.0), 0.5)
    middle = int(np.argmin(abs(_shares(curve) - 0.5)))
    arrow(axes, complex(curve[max(middle - 1, 0)]), complex(curve[middle]), color=line(1)["color"])
    axes.set_xlabel("real part of −1/N")
    axes.set_ylabel("imaginary part of −1/N")
    axes.grid(alpha=0.3)


def _shares(curve: Complexes) -> Reals:
    """Return the length of a curve up to each point, as a share."""
    length = np.append(0.0, np.cumsum(abs(np.diff(curve))))
    return np.asarray(length / (length[-1] or 1.0))
