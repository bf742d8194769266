"""The search for exact limit cycles of a closed loop, from predictions of harmonic balance."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.solve import limit_cycles
from trimmer.errors import OrbitNotFoundWarning
from trimmer.motion.loops import ClosedLoop
from trimmer.orbits.balanced_start import balanced_starts
from trimmer.orbits.describe import orbit_of
from trimmer.orbits.guess import Start, starting_point
from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.orbits.shooting import Return, Shot, solve

if TYPE_CHECKING:
    import control

    from trimmer.elements.element import Element


def periodic_orbits(
    system: control.LTI,
    element: Element,
    guesses: Sequence[LimitCycle | tuple[float, float]] | None = None,
) -> list[PeriodicOrbit]:
    """Find exact periodic motions of the loop 1 + N G = 0, stable or not, by Newton's method.

    Each guess gives a first harmonic from which the motion is followed exactly through its events for half a
    period; the state that returns with its signs changed belongs to an orbit. Where that fails, as with brief
    contacts, more harmonics are balanced first. All elements are odd, so the orbits that harmonic balance can
    predict have this symmetry.

    Args:
        system: G, strictly proper, one input and one output, continuous in time.
        element: The nonlinear element.
        guesses: Limit cycles, or pairs of amplitude (in the unit of the element's input) and omega (rad/s);
            those of ``limit_cycles`` if none are given.

    Returns:
        The orbits found, by falling amplitude, each once.

    Raises:
        ValueError: if a guess is not positive and finite, or the loop is not well posed.
        UnsupportedMotionError: if the element or the system cannot be simulated.

    Warns:
        OrbitNotFoundWarning: for each guess from which no orbit was found; often there is none.
    """
    loop = ClosedLoop(system, element)
    orbits: list[PeriodicOrbit] = []
    for guess in limit_cycles(system, element) if guesses is None else guesses:
        amplitude, omega = (
            (guess.amplitude, guess.omega) if isinstance(guess, LimitCycle) else _checked(*guess)
        )
        orbit = _near(loop, amplitude, omega, guess if isinstance(guess, LimitCycle) else None)
        if orbit is None:
            warnings.warn(
                f"no periodic orbit was found from the amplitude {amplitude:.6g} and omega {omega:.6g} rad/s",
                OrbitNotFoundWarning,
                stacklevel=2,
            )
        elif not any(_same(orbit, other) for other in orbits):
            orbits.append(orbit)
    return sorted(orbits, key=lambda orbit: -orbit.amplitude)


def _checked(amplitude: float, omega: float) -> tuple[float, float]:
    for name, value in (("amplitude", amplitude), ("omega", omega)):
        if not (math.isfinite(value) and value > 0):
            raise ValueError(f"{name} of a guess must be positive and finite, not {value!r}")
    return amplitude, omega


def _same(first: PeriodicOrbit, second: PeriodicOrbit) -> bool:
    return math.isclose(first.period, second.period, rel_tol=1e-9) and math.isclose(
        first.amplitude, second.amplitude, rel_tol=1e-9
    )


def _near(
    loop: ClosedLoop, amplitude: float, omega: float, prediction: LimitCycle | None
) -> PeriodicOrbit | None:
    if np.isnan(loop.element.describing_function(amplitude, omega)):
        return None
    first = starting_point(loop, amplitude, omega), omega
    for start, trial in chain([first], balanced_starts(loop, amplitude, omega)):
        found = _shot(loop, start, trial)
        if found is not None:
            return orbit_of(loop, *found, prediction)
    return None


def _shot(loop: ClosedLoop, start: Start, omega: float) -> tuple[Return, Shot] | None:
    problem = Return(loop.modes, mirrored=True, driven=False, sizes=start.sizes)
    shot = solve(problem, start.mode, start.state, math.pi / omega)
    return None if shot is None else (problem, shot)
