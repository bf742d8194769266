"""Energy balance of a moving trimmer: kinetic and potential energy, work of the pin, losses."""

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import final, overload

import numpy as np

from trimmer.arguments import require_instance
from trimmer.arrays import Reals
from trimmer.displacement import TrimmerBody
from trimmer.errors import UnsupportedMotionError
from trimmer.generated import linear_trimmer
from trimmer.hybrid.taylor import DEGREE
from trimmer.linear.model import InputChannels
from trimmer.loops.components.of_elements import components_of
from trimmer.loops.motion import LoopMotion
from trimmer.loops.trimmer_loop import TrimmerLoop
from trimmer.motion.motion import Energy, Motion
from trimmer.showing.shown import Tabular
from trimmer.showing.table import TERMS, Table

NODES = DEGREE + 1
"""Points of Gauss and Legendre in a step: exact for products of two polynomials of that degree."""
INTERVALS = 10_000  # Steps that are integrated at once
BODIES = len(TrimmerBody)


@final
@dataclass(frozen=True, repr=False)
class EnergyBalance(Tabular):
    """Energies of the four bodies and their springs, and works, from the start of a motion to its end, in J.

    Attributes:
        kinetic_at_start: 1/2 q'^T M q'.
        kinetic_at_end: The same at the end.
        potential_at_start: 1/2 q^T K q, the springs with the bridge in the middle.
        potential_at_end: The same at the end.
        pin_work: Work of the force k2 u + c2 u' of the bridge u on cutter and motor; k2 u if the bridge
            acts by its displacement alone.
        damping_loss: What the dampers dissipate.
        friction_loss: What the forces between bodies dissipate.
        bridge_energy: Largest 1/2 k2 u^2: what the bridge would put into its spring if no body moved. Where
            friction holds all bodies, nothing but rounding is left in the other terms, and this is what it is
            to be compared with.
    """

    kinetic_at_start: float
    kinetic_at_end: float
    potential_at_start: float
    potential_at_end: float
    pin_work: float
    damping_loss: float
    friction_loss: float
    bridge_energy: float = 0.0

    @property
    def kinetic(self) -> tuple[float, float]:
        """Kinetic energy at start and end."""
        return self.kinetic_at_start, self.kinetic_at_end

    @property
    def stored(self) -> tuple[float, float]:
        """Potential energy at start and end."""
        return self.potential_at_start, self.potential_at_end

    @property
    def work(self) -> float:
        """Work of the pin."""
        return self.pin_work

    @property
    def loss(self) -> float:
        """All losses together."""
        return self.damping_loss + self.friction_loss

    @property
    def residual(self) -> float:
        """Modulus of the sum of all terms over the largest one or the bridge's energy; 0 if nothing moves."""
        terms = (
            self.kinetic_at_end,
            -self.kinetic_at_start,
            self.potential_at_end,
            -self.potential_at_start,
            -self.pin_work,
            self.damping_loss,
            self.friction_loss,
        )
        largest = max(self.bridge_energy, *(abs(term) for term in terms))
        return abs(sum(terms)) / largest if largest > 0 else 0.0

    def _told(self) -> str:
        return f"work of the pin {self.pin_work:.6g} J; it closes to {self.residual:.1e} of its largest term"

    def _table(self) -> Table:
        terms = [(each.name, getattr(self, each.name)) for each in fields(self)]
        return Table("Energies and works", terms, TERMS)


@dataclass(frozen=True)
class _Sampled:
    """Signals of a motion at m times."""

    q: Reals  # Displacements of the bodies, shape (4, m), m
    rate: Reals  # Their velocities, shape (4, m), m/s
    bridge: Reals  # Displacement of the bridge relative to the motor, shape (m,), m
    bridge_rate: Reals  # Its velocity, shape (m,), m/s
    forces: Reals  # Forces between bodies, shape (number of components, m), N
    sliding: Reals  # Rates of the displacements that these act against, in the same shape, m/s


@overload
def energy_balance(motion: LoopMotion) -> EnergyBalance: ...
@overload
def energy_balance(motion: Motion) -> Energy: ...
def energy_balance(motion: Motion) -> Energy:
    """Balance the energy of a mechanism or a trimmer over a motion, which is ``motion.energy``.

    Args:
        motion: A motion of a mechanism or of a ``TrimmerLoop``.

    Raises:
        UnsupportedMotionError: if it is the motion of another loop.
    """
    require_instance("motion", motion, Motion, "a trimmer.Motion, which simulate returns")
    return motion.energy


