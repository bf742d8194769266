"""How far a system is a low-pass filter: bandwidth, roll-off, and attenuation of harmonics.

The describing-function method needs a linear part that passes the fundamental and suppresses its harmonics
(the filtering hypothesis, equation 2.26 of the thesis).
"""

import math

import control
import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import finite_number, real_values, whole_number
from trimmer.arrays import Reals
from trimmer.linear.crossings import gain_crossings
from trimmer.linear.frequency_response import UnsupportedSystemError, response_at
from trimmer.linear.zero_pole_gain import ZeroPoleGain

DECIBELS_PER_DECADE = 20.0  # Roll-off of one pole in excess of the zeros, dB per decade


def bandwidth(system: control.lti.LTI, dbdrop: float = -3.0) -> float:
    """Find the lowest frequency where |G| falls below its value at zero frequency by a number of decibels.

    Definition and arguments are those of ``control.bandwidth``; without a gain at zero frequency this is an
    error, where that gives NaN or infinity. A drop of 3 dB is a factor 0.7079, not 1/sqrt(2).

    Args:
        system: A system with one input and one output.
        dbdrop: Level relative to the gain at zero frequency, dB, < 0.

    Returns:
        Angular frequency, rad/s; infinite if |G| never falls so far.

    Raises:
        ValueError: if ``dbdrop`` is not negative and finite.
        UnsupportedSystemError: see ``require_siso``; or if G(0) is zero or infinite.
    """
    return next(iter(bandwidth_crossings(system, dbdrop)), math.inf)


def bandwidth_crossings(system: control.lti.LTI, dbdrop: float = -3.0) -> tuple[float, ...]:
    """Find all frequencies, rad/s, where |G| crosses the level that defines the bandwidth, in rising order.

    A resonance above the bandwidth can lift |G| past the level again. Arguments and errors are those of
    ``bandwidth``.
    """
    if not finite_number("dbdrop", dbdrop, "dB") < 0:
        raise ValueError(f"dbdrop must be a negative number of decibels, not {dbdrop!r}")
    static_gain = abs(ZeroPoleGain.of(system).static_gain)
    if static_gain == 0 or not math.isfinite(static_gain):
        raise UnsupportedSystemError(
            f"a system whose gain at zero frequency is {static_gain:g} has no bandwidth relative to it"
        )
    return gain_crossings(system, static_gain * 10 ** (dbdrop / 20))


def asymptotic_roll_off(system: control.lti.LTI) -> float:
    """Return the slope of |G| towards infinite frequency, dB per decade: -20 for each pole more than zeros.

    Args:
        system: A system with one input and one output.

    Raises:
        UnsupportedSystemError: see ``require_siso``.
    """
    return -DECIBELS_PER_DECADE * ZeroPoleGain.of(system).relative_degree


def local_slope(system: control.lti.LTI, omega: ArrayLike) -> Reals:
    """Evaluate the slope of |G| on the Bode plot, analytically from zeros and poles.

    Args:
        system: A system with one input and one output.
        omega: Angular frequencies, rad/s, > 0, of any shape.

    Returns:
        Slopes of the shape of ``omega``, dB per decade.

    Raises:
        UnsupportedSystemError: see ``require_siso``.
    """
    factored = ZeroPoleGain.of(system)
    frequencies = real_values("omega", omega)
    slopes = [each * factored.log_gain_slope_terms(each).sum() for each in frequencies.ravel()]
    return DECIBELS_PER_DECADE * np.reshape(slopes, frequencies.shape)


def filtering_ratio(system: control.lti.LTI, omega: ArrayLike, harmonic: int) -> Reals:
    """Evaluate |G(j n omega)| / |G(j omega)|: what is left of harmonic n (equation 2.26 of the thesis).

    Args:
        system: A system with one input and one output.
        omega: Angular frequencies of the fundamental, rad/s, of any shape.
        harmonic: n >= 2.

    Returns:
        Ratios of the shape of ``omega``; small where the filtering hypothesis holds.

    Raises:
        ValueError: if the harmonic is less than 2.
        UnsupportedSystemError: see ``require_siso``.
    """
    if whole_number("harmonic", harmonic) < 2:
        raise ValueError(f"harmonics above the fundamental start at 2, not {harmonic!r}")
    fundamental = real_values("omega", omega)
    passed = response_at(system, harmonic * fundamental) / response_at(system, fundamental)
    return np.asarray(np.abs(passed))
