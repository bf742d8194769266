"""Harmonic balance of a plant with several elements, in the odd harmonics up to an order."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.optimize

from trimmer.arguments import whole_number
from trimmer.arrays import Complexes, Reals
from trimmer.balance.many_harmonics.starts import responses, starts
from trimmer.balance.many_harmonics.steady_response import steady_response
from trimmer.balance.many_harmonics.trigonometric import OddPolynomial
from trimmer.elements import CoulombFriction, Element
from trimmer.loops.feedback import Feedback
from trimmer.mechanism.read_only import ReadOnly
from trimmer.messages import listed
from trimmer.showing.shown import Shown, Tabular, counted
from trimmer.showing.table import Table, attributes

ORDER = 15  # Highest harmonic if none is asked for
MOST_STARTS = 40  # Starts that are tried, the nearest to a balance first
BALANCED = 1e-9
"""Largest imbalance of any harmonic, relative to the first one of its element, that counts as a solution."""
NO_OUTPUT = 1e3  # Imbalance where an element has no steady output
EVALUATIONS = 20  # Evaluations for each unknown after which a solution is given up
SMALLEST = 1e-3  # Share of its start below which an amplitude has left it for nothing
SAME = 1e-6  # Relative difference of frequency and amplitudes up to which two solutions are one
BEYOND = 100.0  # How far beyond the slowest and the fastest mode of the plant frequencies are searched


@dataclass(frozen=True, eq=False, repr=False)
class BalancedMotion(Shown):
    """A motion whose odd harmonics balance up to an order.

    Attributes:
        order: Highest harmonic.
        omega: Angular frequency of the first one, rad/s.
        inputs: By element, complex amplitudes c_1, c_3 ... of its input Im Σ c_n exp(j n omega t).
        residual: Largest imbalance of a harmonic, relative to the first one of its element.
        change: By how much omega and amplitudes differ from those of the last lower order at most, relative:
            no bound, but what the last harmonics have changed. NaN of order 1.
    """

    order: int
    omega: float
    inputs: Mapping[str, Complexes]
    residual: float
    change: float

    @property
    def frequency(self) -> float:
        """Frequency of the first harmonic, Hz."""
        return self.omega / math.tau

    @property
    def period(self) -> float:
        """Time after which it repeats, s."""
        return math.tau / self.omega

    @cached_property
    def amplitudes(self) -> Mapping[str, float]:
        """Half of peak to peak of the input of each element, in its unit."""
        return ReadOnly({name: OddPolynomial(each).largest() for name, each in self.inputs.items()})

    def _told(self) -> str:
        sizes = ", ".join(f"{name} {size:.6g}" for name, size in self.amplitudes.items())
        return f"order {self.order}, {self.frequency:.6g} Hz, amplitudes {sizes}"


@dataclass(frozen=True, eq=False, repr=False)
class FeedbackBalance(Tabular):
    """Motions of a plant with several elements that harmonic balance predicts. There is no certificate.

    Attributes:
        motions: Those that were found, by frequency. Whether they are stable is not told.
        loop: The loop.
        order: Highest harmonic that was asked for.
        omegas: Angular frequencies that were searched, rad/s.
        tried: Number of starts that were tried.
        left: Number of further starts that were not.
    """

    motions: tuple[BalancedMotion, ...]
    loop: Feedback
    order: int
    omegas: tuple[float, float]
    tried: int
    left: int

    @property
    def message(self) -> str:
        """What came out, and what is not told."""
        told = [
            f"{counted(len(self.motions), 'motion')} found from {counted(self.tried, 'start')} on a grid",
            "no certificate: others may exist, and whether these are stable is not told; periodic_orbits and "
            "respond find exact motions",
        ]
        if self.left:
            told.append(f"{counted(self.left, 'further start')} left out")
        short = [each.order for each in self.motions if each.order < self.order]
        if short:
            told.append(f"of {len(short)} no solution was found beyond order {min(short)}")
        rubbing = [
            name
            for name, each in self.loop.elements.items()
            if isinstance(each, CoulombFriction) and each.breakaway > each.force
        ]
        if rubbing:
            told.append(f"{listed(rubbing)}: what stick holds beyond the sliding force is left out")
        return "; ".join(told)

    def _told(self) -> str:
        return self.message

    def _table(self) -> Table:
        columns = attributes(order="", omega="rad/s", frequency="Hz", residual="", change="")
        return Table("Balanced motions", self.motions, columns)


def feedback_balance(
    loop: Feedback, omega_range: tuple[float, float] | None = None, order: int = ORDER
) -> FeedbackBalance:
    """Balance odd harmonics of several elements, from starts on a grid of frequency and amplitude.

    The range is in rad/s, from the modes of the plant if not given.
    """
    if whole_number("order", order, 1) % 2 == 0:
        raise ValueError(f"order must be odd, not {order!r}: elements have no even harmonics")
    equations = _Equations(loop)
    omegas = omega_range or _omegas(loop)
    begun = starts(loop.plant, equations.elements, equations.places, omegas)
    found: list[BalancedMotion] = []
    for start in begun[:MOST_STARTS]:
        first = equations.solved(1, start.inputs[:, None], start.omega)
        if first is None or not omegas[0] <= first.omega <= omegas[1]:
            continue
        if not any(_same(first, each) for each in found):
            found.append(first)
    motions = sorted((equations.raised(each, order) for each in found), key=lambda each: each.omega)
    distinct = [
        each for k, each in enumerate(motions) if not any(_same(each, other) for other in motions[:k])
    ]
    tried = min(len(begun), MOST_STARTS)
    return FeedbackBalance(tuple(distinct), loop, order, omegas, tried, len(begun) - tried)


def _omegas(loop: Feedback) -> tuple[float, float]:
    sizes = np.abs(loop.plant.poles())
    sizes = sizes[sizes > 1e-9 * sizes.max(initial=0.0)]
    lowest, highest = sizes.min(initial=1.0 if not len(sizes) else np.inf), sizes.max(initial=0.0) or 1.0
    return float(lowest / BEYOND), float(highest * BEYOND)


def _same(first: BalancedMotion, other: BalancedMotion) -> bool:
    pairs = [(first.omega, other.omega)]
    pairs += [(first.amplitudes[name], other.amplitudes[name]) for name in first.amplitudes]
    return all(math.isclose(one, two, rel_tol=SAME) for one, two in pairs)


@dataclass(frozen=True, eq=False)
class _Equations:
    """E_n = G(j n omega) U_n(E) for the inputs E of all elements and their outputs U."""

    loop: Feedback

    @property
    def elements(self) -> tuple[Element, ...]:
        return tuple(self.loop.elements.values())

    @cached_property
    def places(self) -> tuple[list[int], list[int]]:
        plant = self.loop.plant
        taken = [plant.output_labels.index(name) for name in self.loop.elements]
        return taken, [plant.input_labels.index(name) for name in self.loop.elements]

    def raised(self, motion: BalancedMotion, order: int) -> BalancedMotion:
        """Return the solution of the highest order up to one that is reached step by step."""
        for each in range(3, order + 1, 2):
            inputs = np.array(list(motion.inputs.values()))
            guess = np.append(inputs, np.zeros((len(inputs), 1)), axis=1)
            higher = self.solved(each, guess, motion.omega, motion)
            if higher is None:
                break
            motion = higher
        return motion

    def solved(
        self, order: int, guess: Complexes, omega: float, lower: BalancedMotion | None = None
    ) -> BalancedMotion | None:
        """Solve near a guess, (elements, harmonics), and omega, rad/s; None if there is no solution."""
        sizes = np.abs(guess[:, 0])
        if not (sizes > 0).all():
            return None
        # Turned so that the first harmonic of the first element is real; omega stands in its other part.
        turned = guess * np.exp(-1j * np.angle(guess[0, 0]) * (2 * np.arange(guess.shape[1]) + 1))
        start = turned / sizes[:, None]
        start[0, 0] = 1.0 + 1.0j

        def unpacked(unknowns: Reals) -> tuple[Complexes, float]:
            inputs = unknowns.view(np.complex128).reshape(guess.shape).copy()
            ratio = inputs[0, 0].imag
            inputs[0, 0] = inputs[0, 0].real
            return inputs * sizes[:, None], ratio * omega

        def imbalance(unknowns: Reals) -> Reals:
            inputs, trial = unpacked(unknowns)
            outputs = self._outputs(inputs, trial) if trial > 0 else None
            if outputs is None:
                return np.full(unknowns.size, NO_OUTPUT)
            numbers = np.arange(1.0, 2.0 * guess.shape[1], 2.0)
            G = responses(self.loop.plant, *self.places, np.asarray(trial * numbers))
            left = (inputs - np.einsum("nij,jn->in", G, outputs)) / sizes[:, None]
            return np.ascontiguousarray(left).view(np.float64).ravel()

        found = scipy.optimize.root(
            imbalance,
            np.ascontiguousarray(start).view(np.float64).ravel(),
            options={"xtol": 1e-13, "maxfev": EVALUATIONS * (start.size + 5)},
        )
        inputs, solved = unpacked(found.x)
        residual = float(abs(imbalance(found.x)).max())
        if not residual <= BALANCED or (np.abs(inputs[:, 0]) < SMALLEST * sizes).any():
            return None
        return self._motion(order, inputs, solved, residual, lower)

    def _outputs(self, inputs: Complexes, omega: float) -> Complexes | None:
        found = []
        for element, given in zip(self.elements, inputs, strict=True):
            output = steady_response(element, OddPolynomial(given), omega, of_velocity=True)
            if output is None:
                return None
            found.append(output)
        return np.array(found)

    def _motion(
        self, order: int, inputs: Complexes, omega: float, residual: float, lower: BalancedMotion | None
    ) -> BalancedMotion:
        named = ReadOnly(dict(zip(self.loop.elements, inputs, strict=True)))
        motion = BalancedMotion(order, omega, named, residual, math.nan)
        if lower is None:
            return motion
        changes = [omega / lower.omega - 1.0]
        changes += [size / lower.amplitudes[name] - 1.0 for name, size in motion.amplitudes.items()]
        return BalancedMotion(order, omega, named, residual, max(map(abs, changes)))