def balance_of(motion: LoopMotion) -> EnergyBalance:
    """Balance the energy of a trimmer over a motion of a ``TrimmerLoop``, exact to rounding.

    The integrals are those of Gauss and Legendre on the exact flow, between events and within steps on
    which the flow is a polynomial to rounding. Masses, dampers and springs are those of the derivation.
    """
    loop = motion.loop
    if not isinstance(loop, TrimmerLoop):
        raise UnsupportedMotionError(f"an energy balance needs the motion of a TrimmerLoop, not of {loop!r}")
    values = loop.parameters.values()
    M, C, K = (
        np.array(matrix(*values), dtype=float)
        for matrix in (
            linear_trimmer.mass_matrix,
            linear_trimmer.damping_matrix,
            linear_trimmer.stiffness_matrix,
        )
    )
    works, farthest = np.zeros(3), 0.0
    for times, weights in _quadrature(motion):
        sampled = _sampled(motion, loop, times)
        works += _powers(loop, C, sampled) @ weights
        farthest = max(farthest, float(abs(sampled.bridge).max()))
    ends = _sampled(motion, loop, np.array([0.0, motion.duration]))
    kinetic, potential = (
        0.5 * np.einsum("it,ij,jt->t", x, matrix, x) for x, matrix in ((ends.rate, M), (ends.q, K))
    )
    bridge_energy = 0.5 * loop.parameters.k2 * farthest**2
    return EnergyBalance(*(float(each) for each in (*kinetic, *potential, *works, bridge_energy)))


def _powers(loop: TrimmerLoop, C: Reals, at: _Sampled) -> Reals:
    """Return the powers of the pin, of the dampers and of the forces between bodies, 3 x times, W."""
    force = loop.parameters.k2 * at.bridge
    if loop.channels is InputChannels.DISPLACEMENT_AND_VELOCITY:
        force = force + loop.parameters.c2 * at.bridge_rate
    pin = force * (at.rate[TrimmerBody.CUTTER.index] - at.rate[TrimmerBody.MOTOR.index])
    return np.array(
        [pin, np.einsum("it,ij,jt->t", at.rate, C, at.rate), (at.forces * at.sliding).sum(axis=0)]
    )


def _sampled(motion: LoopMotion, loop: TrimmerLoop, times: Reals) -> _Sampled:
    system, layout = loop.modes.system.interconnection, loop.modes.system.layout
    first = len(system.element_factors)
    velocity_gain = np.zeros(BODIES)
    if loop.channels is InputChannels.DISPLACEMENT_AND_VELOCITY:
        # The states are then the velocities less their rows of B2 u (``trimmer.linear.model.pin_model``).
        velocity_gain = np.array(linear_trimmer.input_matrix(*loop.parameters.values()))[BODIES:, 1]

    def rows_of(number: int) -> Reals:
        mode, states = loop.modes[number], np.eye(2 * BODIES, layout.size)
        bridge = np.array(system.element_factors) @ [each.output for each in mode.signals[:first]]
        between = mode.signals[first:]
        return np.vstack(
            [
                states[:BODIES],
                states[BODIES:] + np.outer(velocity_gain, bridge),
                bridge,
                bridge @ mode.flow,
                *(each.output for each in between),
                *(each.input_rate for each in between),
            ]
        )

    values = motion.values(times, rows_of)
    q, rate, (bridge, bridge_rate) = values[:4], values[4:8], values[8:10]
    forces, sliding = np.split(values[10:], 2)
    factors = [factor for friction in loop.frictions for _, factor in components_of(friction.law)]
    return _Sampled(q, rate, bridge, bridge_rate, np.reshape(factors, (-1, 1)) * forces, sliding)


def _quadrature(motion: LoopMotion) -> Iterator[tuple[Reals, Reals]]:
    """Yield times and weights that integrate over the motion, some steps at once."""
    begins = motion.log.start
    lengths = np.diff(np.append(begins, motion.duration))
    steps = np.ceil(lengths / motion.loop.modes.tables.step[motion.log.mode]).astype(int)
    widths = np.repeat(lengths / np.maximum(steps, 1), steps)
    places = np.arange(len(widths)) - np.repeat(np.cumsum(steps) - steps, steps)
    lows = np.repeat(begins, steps) + places * widths
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    for low, width in zip(_parts(lows), _parts(widths), strict=True):
        times = low[:, None] + 0.5 * width[:, None] * (1.0 + nodes)
        yield np.minimum(times, motion.duration).ravel(), (0.5 * width[:, None] * weights).ravel()


def _parts(values: Reals) -> list[Reals]:
    return [values[first : first + INTERVALS] for first in range(0, len(values), INTERVALS)]
