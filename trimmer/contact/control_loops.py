"""The linear loops of a controlled machine: whether they are stable, and with which margins.

Dry friction, walls and limits are left out, contacts are closed or open. The loop of one controller is opened
where its force acts, while the others stay closed: L(s) = -c (s - A)⁻¹ b, of which -1 is the critical point.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import scipy.linalg
import scipy.optimize

from trimmer.contact.assembly import flow_without_stick
from trimmer.contact.control_limits import first_control
from trimmer.contact.curves import segments_at
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.statuses import ALWAYS, FORWARD, FREE, LOOSE, PLUS, WITHIN

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.mechanism.mechanism import Mechanism

GROWS = 1e-7
"""Real part of an eigenvalue, as a share of the largest one, up to which it may be rounding of zeros."""
BEYOND = 1e3
"""How far beyond the slowest and the fastest eigenvalue crossings are sought."""
A_DECADE = 200
"""Frequencies in each decade between which a crossing is sought, beside those about each resonance."""


@dataclass(frozen=True)
class ControlLoop:
    """The loop of one controller, opened where its force acts.

    Attributes:
        controller: Its name.
        gain_margin: Factor of the gain at which the closed loop is at its limit, the nearest to 1; infinite
            if there is none.
        phase_margin: Least phase that may be lost, or won if it is negative, rad; infinite if there is none.
        modulus_margin: Least distance of L from -1.
        phase_crossing, gain_crossing, nearest: Angular frequencies of these, rad/s; NaN where there is none.
    """

    controller: str
    gain_margin: float
    phase_margin: float
    modulus_margin: float
    phase_crossing: float
    gain_crossing: float
    nearest: float


@dataclass(frozen=True, eq=False)
class ControlLoops:
    """The linear loops of a machine.

    Attributes:
        rates: Eigenvalues with all loops closed, 1/s.
        grows: The fastest rate of growth, 1/s; 0 if nothing grows.
        loops: Of each continuous controller.
    """

    rates: Complexes
    grows: float
    loops: tuple[ControlLoop, ...]


def control_loops(mechanism: Mechanism, open_contacts: Collection[str] = ()) -> ControlLoops:
    """Return the linear loops of a machine with continuous controllers.

    Args:
        mechanism: The machine.
        open_contacts: Names of the plays and stops that are open; the others are closed.
    """
    system = MechanismFlow(mechanism).modes.system
    machine, layout = system.machine, system.layout
    contacts = [
        ALWAYS if always else FREE if name in open_contacts else PLUS
        for name, always in zip(layout.contacts, machine.always, strict=True)
    ]
    at_rest = np.zeros(layout.size)
    statuses = (
        *contacts,
        *(FORWARD for _ in layout.frictions),
        *segments_at(machine, at_rest),
        *(WITHIN for _ in layout.controllers),
        *(LOOSE for _ in layout.walls),
    )
    assert len(statuses) == first_control(machine) + len(layout.controllers) + len(layout.walls)
    # The springs behind slots follow their ends, and nothing follows them.
    springs = range(layout.first_control - len(layout.relaxing), layout.first_control)
    kept = np.delete(np.arange(layout.state_count), list(springs))
    closed = flow_without_stick(machine, statuses)[np.ix_(kept, kept)]
    rates = np.linalg.eigvals(scipy.linalg.matrix_balance(closed)[0])
    fastest = float(rates.real.max(initial=0.0))
    grows = fastest if fastest > GROWS * abs(rates).max(initial=0.0) else 0.0
    loops = []
    for number, name in enumerate(layout.controllers):
        given, read = machine.control_effect[number, kept], machine.control_demand[number, kept]
        loops.append(_loop(name, closed - np.outer(given, read), given, read))
    return ControlLoops(rates, grows, tuple(loops))


def _loop(name: str, opened: Reals, given: Reals, read: Reals) -> ControlLoop:
    rates = np.linalg.eigvals(scipy.linalg.matrix_balance(opened)[0])
    unit = np.eye(len(opened))

    def ratio(omega: float) -> complex:
        return complex(-read @ np.linalg.solve(1j * omega * unit - opened, given.astype(complex)))

    omegas = _omegas(rates)
    values = np.array([ratio(omega) for omega in omegas])
    gains = [
        (1.0 / abs(ratio(omega)), omega)
        for omega in _crossings(omegas, values.imag, lambda omega: ratio(omega).imag)
        if ratio(omega).real < 0
    ]
    sizes = np.hypot(values.real, values.imag)
    phases = [
        (math.remainder(math.pi + float(np.angle(ratio(omega))), math.tau), omega)
        for omega in _crossings(omegas, sizes - 1.0, lambda omega: abs(ratio(omega)) - 1.0)
    ]
    gain = min(gains, key=lambda each: abs(math.log(each[0])), default=(math.inf, math.nan))
    phase = min(phases, key=lambda each: abs(each[0]), default=(math.inf, math.nan))
    place = int(np.argmin(abs(1.0 + values)))
    low, high = omegas[max(place - 1, 0)], omegas[min(place + 1, len(omegas) - 1)]
    least = scipy.optimize.minimize_scalar(
        lambda omega: abs(1.0 + ratio(omega)),
        bounds=(low, high),
        method="bounded",
        options={"xatol": 1e-10 * high},
    )
    return ControlLoop(name, gain[0], phase[0], float(least.fun), gain[1], phase[1], float(least.x))


def _omegas(rates: Complexes) -> Reals:
    """Return the angular frequencies at which a loop is looked at, denser about its resonances."""
    sizes = abs(rates)
    sizes = sizes[sizes > GROWS * sizes.max(initial=0.0)]
    if not len(sizes):
        sizes = np.ones(1)
    low, high = math.log10(sizes.min() / BEYOND), math.log10(sizes.max() * BEYOND)
    even = np.logspace(low, high, int(A_DECADE * (high - low)))
    turning = rates[rates.imag > 0]
    spread = np.linspace(-10.0, 10.0, 81)
    about = [rate.imag + abs(rate.real) * spread for rate in turning]
    every = np.unique(np.concatenate([even, *about]))
    return np.asarray(every[every > 0])


def _crossings(omegas: Reals, values: Reals, function: Callable[[float], float]) -> Iterator[float]:
    for place in np.flatnonzero(np.sign(values[1:]) * np.sign(values[:-1]) < 0):
        low, high = omegas[place], omegas[place + 1]
        yield float(scipy.optimize.brentq(function, low, high, xtol=1e-14 * high, rtol=1e-14))


def instability_told(mechanism: Mechanism) -> str:
    """Say that the linear loops are unstable with contacts closed; empty if not, or if one is sampled."""
    if not mechanism.controllers or any(each.sample is not None for each in mechanism.controllers.values()):
        return ""
    found = control_loops(mechanism)
    if not found.grows:
        return ""
    growing = found.rates[np.argmax(found.rates.real)]
    turns = f" at {abs(growing.imag) / math.tau:.4g} Hz" if growing.imag else ""
    return (
        "controllers: the linear loop is unstable with contacts closed and friction left out: it grows by e "
        f"in {1.0 / found.grows:.3g} s{turns}; choose other gains, 'trimmer linear' shows margins"
    )
