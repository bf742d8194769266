"""A linear system whose inputs are the outputs of switched components, and whose outputs are their inputs.

The extended state holds the states of the plant and of the components, sine and cosine of each drive, and
one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arrays import Complexes, Places, Reals
from trimmer.errors import IllPosedLoopError, UnsupportedMotionError
from trimmer.loops.components.switched_component import Component
from trimmer.loops.components.threshold_component import ThresholdComponent
from trimmer.loops.drive import Drive, common_omega

NEGLIGIBLE = 1e-12
"""A product of a row and a column below this share of the product of their moduli is rounding."""


@dataclass(frozen=True, eq=False)
class Interconnection:
    """x' = A x + B v + drive_push d, with the output v_k of component k and its input e = C x + drive_gain d.

    Raises:
        IllPosedLoopError: if a force acts without delay on a rate on which it depends.
        UnsupportedMotionError: if a relay would slide along the edge of its dead zone.
    """

    A: Reals  # State matrix of the linear system, n x n; its units follow from those of the states
    B: Reals  # Input matrix, n x m for m components
    C: Reals  # Output matrix, m x n
    drive_push: Reals  # What the drives do to the rates of the states, n x number of drives
    drive_gain: Reals  # Factors with which the drives add to the inputs, m x number of drives
    components: tuple[Component, ...]  # The m components
    labels: tuple[str, ...]  # Their names, for events
    drives: tuple[Drive, ...]  # What is prescribed, d
    # The first components make up the nonlinear elements; the output of each is the sum of those of its
    # components with these factors
    element_factors: tuple[float, ...]

    def __post_init__(self) -> None:
        for k, (component, label) in enumerate(zip(self.components, self.labels, strict=True)):
            jumping = [j for j, other in enumerate(self.components) if other.output_jumps or j == k]
            works_against = effect(self.C[k], self.B[:, k]) < 0.0
            if isinstance(component, ThresholdComponent) and component.slides and works_against:
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


@dataclass(frozen=True, eq=False)
class Connection:
    """An element between an output and an input of a linear system."""

    parts: Sequence[tuple[Component, float]]  # Its components with the factors of their outputs
    labels: Sequence[str]  # Their names
    push: Reals  # What its output does to the rates of the states, (n,)
    row: Reals  # What its input takes of the states, (n,)
    # What it takes of the drives, (number of drives,); nothing if it is empty
    drive_gain: tuple[float, ...] = ()


def interconnected(
    A: Reals,
    connections: Sequence[Connection],
    drives: Sequence[Drive] = (),
    drive_push: Reals | None = None,
    of_elements: int | None = None,
) -> Interconnection:
    """Put elements between the outputs and the inputs of a linear system, n x n, with its drives.

    The first ``of_elements`` connections are those of elements, all if not given.
    """
    each = [(one, component, factor) for one in connections for component, factor in one.parts]
    nothing = (0.0,) * len(drives)
    elements = [factor for one in connections[:of_elements] for _, factor in one.parts]
    return Interconnection(
        A=A,
        B=np.column_stack([one.push * factor for one, _, factor in each]),
        C=np.array([one.row for one, _, _ in each]),
        drive_push=np.zeros((len(A), len(drives))) if drive_push is None else drive_push,
        drive_gain=np.array([one.drive_gain or nothing for one, _, _ in each]),
        components=tuple(component for _, component, _ in each),
        labels=tuple(label for one in connections for label in one.labels),
        drives=tuple(drives),
        element_factors=tuple(elements),
    )


def acts(row: Reals, column: Reals) -> bool:
    """Return whether the product of a row and a column is more than rounding."""
    return effect(row, column) != 0.0


def effect(row: Reals, column: Reals) -> float:
    """Return the product of a row and a column over the sum of its terms' moduli; 0 if it is rounding."""
    terms = row * (column / abs(column).max(initial=np.finfo(float).tiny))
    total, size = float(terms.sum()), float(abs(terms).sum())
    return total / size if abs(total) > NEGLIGIBLE * size else 0.0


