"""Listings A.3 to A.6, describing functions, repeated line by line.

Listing A.5 has the sign of its sixth line as printed: for γ > 1 its equation has complex roots only. It
leaves the choice among them to MATLAB's vpasolve; taken here is the one that begins next to half a turn,
where contact is made with a narrow gap.
"""

import math

import control
import numpy as np
from scipy.optimize import brentq

from report.numbers.thesis import TURN
from trimmer import InertiaBacklash, response_at
from trimmer.arrays import Complexes, Reals

STEPS = 60
START = complex(math.pi, -0.3)
"""Most steps of Newton's method to a contact angle of Listing A.5, and where the first begin, rad."""
RATIOS = np.linspace(0.005, 2.0, 200)  # b/A over the range that section 5.2.3 states
IN_GAPS = np.geomspace(0.52, 60.0, 400)  # Amplitudes over gap at which contours are held against each other
RESPONSE_OMEGA = TURN * np.linspace(200.0, 1000.0, 1601)
"""Angular frequencies of G between which contours are intersected with it, rad/s."""


def friction_listing(amplitude: complex, width: float) -> complex:
    """Return what Listing A.3 returns: its last line overwrites the zeros that its sixth line has set."""
    ratio = np.complex128(1 - width / amplitude)
    real = 0.5 + ratio * np.sqrt(1 - ratio**2) / np.pi + np.arcsin(ratio) / np.pi
    return complex(real - 1j * (1 - ratio**2) / np.pi)


def equivalent_listing(amplitude: float, force: float, gap: float, omega: float) -> complex:
    """Return what Listing A.6 returns for an amplitude (m), a force (N), a gap (m) and ω (rad/s)."""
    return friction_listing(amplitude, gap) - 4j * force / (math.pi * amplitude * omega)


def inertia_listing(ratio: float, scale: float) -> complex:
    """Return what Listing A.4 returns for its arguments Beta and w, with the root of its equation."""
    root = brentq(lambda x: scale * x - ratio - np.sin(scale * x), 0.0, 10.0 / scale)
    return inertia_formula(root, ratio)


def inertia_formula(angle: float, ratio: float) -> complex:
    """Return what the lines of Listing A.4 after its search make of the root that it found."""
    nested = np.sin(angle) + ratio
    real = (np.pi + 2 * np.sin(nested) - angle - np.sin(nested) * np.cos(nested)) / np.pi
    return complex(real, -((1 - np.cos(nested)) ** 2) / np.pi)


def equivalent_contour(force: float, gap: float, omega: float) -> Complexes:
    """Return -1/N of Listing A.6 over ``IN_GAPS`` for a force (N), a gap (m) and ω (rad/s)."""
    return np.array([-1 / equivalent_listing(gap * each, force, gap, omega) for each in IN_GAPS])


def inertia_contour(gap: float) -> Complexes:
    """Return -1/N of inertia-controlled backlash over ``IN_GAPS`` for a gap (m)."""
    element = InertiaBacklash(gap)
    return np.array([-1 / complex(element.describing_function(gap * each)) for each in IN_GAPS])


def mean_distance(contour: Complexes, other: Complexes) -> float:
    """Return the distance of the points of a contour from the nearest of another one, on average."""
    return float(abs(contour[:, np.newaxis] - other).min(axis=1).mean())


class NoRootError(ArithmeticError):
    """Newton's method found no root of the listing's sixth line."""


def listing_contour(gamma: float) -> Complexes:
    """Return -1/N over ``RATIOS`` for one γ > 1.

    Raises:
        NoRootError: if the root of line 6 is lost.
    """
    root, values = START, []
    for ratio in RATIOS:
        root = contact_angle(gamma, float(ratio), root)
        values.append(-1 / listing_gain(gamma, float(ratio), root))
    return np.array(values)


def contact_angle(gamma: float, ratio: float, start: complex) -> complex:
    """Solve line 6, sqrt(1 - γ²) - β = sin x + γ² exp((atan(1/γ) - x)/γ) / sqrt(1 + γ²).

    Raises:
        NoRootError: if Newton's method does not find a root from the start, rad.
    """
    x = start
    for _ in range(STEPS):
        flight = gamma * np.exp((math.atan(1 / gamma) - x) / gamma) / math.sqrt(1 + gamma**2)
        residual = np.sin(x) + gamma * flight - (complex(1 - gamma**2) ** 0.5 - ratio)
        step = complex(residual / (np.cos(x) - flight))
        x -= step
        if abs(step) < 1e-13:
            return x
    raise NoRootError(f"line 6 of Listing A.5 was not solved for gamma = {gamma:g}, b/A = {ratio:g}")


def listing_gain(gamma: float, ratio: float, angle: complex) -> complex:
    """Return N by lines 11 to 21, for b/A and an angle of contact, rad."""
    separation, root = math.atan(1 / gamma), math.sqrt(1 + gamma**2)
    sine, cosine = complex(np.sin(angle)), complex(np.cos(angle))
    real = (
        (1 + gamma**2) / (2 * gamma**2) * (separation - angle + math.pi + sine * cosine)
        + 1 / (2 * gamma)
        + (ratio - root) / gamma * (cosine / gamma - sine)
        - sine**2 / gamma
        - sine * cosine
    )
    imaginary = (
        1
        + 1 / (2 * gamma**2)
        + (1 - gamma**2) / (2 * gamma**2) * sine**2
        + (ratio - root) / gamma * (sine / gamma + cosine)
        + sine * cosine / gamma
    )
    return 2 * gamma**2 / (math.pi * (1 + gamma**2)) * (real - 1j * imaginary)


def intersections(contour: Complexes, system: control.lti.LTI) -> tuple[float, ...]:
    """Return the angular frequencies, rad/s, at which a polygon in the plane of G crosses the locus of G."""
    response = response_at(system, RESPONSE_OMEGA)
    start, side = contour[:-1, np.newaxis], np.diff(contour)[:, np.newaxis]
    locus, along = response[np.newaxis, :-1], np.diff(response)[np.newaxis, :]
    with np.errstate(divide="ignore", invalid="ignore"):
        parallel = _cross(side, along)
        on_side = _cross(locus - start, along) / parallel
        on_locus = _cross(locus - start, side) / parallel
    hit = (on_side >= 0) & (on_side < 1) & (on_locus >= 0) & (on_locus < 1)
    _, step = np.nonzero(hit)
    omegas = RESPONSE_OMEGA[step] + on_locus[hit] * np.diff(RESPONSE_OMEGA)[step]
    return tuple(sorted(map(float, omegas)))


def _cross(first: Complexes, second: Complexes) -> Reals:
    return (np.conj(first) * second).imag
