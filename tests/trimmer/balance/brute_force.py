"""Limit cycles by brute force in plain NumPy: G from its polynomials, N from its formula where that is short.

For an element with a gap the plane of frequency and gap over amplitude is covered with a fine grid, and
1 + N G is followed round each cell. For relay and Coulomb friction N is real or imaginary, so that signs of G
decide.
"""

from __future__ import annotations

from dataclasses import dataclass

import control
import numpy as np
import pytest

from trimmer.arrays import Complexes, Reals
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.inertia_backlash import InertiaBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.element import Element
from trimmer.elements.relay import Relay

OMEGAS = 900
SHARES = np.concatenate([np.geomspace(1e-6, 0.5, 70), 1 - np.geomspace(0.5, 1e-11, 130)[1:]])
"""Of the largest gap over amplitude; fine where N ends, since it varies fast there."""
AROUND = 1e-5
"""Half of the width, relative, of the contour round one limit cycle."""


@dataclass(frozen=True)
class RandomLoop:
    system: control.TransferFunction
    element: Element

    def response(self, omega: Reals) -> Complexes:
        return np.polyval(self.system.num[0][0], 1j * omega) / np.polyval(self.system.den[0][0], 1j * omega)

    def gain(self, amplitude: Reals, omega: Reals) -> Complexes:
        if isinstance(self.element, FrictionBacklash):
            beyond = np.maximum(2.0 - self.element.gap / amplitude, 0.0)  # Play ends where it is 0.
            turn = 4.0 * np.arcsin(np.sqrt(0.5 * beyond))
            series = turn**3 / 6.0 - turn**5 / 120.0 + turn**7 / 5040.0
            in_phase = np.where(turn < 0.1, series, turn - np.sin(turn)) / (2.0 * np.pi)
            return in_phase - 1j * beyond * (2.0 - beyond) / np.pi
        return self.element.describing_function(amplitude, omega)


def random_loop(random: np.random.Generator) -> RandomLoop:
    """Up to three integrators, gains up to 1e5, no resonance that a grid would step over."""
    denominator = np.poly1d([1.0, *[0.0] * random.integers(0, 4)])
    for _ in range(random.integers(1, 4)):
        omega, damping = 10 ** random.uniform(-1, 1), 10 ** random.uniform(-1.4, 0.3)
        pair = random.random() < 0.6
        denominator *= np.poly1d([1, 2 * damping * omega, omega**2] if pair else [1, omega])
    numerator = np.poly1d([random.choice([-1, 1]) * 10 ** random.uniform(-1, 5)])
    for _ in range(random.integers(0, max(1, denominator.order))):
        numerator *= np.poly1d([1, random.choice([-1, 1], p=[0.2, 0.8]) * 10 ** random.uniform(-1, 1)])
    elements = (
        FrictionBacklash(1.0),
        ViscousBacklash(1.0, 10 ** random.uniform(-4, 2)),
        InertiaBacklash(1.0),
        Relay(10 ** random.uniform(-2, 2)),
        CoulombFriction(10 ** random.uniform(-2, 2)),
    )
    chosen = elements[random.choice(5, p=[0.4, 0.25, 0.15, 0.1, 0.1])]
    return RandomLoop(control.tf(numerator.coeffs, denominator.coeffs), chosen)


def check_limit_cycles(loop: RandomLoop, cycles: tuple[LimitCycle, ...], omegas: tuple[float, float]) -> None:
    """Check that these are all limit cycles in a range of frequencies, rad/s, and that each is one."""
    if isinstance(loop.element, Relay | CoulombFriction):
        expected = _of_relay(loop, omegas)
        assert [cycle.omega for cycle in cycles] == [pytest.approx(omega, rel=1e-5) for omega, _ in expected]
        assert [cycle.amplitude for cycle in cycles] == [
            pytest.approx(amplitude, rel=1e-5) for _, amplitude in expected
        ]
        return
    omega, turns = _turns(loop, omegas)
    assert sum(cycle.index for cycle in cycles) == turns.sum(), loop
    places = [_place(loop, cycle, omega) for cycle in cycles]
    for cycle in cycles:
        assert _turns_round(loop, cycle) == cycle.index, (loop, cycle)
    for i, j in np.argwhere(turns != 0):
        assert any(abs(i - row) <= 1 and abs(j - column) <= 1 for row, column in places), (loop, omega[j])


def _of_relay(loop: RandomLoop, omegas: tuple[float, float]) -> list[tuple[float, float]]:
    """Return omega and amplitude where -1/G is positive, or for friction positive imaginary, as N is."""
    omega = np.geomspace(*omegas, 100_000)
    turned = -loop.response(omega) * (1.0 if isinstance(loop.element, Relay) else 1j)
    level = loop.element.level if isinstance(loop.element, Relay) else loop.element.force
    crossing = np.flatnonzero((np.sign(turned.imag[1:]) != np.sign(turned.imag[:-1])) & (turned.real[1:] > 0))
    found = []
    for k in crossing:
        share = turned.imag[k] / (turned.imag[k] - turned.imag[k + 1])
        gain = turned.real[k] + share * (turned.real[k + 1] - turned.real[k])
        found.append(
            (float(omega[k] * (omega[k + 1] / omega[k]) ** share), float(4.0 / np.pi * level * gain))
        )
    return found


def _turns(loop: RandomLoop, omegas: tuple[float, float]) -> tuple[Reals, Reals]:
    """Return frequencies of the grid, rad/s, and the turns of 1 + N G round its cells, share by frequency."""
    omega = np.geomspace(*omegas, OMEGAS)
    amplitude = loop.element.amplitude_scale / (SHARES[:, None] * loop.element.domain(omega))
    gain = loop.gain(amplitude, np.broadcast_to(omega, amplitude.shape))
    phase = np.angle(1.0 + gain * loop.response(omega))
    corners = (phase[:-1, :-1], phase[1:, :-1], phase[1:, 1:], phase[:-1, 1:])
    steps = (end - start for start, end in zip(corners, (*corners[1:], corners[0]), strict=True))
    turns = sum((step + np.pi) % (2 * np.pi) - np.pi for step in steps) / (2 * np.pi)
    return omega, -np.rint(turns)  # Positive where Loeb's criterion holds, as the index is.


def _place(loop: RandomLoop, cycle: LimitCycle, omega: Reals) -> tuple[int, int]:
    """Return the cell of a limit cycle."""
    share = loop.element.amplitude_scale / cycle.amplitude / float(loop.element.domain(cycle.omega))
    return int(np.searchsorted(SHARES, share)) - 1, int(np.searchsorted(omega, cycle.omega)) - 1


def _turns_round(loop: RandomLoop, cycle: LimitCycle) -> int:
    """Return the turns of 1 + N G round a narrow rectangle about a limit cycle, within the domain."""
    domain = float(loop.element.domain(cycle.omega))
    share = loop.element.amplitude_scale / cycle.amplitude / domain
    half = min(AROUND, 0.5 * (1.0 - share))
    side = np.linspace(-1.0, 1.0, 200)
    one = np.ones_like(side)
    shares = share * (1.0 + half * np.concatenate([side, one, -side, -one]))
    omega = cycle.omega * (1.0 + AROUND * np.concatenate([-one, side, one, -side]))
    amplitude = loop.element.amplitude_scale / (shares * loop.element.domain(omega))
    value = 1.0 + loop.gain(amplitude, omega) * loop.response(omega)
    phase = np.unwrap(np.angle(np.append(value, value[0])))
    return -int(np.rint((phase[-1] - phase[0]) / (2 * np.pi)))
