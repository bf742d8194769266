"""Sampled controllers as samplers of the core: what they read of a motion, and what they write."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.controllers.sampled_laws import BEFORE, SampledLaw, law_of
from trimmer.contact.readouts.outputs import signal_of, speed_beyond
from trimmer.contact.state.layout import MechanismLayout
from trimmer.contact.state.rows import EndRows
from trimmer.errors import MechanismError
from trimmer.hybrid.clock import ABOVE, BELOW, WITHIN
from trimmer.hybrid.system import Sampler
from trimmer.hybrid.tables import Modes
from trimmer.kept_property import cached_property
from trimmer.mechanism.controls.controllers import DIFFERENCE
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import OutputKind
from trimmer.mechanism.place_text import place_text
from trimmer.motion.signals import Signal, Steady
from trimmer.motion.time_scale import slowest_period

SHORTEST = 1e-9  # Shortest sample, as a share of the slowest period
A_SECOND = 1.0  # Taken for that period where nothing has one, s


@dataclass(frozen=True, eq=False)
class SampledControllers:
    """The sampled controllers of a mechanism."""

    mechanism: Mechanism  # The mechanism
    layout: MechanismLayout  # Names and places of its extended state
    _known: dict[bool, tuple[Reals, Reals]] = field(default_factory=dict, init=False, repr=False)

    @cached_property
    def laws(self) -> dict[str, SampledLaw]:
        """The law of each, by name."""
        return {name: law_of(self.mechanism.controllers[name]) for name in self.layout.held}

    @cached_property
    def samplers(self) -> tuple[Sampler, ...]:
        """When each samples and acts, and where it writes."""
        limits = {name: self.mechanism.controllers[name].limit for name in self.layout.held}
        return tuple(
            Sampler(
                held.sample,
                held.delay,
                np.inf if limits[name] is None else float(limits[name] or 0.0),
                (*held.states, *held.waiting),
                (held.waiting[0], held.acting),
            )
            for name, held in self.layout.held.items()
        )

    def require_countable(self, flow: Reals) -> None:
        """Refuse samples of which the slowest mode of the state's flow, (n, n), or the drive has too many.

        Raises:
            MechanismError: if one is shorter than 1e-9 of the slowest period.
        """
        moves = slowest_period(flow)
        slowest = max(moves or A_SECOND, self.layout.period or 0.0)
        of = "the slowest period" if moves else "a second, since no part by itself has a period"
        for name, held in self.layout.held.items():
            if held.sample < SHORTEST * slowest:
                place = ("controllers", name, "sample")
                raise MechanismError(
                    f"{place_text(place)} = {held.sample:g}: it is shorter than "
                    f"{SHORTEST:g} of {of}, {slowest:.3g} s, and no motion could count so many "
                    "samples; give a longer one, or none for a continuous controller",
                    place=place,
                )

    def sampling(self, modes: Modes[Any], number: int) -> tuple[Reals, Reals]:
        """Return what each demands in a mode, (c, N), and what it writes, (c, 3, h, N)."""
        signals = [self.measured(name, modes) for name in self.layout.held]
        signals += [self._speed(name, modes) for name in self.layout.held]
        steady = all(isinstance(each, Steady) for each in signals)
        if not steady or steady not in self._known:
            self._known[steady] = self._sampling(modes, number)
        return self._known[steady]

    def summed(self, modes: Modes[Any], number: int, largest: Reals) -> Reals:
        """Return how large entries must be to count beside what samplers add; see ``Clockwork.summed``."""
        reach, summed = largest.copy(), np.zeros_like(largest)
        for sampler, rows in zip(self.samplers, abs(self.sampling(modes, number)[1][:, WITHIN]), strict=True):
            places, (waiting, acting) = list(sampler.places), sampler.acting
            # What was demanded last comes last, and goes through all places before it to where it acts.
            for place, row in [*zip(places, rows, strict=False)][::-1]:
                reach[place] = summed[place] = max(reach[place], row @ reach)
            read = rows[: len(places), places] * (1.0 - np.eye(len(places)))
            enough = np.divide(summed[places, None], read, out=np.full_like(read, np.inf), where=read > 0)
            least = enough.min(axis=0, initial=np.inf)
            summed[places] = np.maximum(summed[places], np.where(least < np.inf, least, 0.0))
            summed[acting] = summed[waiting]
        return summed

    def _sampling(self, modes: Modes[Any], number: int) -> tuple[Reals, Reals]:
        names, size = list(self.layout.held), self.layout.size
        height = max(len(each.places) for each in self.samplers)
        demands, updates = np.zeros((len(names), size)), np.zeros((len(names), 3, height, size))
        for place, name in enumerate(names):
            terms, law, held = self._terms(name, modes, number), self.laws[name], self.layout.held[name]
            demand, limit = law.demand @ terms, self.samplers[place].limit
            moved = np.eye(size)[list(held.waiting[1:])]
            demands[place] = demand
            for where, side in ((WITHIN, 0.0), (ABOVE, 1.0), (BELOW, -1.0)):
                acts = demand
                if side and np.isfinite(limit):
                    acts = side * limit * np.eye(size)[-1]
                kept = law.keep @ terms + np.outer(law.follow, acts - demand)
                updates[place, where, : len(self.samplers[place].places)] = np.concatenate(
                    [kept, moved, [acts]]
                )
        return demands, updates

    def _terms(self, name: str, modes: Modes[Any], number: int) -> Reals:
        """Return the states of a law and its inputs as functionals, (s + 4, N)."""
        controller, held = self.mechanism.controllers[name], self.layout.held[name]
        rows, size = EndRows(self.mechanism, self.layout), self.layout.size
        reference, rate = rows.reference(controller.reference)
        return np.array(
            [
                *np.eye(size)[list(held.states)],
                self.measured(name, modes)(number),
                reference,
                rate,
                self._speed(name, modes)(number),
            ]
        )

    def measured(self, name: str, modes: Modes[Any]) -> Signal:
        """Return what a controller measures."""
        output = self.mechanism.outputs[self.mechanism.controllers[name].measure]
        return signal_of(self.mechanism, modes, output)

    def _speed(self, name: str, modes: Modes[Any]) -> Signal:
        """Return the speed v; of a difference the share of the frame, in which a displacement is."""
        controller, outputs = self.mechanism.controllers[name], self.mechanism.outputs
        measured = outputs[controller.measure]
        if controller.speed == DIFFERENCE:
            return Steady(
                speed_beyond(self.layout, measured) * np.eye(1, self.layout.size, self.layout.size - 1)[0]
            )
        if controller.speed is not None:
            return signal_of(self.mechanism, modes, outputs[controller.speed])
        if measured.kind is not OutputKind.DISPLACEMENT:
            return Steady(np.zeros(self.layout.size))
        return signal_of(self.mechanism, modes, replace(measured, kind=OutputKind.VELOCITY))

    def names_of(self, name: str) -> tuple[str, ...]:
        """Return what the states are that a controller holds."""
        held = self.layout.held[name]
        others = [f"u{number}" for number in range(1, len(held.places) - len(held.states) + 1)]
        return tuple(f"{name} {each}" for each in (*self.laws[name].states, *others))

    def remembered(self, modes: Modes[Any]) -> Iterator[tuple[int, Signal]]:
        """Yield the places of what was measured at the last sample, and what it is."""
        for name, law in self.laws.items():
            if BEFORE in law.states:
                yield self.layout.held[name].states[law.states.index(BEFORE)], self.measured(name, modes)