@dataclass(frozen=True)
class StateLayout:
    """Positions in the extended state."""

    order: int  # Number of states of the plant, which come first
    first_states: tuple[int, ...]  # Position of the first own state of each component
    sine: int  # Position of the first drive's sine; its cosine follows, then those of the others
    size: int  # Number of entries; the last one is one
    drives: tuple[Drive, ...]  # What is prescribed
    following: tuple[int, ...] = ()  # Places of the states that follow from others

    ramp = False  # Time itself forces no loop
    recurrence = 1  # All drives return together after one period, if at all
    holding = slice(0, 0)  # Nothing samples a loop
    drifts = False  # Each period of the drives is as the others
    breaks = ()  # Nothing forces a loop but its drives
    travels = False  # Nor do its states move with a frame
    rates = ()  # It is not known which are rates of others
    measured_between = True  # A relay switches where its input is zero, so that states say little there

    @classmethod
    def of(cls, interconnection: Interconnection) -> StateLayout:
        """Return the layout of an interconnection: plant, components, drives, one."""
        counts = [component.state_count for component in interconnection.components]
        ends = np.cumsum([interconnection.order, *counts])
        sine = int(ends[-1])
        firsts = tuple(int(end) for end in ends[:-1])
        following = tuple(
            first + each.state_count - number
            for first, each in zip(firsts, interconnection.components, strict=True)
            for number in range(each.even_states, 0, -1)
        )
        # One sine and cosine are there without a drive, too: then they are zero.
        size = sine + 2 * max(len(interconnection.drives), 1) + 1
        return cls(interconnection.order, firsts, sine, size, interconnection.drives, following)

    @property
    def state_count(self) -> int:
        """Number of states: of plant and components."""
        return self.sine

    @property
    def forcing(self) -> int:
        """Number of entries that nothing forces: sine and cosine of each drive, and one."""
        return self.size - self.sine

    @property
    def period(self) -> float:
        """Period that the drives have in common, s; 0 without one."""
        return 2.0 * np.pi / self.omega if self.omega else 0.0

    def clock(self, periods: int, phase: float) -> float:
        """Return the time that the drives count, s, at a phase, s, after some periods."""
        return phase

    def changes_after(self, time: float) -> bool:
        """Nothing forces a loop but its drives."""
        return False

    @property
    def steady(self) -> Reals:
        """The entries that force the states without the drives, (forcing,)."""
        return np.asarray(np.eye(1, self.forcing, self.forcing - 1)[0])

    @property
    def independent(self) -> Places:
        """Places of all states but the share of a velocity that is left, on which nothing depends."""
        return np.delete(np.arange(self.sine), self.following)

    @property
    def omega(self) -> float:
        """Angular frequency of which those of the drives are multiples, rad/s; 0 without a drive."""
        return self._common[0] if self._common else 0.0

    @property
    def omegas(self) -> tuple[float, ...]:
        """Angular frequencies of the drives, rad/s, exact multiples where they have something in common."""
        if self._common:
            return tuple(order * self.omega for order in self._common[1])
        return tuple(drive.omega for drive in self.drives)

    @cached_property
    def _common(self) -> tuple[float, tuple[int, ...]] | None:
        return common_omega(self.drives)

    @property
    def repeats(self) -> bool:
        """Whether the drives, if any, have a period in common."""
        return self._common is not None

    @property
    def orders(self) -> tuple[int, ...]:
        """Multiples that occur."""
        return tuple(sorted(set(self._common[1]))) if self._common else ()

    @property
    def phasors(self) -> Complexes:
        """What gives sines, cosines, one: real parts of it times exp(i order omega t), (orders, forcing)."""
        found = np.zeros((len(self.orders), self.forcing), dtype=complex)
        for number, order in enumerate(self._common[1] if self._common else ()):
            turned = np.exp(1j * self.drives[number].phase) * np.array([-1j, 1.0])
            found[self.orders.index(order), 2 * number : 2 * number + 2] = turned
        return found

    @cached_property
    def kinds(self) -> tuple[slice, ...]:
        """Each state is of a kind of its own."""
        return tuple(slice(place, place + 1) for place in range(self.sine))

    @cached_property
    def lengths(self) -> Reals:
        """States are compared as they are."""
        return np.ones(self.sine)

    def felt(self, distances: Reals) -> Reals:
        """Return distances of states, (n, columns), as they are."""
        return distances

    def sizes(self, states: Reals, duration: float) -> Reals:
        """Return the largest modulus of each state over a motion, (n,), 1 for what does not move."""
        sizes: Reals = abs(states).max(axis=0)
        return np.where(sizes > 0.0, sizes, 1.0)

    def forcing_at(self, time: float, before: float = 0.0) -> Reals:
        """Return sine and cosine of each drive, zeros without one, and one, at a time, s."""
        if not self.drives:
            return np.array([0.0, 0.0, 1.0])
        each = zip(self.omegas, self.drives, strict=True)
        phases = [omega * (time + before) + drive.phase for omega, drive in each]
        waves = [wave for phase in phases for wave in (math.sin(phase), math.cos(phase))]
        return np.array([*waves, 1.0])

    def unit(self, position: int) -> Reals:
        """Return the row, shape (size,), that gives the entry at a position."""
        row = np.zeros(self.size)
        row[position] = 1.0
        return row

    @property
    def one(self) -> Reals:
        """The row, shape (size,), that gives the constant one."""
        return self.unit(self.size - 1)
