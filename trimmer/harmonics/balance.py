"""Multi-harmonic balance of a driven mechanism, with forces integrated exactly between their events."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.contact.state.frame import frame_of
from trimmer.contact.state.laid_out import curves_of
from trimmer.errors import UnsupportedMotionError
from trimmer.harmonics.contact import HarmonicContact
from trimmer.harmonics.crossings import crossings
from trimmer.harmonics.forces import Harmonics, Pieces, piecewise, with_moving_ends
from trimmer.harmonics.waveform import PeriodicWaveform
from trimmer.mechanism import Link, Mechanism, Play, Stop
from trimmer.mechanism.controls.checks import require_uncontrolled
from trimmer.mechanism.drives import drives_of, waves_in
from trimmer.mechanism.linear.matrices import displacement_rows, linear_matrices
from trimmer.mechanism.place_text import place_text
from trimmer.mechanism.waves import mean_of

MOST_ITERATIONS = 30
MOST_HALVINGS = 8
BALANCED = 1e-10  # Largest imbalance, relative to the largest force, that counts as a solution


@dataclass(frozen=True, eq=False)
class Balance:
    """A periodic motion whose forces balance in all harmonics up to an order."""

    # c_n of q = Re Σ c_n exp(i n omega t / periods) of each body, m, n from 0, shape (bodies, periods order +
    # 1)
    coefficients: Complexes
    periods: int  # Drive periods after which it repeats
    residual: float  # Largest imbalance of a harmonic, relative to the largest force

    @property
    def converged(self) -> bool:
        """Whether the forces balance to rounding."""
        return self.residual <= BALANCED


def harmonic_balance_of(mechanism: Mechanism, guess: Complexes, periods: int = 1) -> Balance:
    """Balance the forces of a driven mechanism in all harmonics of a guess, m, (bodies, harmonics + 1)."""
    equations = _Equations(mechanism, guess.shape[1], periods)
    unknowns = _as_real(guess)
    residual, slope = equations.imbalance(unknowns)
    for _ in range(MOST_ITERATIONS):
        if _largest(residual) <= 1e-14 * equations.scale:
            break
        correction = np.linalg.lstsq(slope, -residual, rcond=1e-15)[0]
        share = 1.0
        for _ in range(MOST_HALVINGS):
            trial, trial_slope = equations.imbalance(unknowns + share * correction)
            if _largest(trial) < _largest(residual):
                break
            share *= 0.5
        else:
            break
        unknowns, residual, slope = unknowns + share * correction, trial, trial_slope
    coefficients = _as_complex(unknowns, guess.shape)
    return Balance(coefficients, periods, _largest(residual) / equations.scale)


def require_balanceable(mechanism: Mechanism) -> None:
    """Check that harmonic balance knows the motions of a mechanism: sums of harmonics of a drive.

    It has no controllers, has a frequency, no spring leans on a pin that moves on, and each body is held
    in place.
    """
    require_uncontrolled(mechanism.controllers, "harmonic balance")
    if mechanism.frequency is None:
        raise UnsupportedMotionError("harmonic balance needs a frequency at the top of the mechanism")
    if curved := curves_of(mechanism):
        raise UnsupportedMotionError(
            f"harmonic balance does not know curves, such as that of {place_text(curved[0])}; "
            "'trimmer respond' does"
        )
    if mechanism.walls:
        name = place_text(("walls", next(iter(mechanism.walls))))
        raise UnsupportedMotionError(
            f"harmonic balance does not know impacts on walls, such as {name}; 'trimmer respond' does"
        )
    if drives_of(mechanism).ratios:
        raise UnsupportedMotionError("harmonic balance has one drive; 'trimmer respond' takes several")
    moving = [name for name, pin in mechanism.pins.items() if pin.velocity != 0.0]
    parts: list[Link | Play | Stop] = [*mechanism.links.values()]
    parts += [*mechanism.plays.values(), *mechanism.stops.values()]
    for part in parts:
        if part.stiffness > 0.0 and any(name in part.between for name in moving):
            raise UnsupportedMotionError("a spring leans on a pin that moves on: its force never repeats")
    free = frame_of(mechanism).leading
    if len(free):
        raise UnsupportedMotionError(
            "harmonic balance needs bodies that springs, plays or stops hold in place, and nothing holds "
            f"{mechanism.coordinates[free[0]]}, which may advance in each period"
        )


def _largest(values: Reals) -> float:
    return float(abs(values).max())


def _as_real(coefficients: Complexes) -> Reals:
    return np.concatenate([coefficients.real.ravel(), coefficients.imag.ravel()])


def _as_complex(values: Reals, shape: tuple[int, ...]) -> Complexes:
    real, imaginary = np.split(values, 2)
    coefficients: Complexes = (real + 1j * imaginary).reshape(shape)
    return coefficients


@dataclass(frozen=True, eq=False)
class _Equations:
    """M q'' + C q' + K q + Σ forces = what drives it, harmonic by harmonic."""

    mechanism: Mechanism
    count: int
    periods: int

    def __post_init__(self) -> None:
        require_balanceable(self.mechanism)

    @property
    def _contacts(self) -> list[Play | Stop]:
        return [*self.mechanism.plays.values(), *self.mechanism.stops.values()]

    @cached_property
    def omega(self) -> float:
        return 2.0 * np.pi * float(self.mechanism.frequency or 0.0) / self.periods

    @cached_property
    def turning(self) -> Complexes:
        return np.asarray(1j * self.omega * np.arange(self.count), dtype=np.complex128)

    @cached_property
    def pins(self) -> Complexes:
        """Coefficients of the pins relative to their carriers, (pins, count)."""
        waves = np.zeros((len(self.mechanism.pins), self.count), dtype=complex)
        for row, pin in zip(waves, self.mechanism.pins.values(), strict=True):
            row[0] = mean_of(pin)
            for wave in waves_in(self.mechanism, pin):
                self._add_sine(row, *wave)
        return waves

    def _add_sine(self, row: Complexes, order: float, amplitude: float, phase: float) -> None:
        place = int(order) * self.periods
        if place < self.count:
            row[place] += -1j * amplitude * np.exp(1j * phase)

    @cached_property
    def driving(self) -> Complexes:
        """Coefficients of the forces on the bodies at rest, N, (bodies, count)."""
        matrices, mechanism = linear_matrices(self.mechanism, viscous=True), self.mechanism
        forces = np.zeros((len(mechanism.forces), self.count), dtype=complex)
        for row, force in zip(forces, mechanism.forces.values(), strict=True):
            row[0] = mean_of(force)
            for wave in waves_in(self.mechanism, force):
                self._add_sine(row, *wave)
        speeds = np.array([pin.velocity for pin in mechanism.pins.values()])
        driving = matrices.forces @ forces + matrices.pin_displacement @ self.pins
        driving = driving + matrices.pin_velocity @ (self.pins * self.turning)
        driving[:, 0] += matrices.pin_velocity @ speeds
        return np.asarray(driving, dtype=np.complex128)

    @cached_property
    def linear(self) -> Complexes:
        """Dynamic stiffness of each harmonic, (count, bodies, bodies)."""
        matrices, turning = linear_matrices(self.mechanism, viscous=True), self.turning[:, None, None]
        return np.asarray(turning**2 * matrices.mass + turning * matrices.damping + matrices.stiffness)

    @cached_property
    def scale(self) -> float:
        """Largest force that occurs, N."""
        frictions = [friction.kinetic_force for friction in self.mechanism.frictions.values()]
        return max([float(abs(self.driving).max()), *frictions]) or 1.0

    def imbalance(self, unknowns: Reals) -> tuple[Reals, Reals]:
        """Return the imbalance, N, and its derivative."""
        bodies = len(self.mechanism.coordinates)
        q = _as_complex(unknowns, (bodies, self.count))
        residual = np.einsum("nij,jn->in", self.linear, q) - self.driving
        direct = np.zeros((bodies, self.count, bodies, self.count), dtype=complex)
        harmonics = np.arange(self.count)
        direct[:, harmonics, :, harmonics] = self.linear
        conjugate = np.zeros_like(direct)
        for row, force in self._forces(q):
            residual += np.multiply.outer(row, force.coefficients)
            shape = np.multiply.outer(row, row)
            direct += np.einsum("ij,nm->injm", shape, force.direct)
            conjugate += np.einsum("ij,nm->injm", shape, force.conjugate)
        size = bodies * self.count
        plus = (direct + conjugate).reshape(size, size)
        minus = 1j * (direct - conjugate).reshape(size, size)
        slope = np.block([[plus.real, minus.real], [plus.imag, minus.imag]])
        return _as_real(residual), slope

    def _forces(self, q: Complexes) -> Iterator[tuple[Reals, Harmonics]]:
        """Yield how a force that pulls two ends together acts against the bodies, and its harmonics."""
        rows, bodies = displacement_rows(self.mechanism), len(self.mechanism.coordinates)
        moved = np.vstack([q, self.pins])
        for part in self._contacts:
            row = rows[part.between[1]] - rows[part.between[0]]
            yield row[:bodies], HarmonicContact(part, PeriodicWaveform(row @ moved, self.omega)).harmonics()
        for friction in self.mechanism.frictions.values():
            row = rows[friction.between[1]] - rows[friction.between[0]]
            start, end = friction.between
            drift = self._drift(end) - self._drift(start)
            distance = PeriodicWaveform(row @ moved, self.omega)
            yield row[:bodies], friction_harmonics(distance, drift, friction.kinetic_force)

    def _drift(self, end: str) -> float:
        return self.mechanism.pins[end].velocity if end in self.mechanism.pins else 0.0


def friction_harmonics(distance: PeriodicWaveform, drift: float, force: float) -> Harmonics:
    """Return the harmonics of force sign(v), N; v, m/s, is a drift and the rate of a distance, m.

    A trigonometric polynomial cannot stay at zero, so that there is no stick, only a velocity that is small.
    """
    velocity = PeriodicWaveform(distance.turning * distance.coefficients, distance.omega).shifted(drift)
    period = distance.period
    zeros = crossings(velocity, 0.0, period)
    edges = np.concatenate([[0.0], zeros, [period]])
    signs = np.sign(velocity.at(0.5 * (edges[1:] + edges[:-1])))
    pieces = Pieces(edges[:-1], edges[1:], -signs)
    fixed = piecewise(distance, np.zeros(len(distance.coefficients), dtype=complex), force, pieces)
    steepness = abs(velocity.slope(zeros))
    return with_moving_ends(fixed, distance, zeros, 2.0 * force / steepness, distance.turning)
