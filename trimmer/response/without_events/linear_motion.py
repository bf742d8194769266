"""A motion that meets no event any more: it is linear from then on, and known for all time.

In one mode x' = A x + B w, where what forces it, w, is made of sines of the drive and of one. What is held
(springs in contact, velocities in stick) is eliminated, and so are places on which nothing depends, such as
that of a body that friction holds. What is left is a sum of the forced motion and of free ones, Z exp(λ t).
An event function is a row of it, which stays positive if its least value on the forced motion is greater than
the moduli of all its free parts together. So the end of the motion is solved for, and not waited for.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import scipy.linalg

from trimmer.arrays import ROUNDING

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Flags, Reals
    from trimmer.hybrid.stretch import Instant
    from trimmer.hybrid.system import ModeEquations
    from trimmer.motion.flow import Flow
BARELY = 1e-13  # Share of the sizes of states up to which a sum of them is not told from zero
ILL = 1e8
"""Condition of the eigenvectors beyond which free motions are not told apart, as where two become one."""
NOTHING = 1e-10
"""Share of the size of a motion below which a free part of it is none: that to which orbits are closed."""
SAMPLES = 64  # Instants in the period of the fastest wave at which a sum of waves is looked at


@dataclass(frozen=True, eq=False)
class LinearMotion:
    """The motion from an instant on, if no event ends its mode: x(t) = Σ Re(X exp(iωt)) + Σ Re(Z exp(λt))."""

    flow: Flow  # The motion of the mechanism
    instant: Instant  # Where it begins, t = 0
    mean: Reals  # The constant part of the states, (n,)
    orders: Reals  # Multiples of the drive that occur, (m,)
    waves: Complexes  # Their complex amplitudes in the states, X, (m, n)
    # λ of the free parts, 1/s, of which pairs are conjugate, (r,). Those that do not decay have a real part
    # of exactly zero.
    rates: Complexes
    parts: Complexes  # Their complex amplitudes in the states, Z, (r, n)
    free: bool  # Whether there are places on which nothing depends

    @property
    def lasting(self) -> Flags:
        """Which free parts never decay, (r,)."""
        return np.asarray(self.rates.real == 0)

    @property
    def reach(self) -> Reals:
        """Bound of the modulus of each state, without what decays, (n,)."""
        lasting = abs(self.parts[self.lasting]).sum(axis=0)
        return np.asarray(abs(self.mean) + abs(self.waves).sum(axis=0) + lasting)

    @property
    def sizes(self) -> Reals:
        """Scale of each state, (n,): those of one kind share theirs."""
        layout = self.flow.modes.system.layout
        moving = layout.lengths * (abs(self.waves).sum(axis=0) + abs(self.parts).sum(axis=0))
        terms = moving + layout.lengths * abs(self.mean)
        sizes: Reals = terms.copy()
        for kind in layout.kinds:
            sizes[kind] = (moving if kind in layout.rates else terms)[kind].max(initial=0.0)
        sizes[layout.kinds[-1].stop :] = sizes[layout.kinds[0]].max(initial=0.0)
        sizes[sizes == 0.0] = 1.0
        return np.asarray(sizes / layout.lengths)

    @property
    def alive(self) -> Flags:
        """Which free parts never decay and are more than rounding, (r,)."""
        share = (abs(self.parts) / self.sizes).max(axis=1, initial=0.0)
        return np.asarray(self.lasting & (share > NOTHING))

    @property
    def frequencies(self) -> Reals:
        """Angular frequencies of what is alive, rad/s, rising; equal ones once."""
        found: list[float] = []
        for each in sorted(abs(self.rates[self.alive].imag).tolist()):
            if not found or each - found[-1] > 1e-12 * each:
                found.append(each)
        return np.array(found)

    @property
    def slowest(self) -> float:
        """Rate at which the slowest of the decaying parts decays, 1/s; infinite if there is none."""
        decaying = self.rates.real[~self.lasting & (abs(self.parts).max(axis=1, initial=0.0) > 0)]
        return float(-decaying.max(initial=-np.inf))

    @property
    def limit(self) -> Instant:
        """The instant without what decays: where the motion would be that this one settles to."""
        state = self.mean + self.waves.sum(axis=0).real + self.parts[self.lasting].sum(axis=0).real
        like = self.instant
        quiet = replace(like, zeros=np.zeros_like(like.zeros))
        return self.flow.at(state, like.phase, like=quiet)

    @property
    def still(self) -> bool:
        """Whether nothing moves once what decays is gone."""
        moved = any(self.waves[:, kind].any() for kind in self.flow.modes.system.layout.kinds)
        return not self.alive.any() and not moved and not self.moves_on

    @property
    def moves_on(self) -> bool:
        """Whether bodies go on at a constant velocity, beyond rounding, as they may with the frame."""
        layout = self.flow.modes.system.layout
        if not layout.travels:
            return False
        mean, (displacements, velocities) = layout.lengths * abs(self.mean), layout.kinds
        parts = layout.lengths * abs(self.parts)
        fastest = parts[:, velocities].sum(axis=0) + (layout.lengths * abs(self.instant.state))[velocities]
        turned = mean[displacements].max(initial=0.0) * abs(self.rates).max(initial=0.0)
        scale = max(fastest.max(initial=0.0), turned)
        return bool((mean[velocities] > NOTHING * scale).any())

    @property
    def lasts(self) -> bool:
        """Whether it is shown that no event ends the mode."""
        functions = _mode(self.flow, self.instant).functions
        return all(self._stays_positive(function.row) for function in functions)

    @property
    def dies_away(self) -> bool:
        """Whether it is shown that it comes to rest in its mode, though what ends this falls towards zero.

        So a friction slides ever slower to where an integral of a controller leads.
        """
        dying = not self.waves.any() and not self.lasting.any()
        return dying and all(self._stays_above(each.row) for each in _mode(self.flow, self.instant).functions)

    def _stays_above(self, row: Reals) -> bool:
        """Say whether a functional, (N,), stays positive while it falls to its constant part, or to zero."""
        constant, _, free = self.seen_by(row)
        rounding = BARELY * float(
            abs(row[: self.flow.size]) @ self._reached + abs(row[self.flow.size :]).sum()
        )
        others, slowest = float(abs(free).sum()), int(np.argmax(self.rates.real)) if len(free) else -1
        if abs(constant) > rounding or slowest < 0:
            return constant > others + rounding
        last = free[slowest]
        return bool(self.rates[slowest].imag == 0 and 2 * last.real > others + rounding)

    @property
    def _reached(self) -> Reals:
        """Scale of each state, (n,), of a velocity that at which the displacements pass in a fast mode."""
        sizes, layout = self.sizes.copy(), self.flow.modes.system.layout
        for kind in layout.rates:
            turned = (layout.lengths * sizes)[layout.kinds[0]].max(initial=0.0) * abs(self.rates).max(
                initial=0.0
            )
            sizes[kind] = np.maximum(sizes[kind], turned / layout.lengths[kind])
        return sizes

    def seen_by(self, row: Reals) -> tuple[float, Complexes, Complexes]:
        """Return the constant part of a functional of the extended state, (N,), its waves and its free parts.

        The waves are those of the orders, (m,), the free parts those of the rates, (r,).
        """
        layout, size = self.flow.modes.system.layout, self.flow.size
        forcing, waves = row[size:], self.waves @ row[:size]
        time = layout.clock(self.instant.periods, self.instant.phase)
        turns = np.exp(1j * np.array(layout.orders) * layout.omega * time)
        waves += layout.phasors @ forcing * turns
        return float(row[:size] @ self.mean + forcing @ layout.steady), waves, self.parts @ row[:size]

    def _stays_positive(self, row: Reals) -> bool:
        constant, waves, free = self.seen_by(row)
        terms = abs(row[: self.flow.size]) @ (abs(self.mean) + abs(self.waves).sum(axis=0))
        rounding = ROUNDING * float(terms + abs(row[self.flow.size :]).sum())
        return _least(constant, self.orders, waves) > float(abs(free).sum()) + rounding


def linear_motion(flow: Flow, instant: Instant) -> LinearMotion | None:
    """Return the motion from an instant on as if no event came; None if it grows, or is not told by that.

    Args:
        flow: The motion of the mechanism.
        instant: Where it is.
    """
    if flow.modes.system.layout.changes_after(_now(flow, instant)) or flow.modes.system.clockwork is not None:
        return None
    mode = _mode(flow, instant)
    held = _Held.of(flow, mode)
    modal = _modal(flow, mode, held)
    return None if modal is None else _motion(flow, instant, held, modal)


def _now(flow: Flow, instant: Instant) -> float:
    return instant.periods * flow.period + instant.phase


def lasting_motion(flow: Flow, instant: Instant) -> LinearMotion | None:
    """Return the motion from an instant on if no event comes any more; None if one may."""
    motion = linear_motion(flow, instant)
    return motion if motion is not None and motion.lasts else None


def grows_for_ever(flow: Flow, instant: Instant) -> bool:
    """Say whether a motion surely grows without bound: no event can come, and a force meets no resistance.

    A constant force meets what nothing holds or damps, or a wave of the drive a free vibration that nothing
    damps.
    """
    mode = _mode(flow, instant)
    goes_on = flow.modes.system.layout.changes_after(_now(flow, instant))
    if goes_on or mode.functions or flow.modes.system.clockwork is not None:
        return False
    held = _Held.of(flow, mode)
    modal = _modal(flow, mode, held)
    return modal is not None and _forced(held, modal) is None


def _mode(flow: Flow, instant: Instant) -> ModeEquations:
    return flow.modes[flow.modes.number(instant.statuses)]


class _Held(NamedTuple):
    """A mode without what is held: x = basis y + shift w and y' = matrix y + Re(push exp(iωt))."""

    basis: Reals  # (n, r), orthonormal
    shift: Reals  # (n, forcing)
    matrix: Reals  # (r, r)
    # push, moduli: Of one and of each order: (1 + m, r), and the sums of moduli that it is made of
    push: Complexes
    moduli: Reals
    forcing: Complexes  # What forces the states of each of these, complex, (1 + m, forcing)
    omegas: Reals  # 0 and the orders times that of the drive, rad/s, (1 + m,)

    @classmethod
    def of(cls, flow: Flow, mode: ModeEquations) -> _Held:
        layout, size = flow.modes.system.layout, flow.size
        A, B = mode.flow[:size, :size], mode.flow[:size, size:]
        hold, shift = mode.hold[:size, :size], mode.hold[:size, size:]
        rank = round(float(np.trace(hold)))
        basis = np.eye(size) if rank == size else np.linalg.svd(hold)[0][:, :rank]
        forcing = np.zeros((1 + len(layout.orders), layout.forcing), dtype=complex)
        forcing[0], forcing[1:] = layout.steady, layout.phasors
        omegas = np.array([0.0, *(order * layout.omega for order in layout.orders)])
        moved = 1j * omegas[:, None] * (forcing @ shift.T)
        push = (forcing @ (A @ shift + B).T - moved) @ basis
        # What holds takes forces away, whose rounding stays.
        whole = flow.modes.system.terms(mode)[:size]
        moduli = abs(forcing) @ (whole[:, :size] @ abs(shift) + whole[:, size:]).T + abs(moved)
        reach = abs(basis) + np.finfo(float).eps
        return cls(basis, shift, basis.T @ A @ basis, push, moduli @ reach, forcing, omegas)


