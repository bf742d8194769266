"""The linear loops of a controlled machine: whether they are stable, and with which margins.

Dry friction, walls and limits are left out, contacts are closed or open. The loop of one controller is opened
where its force acts, while the others stay closed: L(s) = -c (s - A)⁻¹ b, of which -1 is the critical point.
Loops of sampled controllers are opened at what is demanded: from sample to sample the machine and what is
held are x <- M x exactly, with the delay in it, and L(z) = -c (z - M)⁻¹ b with z = exp(j omega T)
(Åström and Wittenmark, Computer-Controlled Systems, 3).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass

import numpy as np
import scipy.linalg

from trimmer.arrays import Complexes, Places, Reals
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.machine.statuses import ALWAYS, FORWARD, FREE, LOOSE, PLUS
from trimmer.contact.machine.statuses import WITHIN as UNLIMITED
from trimmer.contact.modes.assembly import flow_without_stick
from trimmer.contact.modes.curves import segments_at
from trimmer.contact.state.layout import MechanismLayout
from trimmer.hybrid.clock import WITHIN
from trimmer.kept_property import cached_property
from trimmer.linear.margins import Margins, StandingStates, margins_of, standing_states
from trimmer.mechanism.mechanism import Mechanism
from trimmer.messages import listed

GROWS = 1e-7
"""Real part of an eigenvalue, as a share of the largest one, up to which it may be rounding of zeros."""
UNDAMPED = 1e-10
"""Real part over modulus of an eigenvalue up to which it dies out no more than rounding tells."""
ROUNDING = 1e-13  # Of an eigenvalue about 1 from sample to sample
BEYOND = 1e3  # How far beyond the slowest and the fastest eigenvalue crossings are sought
A_DECADE = 200
"""Frequencies in each decade between which a crossing is sought, beside those about each resonance."""


@dataclass(frozen=True, eq=False)
class ControlLoops:
    """The linear loops of a machine."""

    rates: Complexes  # Eigenvalues with all loops closed, 1/s
    grows: float  # The fastest rate of growth, 1/s; 0 if nothing grows
    # What neither dies nor grows like an exponential, without a full stop; empty if all dies out
    marginal: str
    opened: dict[str, OpenedLoop]  # The loop of each controller, opened at its force; by its name
    sample: float | None = None  # At which it is sampled, s; None of continuous ones

    @cached_property
    def loops(self) -> dict[str, Margins]:
        """The margins of each controller's loop, by its name."""
        return {name: each.margins() for name, each in self.opened.items()}

    @property
    def stable(self) -> bool:
        """Whether all dies out."""
        return not (self.grows or self.marginal)


def control_loops(mechanism: Mechanism, open_contacts: Collection[str]) -> ControlLoops:
    """Return the linear loops of a machine with continuous controllers, while sampled ones hold.

    Args:
        mechanism: The machine.
        open_contacts: Names of the plays and stops that are open; the others are closed.
    """
    linear = _LinearMachine(mechanism, open_contacts)
    machine, layout = linear.flow.modes.system.machine, linear.layout
    kept = linear.kept[linear.kept < layout.holding.start]
    closed = linear.matrix[np.ix_(kept, kept)]
    rates, grows, marginal = _stability(closed, layout, kept)
    loops = {}
    for number, name in enumerate(layout.controllers):
        given, read = machine.control_effect[number, kept], machine.control_demand[number, kept]
        loops[name] = OpenedLoop(closed - np.outer(given, read), given, read)
    return ControlLoops(rates, grows, marginal, loops)


def sampled_loops(mechanism: Mechanism, open_contacts: Collection[str] = ()) -> ControlLoops | None:
    """Return the linear loops of sampled controllers, exactly; None if their samples differ.

    Args:
        mechanism: The machine.
        open_contacts: Names of the plays and stops that are open; the others are closed.
    """
    linear = _LinearMachine(mechanism, open_contacts)
    layout, kept, sampled = linear.layout, linear.kept, linear.flow.sampled
    samples = {held.sample for held in layout.held.values()}
    if len(samples) != 1 or sampled is None:
        return None
    (sample,) = samples
    demands, updates = sampled.sampling(linear.flow.modes, linear.number)
    taken = np.eye(layout.size)
    for place, sampler in enumerate(sampled.samplers):
        taken[list(sampler.places)] = updates[place, WITHIN, : len(sampler.places)]
    taken, passed = taken[np.ix_(kept, kept)], linear.over_sample(sample)
    rates, grows, marginal = _stability(passed @ taken, layout, kept, sample)
    loops = {}
    for place, (name, held) in enumerate(layout.held.items()):
        wanted = (kept == held.waiting[-1]).astype(float)
        read = demands[place, kept]
        loops[name] = OpenedLoop(passed @ (taken - np.outer(wanted, read)), passed @ wanted, read, sample)
    return ControlLoops(rates, grows, marginal, loops, sample)


