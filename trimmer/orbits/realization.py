"""States in which rounding does not hide an orbit: a motion does not depend on those of its linear system.

Where states mix what differs by orders of magnitude, such as displacements and velocities in SI units, or the
states of slow and fast modes, the small is lost in the rounding of the large, and no return closes. There an
orbit is looked for in the states of the modes, and told in those that were given.
"""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Generic, TypeVar

import control
import numpy as np
import scipy.linalg

from trimmer.arrays import Complexes, Reals
from trimmer.loops.loops import ClosedLoop, Loop, OpenLoop
from trimmer.orbits.periodic_orbit import Given, PeriodicOrbit

LOSS = 1e4  # Loss of digits, as a factor of rounding, that leaves a return closed by far
GAIN = 10.0  # Factor by which other states have to lose less to be worth while
WIDTHS = (1e-6, 1e-3, 1e-1)
"""Distances of poles, as shares of their moduli, up to which their modes are not told apart."""
SLOW = 1e-3
"""Modulus of a pole as a share of the largest one below which its distance to others counts in that one's."""
BESIDE = 0.1
"""Distance from the imaginary axis, as a share of a pole's modulus, at which responses are looked at."""

LoopT = TypeVar("LoopT", bound=Loop)


@dataclass(frozen=True, eq=False)
class Restated(Generic[LoopT]):
    """A loop, and the same one with the states in which its orbits are looked for."""

    given: LoopT  # The loop as it was given
    loop: LoopT  # The same with other states z of its linear system
    # Matrix T of the given states T z, n x n; None if the states are those that were given
    states: Reals | None

    def told(self, orbit: PeriodicOrbit) -> PeriodicOrbit:
        """Return an orbit of the loop in the states that were given."""
        if self.states is None:
            return orbit
        return replace(orbit, given=Given(self.given, self.states))


def restated(loop: LoopT) -> Restated[LoopT]:
    """Return a loop with states in which little is lost: those that were given if they are such."""
    if not isinstance(loop, ClosedLoop | OpenLoop):
        return Restated(loop, loop, None)
    model = loop.model
    loss = _loss(model)
    if not loss > LOSS:
        return Restated(loop, loop, None)
    others = [(states, _with(model, states)) for states in _of_modes(model.A)]
    best = min(others, key=lambda each: _loss(each[1]), default=None)
    if best is None or not GAIN * _loss(best[1]) < loss:
        return Restated(loop, loop, None)
    return Restated(loop, replace(loop, system=best[1]), best[0])


def _with(model: control.StateSpace, states: Reals) -> control.StateSpace:
    """Return a system with the states z that give its own ones as T z."""
    A, B = np.linalg.solve(states, model.A @ states), np.linalg.solve(states, model.B)
    return control.ss(A, B, model.C @ states, model.D)


def _loss(model: control.StateSpace) -> float:
    """Return by which factor rounding of A, B and C enters the response, near its poles; inf if it has none.

    It is the same for states in other units.
    """
    A, B, C = model.A, model.B[:, 0], model.C[0]
    moduli = abs(np.linalg.eigvals(A))
    moduli = moduli[moduli > SLOW * moduli.max(initial=0.0)]
    losses = []
    for point in (BESIDE + 1j) * moduli:
        response = np.linalg.inv(point * np.eye(len(A)) - A)
        sizes = abs(response)
        lost = abs(C) @ (sizes @ abs(A) @ sizes + 2.0 * sizes) @ abs(B)
        gain = abs(C @ response @ B)
        losses.append(lost / gain if gain else np.inf)
    return float(max(losses, default=1.0))


def _of_modes(A: Reals) -> Iterator[Reals]:
    """Yield matrices T, n x n, of states T z in which modes with poles apart do not act on each other."""
    balanced, units = scipy.linalg.matrix_balance(A, permute=False, separate=True)
    poles = np.linalg.eigvals(balanced)
    upper = poles.real + 1j * abs(poles.imag)
    scale = SLOW * float(abs(poles).max(initial=0.0))
    moduli = np.maximum(abs(upper), scale)
    for width in WIDTHS:
        near = abs(upper[:, None] - upper) <= width * np.maximum(moduli[:, None], moduli)
        together = np.linalg.matrix_power(near.astype(float), len(A)) > 0.0
        clusters = [upper[row] for row in np.unique(together, axis=0)]
        with suppress(np.linalg.LinAlgError):  # They cannot be told apart so finely.
            states = np.hstack([_basis(balanced, cluster, upper) for cluster in clusters])
            full = np.linalg.matrix_rank(states / np.linalg.norm(states, axis=0)) == len(A)
            if full and states.shape == A.shape:  # Where poles are rounding, so is whose motions are whose.
                yield units[0][:, None] * states


def _basis(A: Reals, cluster: Complexes, poles: Complexes) -> Reals:
    """Return the motions, n x k, that have some of the poles alone, in units in which they are alike."""
    others = poles[~np.isin(poles, cluster)]

    def inside(real: float, imaginary: float) -> bool:
        pole = complex(real, abs(imaginary))
        return bool(abs(cluster - pole).min() < abs(others - pole).min(initial=np.inf))

    form, vectors, count = scipy.linalg.schur(A, sort=inside)
    units = scipy.linalg.matrix_balance(form[:count, :count], permute=False, separate=True)[1][0]
    basis: Reals = vectors[:, :count] * units
    return basis