class _Modal(NamedTuple):
    """The free parts of y, with the places on which nothing depends left out: y = places a + rest V c."""

    places: Reals  # Directions on which nothing depends, (r, f)
    rest: Reals  # The other directions, (r, r - f)
    # onto_places, onto_rest: What gives the shares of both, (f, r) and (r - f, r)
    onto_places: Reals
    onto_rest: Reals
    rates: Complexes  # λ, 1/s, those that do not decay with a real part of zero, (r - f,)
    # vectors, inverse: V and its inverse, (r - f, r - f)
    vectors: Complexes
    inverse: Complexes
    margins: Reals  # Rounding of each λ, 1/s, (r - f,)


def _modal(flow: Flow, mode: ModeEquations, held: _Held) -> _Modal | None:
    """Return the free parts; None if one grows, or if they cannot be told apart."""
    matrix = held.matrix
    with np.errstate(all="ignore"):  # SciPy takes scales for places.
        scaled, (scale, _) = scipy.linalg.matrix_balance(matrix, permute=False, separate=True)
    values, right = np.linalg.svd(scaled)[1:]
    null = values <= ROUNDING * values.max(initial=0.0)
    places, rest = scale[:, None] * right[null].T, scale[:, None] * right[~null].T
    onto_places, onto_rest = right[null] / scale, right[~null] / scale
    rates, vectors = np.linalg.eig(onto_rest @ matrix @ rest)
    if len(rates) and not np.linalg.cond(vectors) < ILL:
        return None
    inverse = np.linalg.inv(vectors)
    conditions = np.linalg.norm(inverse, axis=1) * np.linalg.norm(vectors, axis=0)
    margins = ROUNDING * np.linalg.norm(scaled) * conditions
    real = flow.damping(mode, held.basis @ rest @ vectors, rates, margins)
    if (real > 0).any():
        return None
    rates = real + 1j * rates.imag
    return _Modal(places, rest, onto_places, onto_rest, rates, vectors.astype(complex), inverse, margins)