@dataclass(frozen=True, eq=False)
class _LinearMachine:
    """A machine without dry friction, with its contacts closed or open."""

    mechanism: Mechanism
    open_contacts: Collection[str]

    @cached_property
    def flow(self) -> MechanismFlow:
        return MechanismFlow(self.mechanism)

    @property
    def layout(self) -> MechanismLayout:
        return self.flow.modes.system.layout

    @cached_property
    def statuses(self) -> tuple[int, ...]:
        machine, layout = self.flow.modes.system.machine, self.layout
        contacts = [
            ALWAYS if always else FREE if name in self.open_contacts else PLUS
            for name, always in zip(layout.contacts, machine.always, strict=True)
        ]
        statuses = (
            *contacts,
            *(FORWARD for _ in layout.frictions),
            *segments_at(machine, np.zeros(layout.size)),
            *(UNLIMITED for _ in layout.controllers),
            *(LOOSE for _ in layout.walls),
        )
        assert len(statuses) == machine.first_control + len(layout.controllers) + len(layout.walls)
        return statuses

    @cached_property
    def number(self) -> int:
        return int(self.flow.modes.number(self.statuses))

    @cached_property
    def matrix(self) -> Reals:
        return flow_without_stick(self.flow.modes.system.machine, self.statuses)

    @cached_property
    def kept(self) -> Places:
        """The states but for springs behind slots, which follow their ends, and nothing follows them."""
        springs = range(2 * len(self.layout.coordinates), self.layout.first_control)
        return np.delete(np.arange(self.layout.state_count), list(springs))

    def over_sample(self, sample: float) -> Reals:
        """Return what a state becomes from just after a sample until the next one."""
        passed, since, kept = np.eye(len(self.kept)), 0.0, self.kept
        flow = self.matrix[np.ix_(kept, kept)]
        behind = (
            (max(each.delay - sample * (len(each.waiting) - 1), 0.0), each)
            for each in self.layout.held.values()
        )
        for due, held in sorted(behind, key=lambda each: each[0]):
            passed = scipy.linalg.expm(flow * (due - since)) @ passed
            acts = np.eye(len(kept))
            acts[kept == held.acting] = acts[kept == held.waiting[0]]
            passed, since = acts @ passed, due
        return np.asarray(scipy.linalg.expm(flow * (sample - since)) @ passed)


def _balanced(matrix: Reals) -> Reals:
    return np.asarray(scipy.linalg.matrix_balance(matrix, permute=False)[0])


def _stability(
    closed: Reals, layout: MechanismLayout, kept: Places, sample: float | None = None
) -> tuple[Complexes, float, str]:
    """Return eigenvalues, 1/s, the fastest rate of growth, and what is marginal, in words."""
    balanced = _balanced(closed)
    unit = np.zeros_like(closed) if sample is None else np.eye(len(closed))
    standing = standing_states(balanced - unit)
    values = np.linalg.eigvals(standing.rest).astype(complex)
    if sample is not None:
        values = np.log(np.where(values == -1.0, np.finfo(float).tiny, 1.0 + values)) / sample
    zeros = np.zeros(len(closed) - len(values), dtype=complex)
    fastest = float(values.real.max(initial=0.0))
    limit = GROWS * abs(values.imag if sample else values).max(initial=0.0)
    grows = fastest if fastest > limit else 0.0
    rounding = 0.0 if sample is None else ROUNDING / sample
    still = abs(values.real) <= np.maximum(UNDAMPED * abs(values), rounding)
    swinging = values.imag[still & (values.imag > 0)] / math.tau
    return np.concatenate([values, zeros]), grows, _told(standing, swinging, layout, kept)


def _told(standing: StandingStates, swinging: Reals, layout: MechanismLayout, kept: Places) -> str:
    """Say what is free, what runs away with the time, and what swings undamped."""
    free, running = (
        list(dict.fromkeys(_named(layout, int(kept[place])) for place in places))
        for places in (standing.free, standing.running)
    )
    # Where a coordinate is free, what a controller makes of it is so too.
    free = [name for name in free if name in layout.coordinates] or free
    free = [name for name in free if name not in running]
    told = []
    if free:
        told.append(f"nothing brings {listed(free)} back")
    if running:
        told.append(f"{listed(running)} run{'s' if len(running) == 1 else ''} away with the time")
    if len(swinging):
        told.append(f"undamped at {listed([f'{each:.4g} Hz' for each in sorted(set(swinging))])}")
    return ", ".join(told)


