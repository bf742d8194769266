"""A linear system whose inputs are the outputs of switched components, and whose outputs are their inputs.

The extended state holds the states of the plant and of the components, sine and cosine of the drive, and one.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import control
import numpy as np
import scipy.signal

from trimmer.arguments import shown
from trimmer.errors import IllPosedLoopError, UnsupportedMotionError
from trimmer.loops.threshold_component import ThresholdComponent

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Places, Reals
    from trimmer.loops.loops import Drive
    from trimmer.loops.switched_component import Component


def require_system(system: object) -> None:
    """Check that a system is one of python-control's transfer functions or state-space models.

    Raises:
        UnsupportedMotionError: if it is neither.
    """
    if not isinstance(system, control.StateSpace | control.TransferFunction):
        raise UnsupportedMotionError(
            f"system: give a control.StateSpace or control.TransferFunction, not {type(system).__name__} "
            f"({shown(system)})"
        )


def realized(system: control.LTI) -> control.StateSpace:
    """Return a state-space model with one input and one output, which is the system itself if it is one.

    Raises:
        UnsupportedMotionError: if the system is none of python-control's transfer functions and state-space
            models in continuous time, has several inputs or outputs, or is improper.
        ValueError: if a coefficient is not finite.
    """
    require_system(system)
    if system.isdtime(strict=True):
        raise UnsupportedMotionError("the system must be continuous in time, not sampled")
    if (system.ninputs, system.noutputs) != (1, 1):
        raise UnsupportedMotionError(
            f"the system must have one input and one output, not {system.ninputs} and {system.noutputs}"
        )
    if isinstance(system, control.StateSpace):
        _require_finite(A=system.A, B=system.B, C=system.C, D=system.D)
        return system
    numerator, denominator = system.num[0][0], system.den[0][0]
    _require_finite(numerator=numerator, denominator=denominator)
    if len(numerator) > len(denominator):
        raise UnsupportedMotionError("the transfer function has more zeros than poles")
    return control.ss(*scipy.signal.tf2ss(numerator, denominator))


def _require_finite(**parts: Reals) -> None:
    for name, values in parts.items():
        if not np.isfinite(values).all():
            raise ValueError(f"{name} of the system must be finite, not {values.tolist()!r}")


NEGLIGIBLE = 1e-12
"""A product of a row and a column below this share of the product of their moduli is rounding."""


@dataclass(frozen=True, eq=False)
class Interconnection:
    """x' = A x + B v, with the output v_k of component k and its input e = C x + D v + drive_gain * drive.

    Attributes:
        A: State matrix of the linear system, n x n; its units follow from those of the states.
        B: Input matrix, n x m for m components.
        C: Output matrix, m x n.
        D: Direct feedthrough, m x m, which must be zero.
        drive_gain: Factor with which the drive adds to each input, shape (m,).
        components: The m components.
        labels: Their names, for events.
        drive: The prescribed motion of the pin; None without one.
        element_factors: The first components make up the nonlinear element; its output is the sum of theirs
            with these factors.

    Raises:
        IllPosedLoopError: if an output acts without delay on an input.
        UnsupportedMotionError: if a relay would slide along the edge of its dead zone.
    """

    A: Reals
    B: Reals
    C: Reals
    D: Reals
    drive_gain: Reals
    components: tuple[Component, ...]
    labels: tuple[str, ...]
    drive: Drive | None
    element_factors: tuple[float, ...]

    def __post_init__(self) -> None:
        for k, (component, label) in enumerate(zip(self.components, self.labels, strict=True)):
            jumping = [j for j, other in enumerate(self.components) if other.output_jumps or j == k]
            if self.D[k].any():
                raise IllPosedLoopError(
                    f"{label}: an output acts on its input at once; the system must be strictly proper"
                )
            if isinstance(component, ThresholdComponent) and component.slides and _slides(self, k):
                raise UnsupportedMotionError(
                    f"{label}: without hysteresis it would slide along the edge of the dead zone, which is "
                    "not followed; give it hysteresis, or a system with two more poles than zeros"
                )
            if component.continuous_rates and any(acts(self.C[k], self.B[:, j]) for j in jumping):
                raise IllPosedLoopError(
                    f"{label}: a force acts on its own rate at once; give a system with two more poles than "
                    "zeros, such as a trimmer whose pin acts by its displacement alone"
                )

    @property
    def order(self) -> int:
        """Number of states of the linear system."""
        return int(self.A.shape[0])


def _slides(system: Interconnection, k: int) -> bool:
    """Return whether an output works against the rate of its own input."""
    return effect(system.C[k], system.B[:, k]) < 0.0


def acts(row: Reals, column: Reals) -> bool:
    """Return whether the product of a row and a column is more than rounding."""
    return effect(row, column) != 0.0


def effect(row: Reals, column: Reals) -> float:
    """Return the product of a row and a column over the sum of its terms' moduli; 0 if it is rounding."""
    terms = row * (column / abs(column).max(initial=np.finfo(float).tiny))
    total, size = float(terms.sum()), float(abs(terms).sum())
    return total / size if abs(total) > NEGLIGIBLE * size else 0.0