def _motion(flow: Flow, instant: Instant, held: _Held, modal: _Modal) -> LinearMotion | None:
    """Return the motion; None if it drifts, or if its drive meets what nothing damps."""
    forced = _forced(held, modal)
    if forced is None:
        return None
    time = flow.modes.system.layout.clock(instant.periods, instant.phase)
    turns = np.exp(1j * held.omegas * time)[:, None]
    states = (forced @ held.basis.T + held.forcing @ held.shift.T) * turns
    start = held.basis.T @ (instant.state - states.sum(axis=0).real)
    scaled = modal.inverse @ (modal.onto_rest @ start)
    parts = (modal.rest @ modal.vectors * scaled).T
    slides = (modal.onto_places @ held.matrix @ parts.T).T
    steady = modal.rates == 0
    parts[~steady] += (slides[~steady] / modal.rates[~steady, None]) @ modal.places.T
    parts = parts @ held.basis.T
    moved = float(abs(parts).max(initial=0.0))
    if (abs(parts[steady]) > NOTHING * moved).any():
        return None
    parts, rates = parts[~steady], modal.rates[~steady]
    left = held.basis.T @ (instant.state - states.sum(axis=0).real - parts.sum(axis=0).real)
    mean = states[0].real + held.basis @ (modal.places @ (modal.onto_places @ left))
    orders = np.array(flow.modes.system.layout.orders, dtype=np.float64)
    return LinearMotion(flow, instant, mean, orders, states[1:], rates, parts, bool(modal.places.size))