def _named(layout: MechanismLayout, place: int) -> str:
    """Return whose a state is: a coordinate, with its rate, or a controller."""
    count = len(layout.coordinates)
    if place < 2 * count:
        return layout.coordinates[place % count]
    if place < layout.holding.start:
        controller, state = layout.controls[place - layout.first_control]
        return f"the {state} of {controller!r}"
    holding = next(name for name, held in layout.held.items() if place in held.places)
    return f"what {holding!r} holds"


@dataclass(frozen=True, eq=False)
class OpenedLoop:
    """A loop that is opened: from what acts, or is demanded at a sample, to what is demanded."""

    matrix: Reals  # A of x' = A x, or M of x <- M x, (n, n)
    given: Reals  # What acts on the states, (n,)
    read: Reals  # What is demanded of them, (n,)
    sample: float | None = None  # s; None of a continuous controller

    def ratio(self, omega: float) -> complex:
        """Return L at an angular frequency, rad/s."""
        s = 1j * omega if self.sample is None else cmath.exp(1j * omega * self.sample)
        pencil = s * np.eye(len(self.matrix)) - self.matrix
        return complex(-self.read @ np.linalg.solve(pencil, self.given.astype(complex)))

    def margins(self) -> Margins:
        """Return the margins."""
        rates = np.linalg.eigvals(_balanced(self.matrix)).astype(complex)
        if self.sample is not None:
            rates = np.log(rates[rates != 0]) / self.sample
        omegas, ends = _omegas(rates), [0.0]
        if self.sample is not None:
            highest = math.pi / self.sample
            omegas, ends = np.append(omegas[omegas < highest * (1.0 - 1e-9)], highest), [0.0, highest]
        return margins_of(self.ratio, omegas, [end for end in ends if self._is_finite(end)])

    def _is_finite(self, omega: float) -> bool:
        """Return whether there is no pole at an end, 0 or half the sampling rate."""
        turned = 0.0 if self.sample is None else math.cos(omega * self.sample)
        values = np.linalg.svd(_balanced(self.matrix) - turned * np.eye(len(self.matrix)), compute_uv=False)
        return bool(values.min(initial=math.inf) > GROWS * values.max(initial=0.0))


def _omegas(rates: Complexes) -> Reals:
    """Return the angular frequencies at which a loop is looked at, denser about its resonances."""
    sizes = abs(rates)
    sizes = sizes[sizes > GROWS * sizes.max(initial=0.0)]
    if not len(sizes):
        sizes = np.ones(1)
    low, high = math.log10(sizes.min() / BEYOND), math.log10(sizes.max() * BEYOND)
    even = np.logspace(low, high, int(A_DECADE * (high - low)))
    turning = rates[rates.imag > 0]
    spread = np.linspace(-10.0, 10.0, 82)  # Not 0, where an undamped pole lies.
    about = [rate.imag + max(abs(rate.real), GROWS * rate.imag) * spread for rate in turning]
    every = np.unique(np.concatenate([even, *about]))
    return np.asarray(every[every > 0])


def loops_of(mechanism: Mechanism, open_contacts: Collection[str] = ()) -> Iterator[ControlLoops | None]:
    """Yield the loops of continuous controllers, and those of sampled ones, None if their samples differ."""
    sampled = [each.sample is not None for each in mechanism.controllers.values()]
    if not all(sampled):
        yield control_loops(mechanism, open_contacts)
    if any(sampled):
        yield sampled_loops(mechanism, open_contacts)


def instability_of(mechanism: Mechanism) -> str:
    """Say that the linear loops are unstable with contacts closed; empty if not, or if samples differ."""
    # Beside sampled controllers, what continuous ones do alone tells nothing of the whole.
    found = [*loops_of(mechanism)][-1] if mechanism.controllers else None
    if found is None or not found.grows:
        return ""
    growing = found.rates[np.argmax(found.rates.real)]
    turns = f" at {abs(growing.imag) / math.tau:.4g} Hz" if growing.imag else ""
    return (
        "the linear loop is unstable with contacts closed and friction left out: it grows by e in "
        f"{1.0 / found.grows:.3g} s{turns}"
    )


def instability_told(mechanism: Mechanism) -> str:
    """Say so, and what to do; empty if it is not."""
    told = instability_of(mechanism)
    return f"controllers: {told}; choose other gains, 'trimmer linear' shows margins" if told else ""