@dataclass(frozen=True)
class Layout:
    """Positions in the extended state.

    Attributes:
        order: Number of states of the plant, which come first.
        first_states: Position of the first own state of each component.
        sine: Position of the drive's sine; its cosine follows.
        size: Number of entries; the last one is one.
        drive: The prescribed motion of the pin; None without one.
        following: Places of the states that follow from others.
    """

    order: int
    first_states: tuple[int, ...]
    sine: int
    size: int
    drive: Drive | None
    following: tuple[int, ...] = ()

    @classmethod
    def of(cls, interconnection: Interconnection) -> Layout:
        """Return the layout of an interconnection: plant, components, drive, one."""
        counts = [component.state_count for component in interconnection.components]
        ends = np.cumsum([interconnection.order, *counts])
        sine = int(ends[-1])
        firsts = tuple(int(end) for end in ends[:-1])
        following = tuple(
            first + each.state_count - number
            for first, each in zip(firsts, interconnection.components, strict=True)
            for number in range(each.even_states, 0, -1)
        )
        return cls(interconnection.order, firsts, sine, sine + 3, interconnection.drive, following)

    @property
    def state_count(self) -> int:
        """Number of states: of plant and components."""
        return self.sine

    @property
    def forcing(self) -> int:
        """Number of entries that nothing forces: sine and cosine of the drive, and one."""
        return self.size - self.sine

    @property
    def period(self) -> float:
        """Period of the drive, s; 0 without one."""
        return 0.0 if self.drive is None else self.drive.period

    @property
    def ramp(self) -> bool:
        """Time itself forces no loop."""
        return False

    @property
    def independent(self) -> Places:
        """Places of all states but the share of a velocity that is left, on which nothing depends."""
        return np.delete(np.arange(self.sine), self.following)

    @property
    def travels(self) -> bool:
        """Nor do its states move with a frame."""
        return False

    @property
    def omega(self) -> float:
        """Angular frequency of the drive, rad/s; 0 without one."""
        return 0.0 if self.drive is None else self.drive.omega

    @property
    def orders(self) -> tuple[int, ...]:
        """The drive is one sine."""
        return () if self.drive is None else (1,)

    @property
    def phasors(self) -> Complexes:
        """What gives sine, cosine and one as real parts of these times exp(i omega t), (orders, 3)."""
        if self.drive is None:
            return np.zeros((0, 3), dtype=complex)
        return np.asarray(np.exp(1j * self.drive.phase) * np.array([[-1j, 1.0, 0.0]]))

    @cached_property
    def kinds(self) -> tuple[slice, ...]:
        """Each state is of a kind of its own."""
        return tuple(slice(place, place + 1) for place in range(self.sine))

    @property
    def rates(self) -> tuple[slice, ...]:
        """It is not known which are rates of others."""
        return ()

    @property
    def measured_between(self) -> bool:
        """A relay switches where its input is zero, so that states say little there."""
        return True

    def felt(self, distances: Reals) -> Reals:
        """Return distances of states, (n, columns), as they are."""
        return distances

    def sizes(self, states: Reals, duration: float) -> Reals:
        """Return the largest modulus of each state over a motion, (n,), 1 for what does not move."""
        sizes: Reals = abs(states).max(axis=0)
        return np.where(sizes > 0.0, sizes, 1.0)

    def forcing_at(self, time: float, before: float = 0.0) -> Reals:
        """Return sine and cosine of the drive, zeros without one, and one, at a time, s."""
        if self.drive is None:
            return np.array([0.0, 0.0, 1.0])
        phase = self.drive.omega * (time + before) + self.drive.phase
        return np.array([math.sin(phase), math.cos(phase), 1.0])

    def unit(self, position: int) -> Reals:
        """Return the row, shape (size,), that gives the entry at a position."""
        row = np.zeros(self.size)
        row[position] = 1.0
        return row

    @property
    def one(self) -> Reals:
        """The row, shape (size,), that gives the constant one."""
        return self.unit(self.size - 1)