def _forced(held: _Held, modal: _Modal) -> Complexes | None:
    """Return the forced part of y, complex, of one and of each order, (1 + m, r).

    The places on which nothing depends have no constant part of their own. None if there is a drift.
    """
    modal_push = held.push @ modal.onto_rest.T @ modal.inverse.T
    modal_push[abs(modal_push) <= ROUNDING * held.moduli @ abs(modal.onto_rest).T @ abs(modal.inverse).T] = 0
    apart = 1j * held.omegas[:, None] - modal.rates
    near = abs(apart) <= modal.margins
    if (near & (modal_push != 0)).any():
        return None
    shares, directions = modal_push / np.where(near, 1.0, apart), modal.rest @ modal.vectors
    response = shares @ directions.T
    pulled = response @ held.matrix.T
    slides = (pulled + held.push) @ modal.onto_places.T
    moduli = abs(shares) @ abs(directions).T @ abs(held.matrix).T + held.moduli
    slides[abs(slides) <= ROUNDING * moduli @ abs(modal.onto_places).T] = 0
    if slides[0].any():
        return None
    response[1:] += (slides[1:] / (1j * held.omegas[1:, None])) @ modal.places.T
    return np.asarray(response)


def _least(constant: float, orders: Reals, waves: Complexes) -> float:
    """Return a lower bound of a constant and waves at multiples of one frequency."""
    sizes = abs(waves)
    surely = constant - float(sizes.sum())
    if surely > 0 or len(orders) <= 1 or (orders % 1).any():
        return surely
    count = SAMPLES * int(orders.max())
    angles = 2 * np.pi * np.arange(count) / count
    values = (np.exp(1j * np.outer(angles, orders)) @ waves).real
    curved = float(orders**2 @ sizes) * (2 * np.pi / count) ** 2 / 8
    return max(surely, constant + float(values.min()) - curved)
