"""What is searched for periodic orbits, what was, and the orbits themselves."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import overload

from trimmer.arguments import real_values, whole_number
from trimmer.choices import Choice
from trimmer.orbits.families import OrbitFamily
from trimmer.orbits.half_period import Interval
from trimmer.orbits.periodic_orbit import ORBIT_COLUMNS, PeriodicOrbit
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Table, attributes


class Simulations(Choice):
    """When long simulations from many initial states are to look for stable orbits."""

    NEVER = "never"
    WHERE_PREDICTIONS_FAIL = "where harmonic balance predicts nothing, or a prediction leads to no orbit"
    ALWAYS = "always"


@dataclass(frozen=True)
class OrbitSearch:
    """What is to be searched beside the neighbourhood of guesses.

    Attributes:
        simulations: When to simulate; a member, or its word, such as ``always``.
        starts: Initial states to simulate from.
        seed: Of the generator that draws them; the same seed gives the same states.
        steps: Steps of a simulation, each as long as the fastest mode allows, after which it is given up; a
            million take about a second.
        half_periods: Shortest and longest half period, s, for which the symmetric orbits of a relay are
            looked for; chosen from poles and zeros if not given.

    Raises:
        ChoiceError: if ``simulations`` is none of its words.
        ValueError: if a number is out of range, or none.
    """

    simulations: Simulations = Simulations.WHERE_PREDICTIONS_FAIL
    starts: int = 32
    seed: int = 0
    steps: int = 200_000
    half_periods: Interval | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "simulations", Simulations.chosen(self.simulations, "simulations"))
        for name, least in (("starts", 1), ("seed", 0), ("steps", 1)):
            whole_number(name, getattr(self, name), least)
        if self.half_periods is None:
            return
        limits = real_values("half_periods", self.half_periods)
        shortest, longest = limits.tolist() if limits.shape == (2,) else (math.nan, math.nan)
        if not 0 < shortest < longest < math.inf:
            raise ValueError(
                "half_periods must be (shortest, longest) with 0 < shortest < longest < inf, s, "
                f"not {self.half_periods!r}"
            )


@dataclass(frozen=True)
class RelaySearch:
    """The zeros of a relay's half-period equation.

    Attributes:
        half_periods: Shortest and longest half period searched, s.
        zeros: Zeros on this interval; not all are orbits, as the relay may switch in between.
        undecided: Parts of the interval that may hold others.
        grid: Number of durations on this interval, in a fixed ratio, from whose pairs orbits with two
            switches at unequal distances were looked for; 0 if they were not.
    """

    half_periods: Interval
    zeros: int
    undecided: tuple[Interval, ...]
    grid: int

    @property
    def sentence(self) -> str:
        """What was searched, in words."""
        shortest, longest = self.half_periods
        sentence = (
            "all orbits of the relay that return with their signs changed after one switch, with half "
            f"periods from {shortest:.6g} to {longest:.6g} s"
        )
        if self.undecided:
            width = sum(end - begin for begin, end in self.undecided)
            sentence += f" except in {counted(len(self.undecided), 'interval')} of {width:.3g} s together"
        if not self.grid:
            return sentence
        return (
            f"{sentence}; orbits with two switches at unequal distances from a grid of {self.grid} durations"
        )


@dataclass(frozen=True)
class SimulationSearch:
    """Long simulations.

    Attributes:
        starts: Initial states that motions were followed from.
        seed: Of the generator that drew them.
        settled: How many motions settled on an orbit.
        at_rest: How many ended without further events.
        diverged: How many grew without bound.
        accumulated: How many stopped as their events accumulate, which most often is rest, too.
        left: How many did none of this within the steps and events allowed.
        planned: Initial states that were asked for; more than ``starts`` if the search was interrupted.
    """

    starts: int
    seed: int
    settled: int
    at_rest: int
    diverged: int
    accumulated: int
    left: int
    planned: int

    @property
    def interrupted(self) -> bool:
        """Whether the search ended before its time."""
        return self.starts < self.planned

    @property
    def sentence(self) -> str:
        """What was searched, in words."""
        ends = (
            (self.settled, "settled on an orbit"),
            (self.at_rest, "came to rest"),
            (self.diverged, "grew without bound"),
            (self.accumulated, "ended as their events accumulate"),
            (self.left, "did not settle in time"),
        )
        sentence = ", ".join(f"{count} {what}" for count, what in ends if count)
        starts = f"{self.starts} of {self.planned}" if self.interrupted else f"{self.starts}"
        return f"stable orbits by simulation from {starts} initial states (seed {self.seed}: {sentence})"


@dataclass(frozen=True)
class BalanceSearch:
    """Harmonic balance of several elements, which has no certificate.

    Attributes:
        order: Highest harmonic.
        starts: Starts on a grid that were tried.
        left: Further starts that were not.
    """

    order: int
    starts: int
    left: int

    @property
    def sentence(self) -> str:
        """What was searched, in words."""
        others = f", {self.left} more left out" if self.left else ""
        return f"order {self.order} from {counted(self.starts, 'start')} on a grid{others}; no certificate"


@dataclass(frozen=True)
class OrbitSearched:
    """What was searched.

    Attributes:
        guesses: How many guesses were followed.
        predicted: Whether they are all that harmonic balance predicts.
        failed: How many led to no orbit.
        relay: The half-period equation, if it was solved.
        simulations: The simulations, if there were any.
        balance: The balance that predicts, of several elements.
    """

    guesses: int
    predicted: bool
    failed: int
    relay: RelaySearch | None
    simulations: SimulationSearch | None
    balance: BalanceSearch | None = None

    @property
    def doubts(self) -> tuple[str, ...]:
        """What the search left open, in sentences without a full stop; nothing if it went to its end."""
        relay, simulations = self.relay, self.simulations
        doubts = (
            (self.failed, f"{self._starts(self.failed)} led to no orbit"),
            (self.balance and self.balance.left, "some starts of harmonic balance were left out"),
            (relay and len(relay.undecided), "part of the interval of half periods is undecided"),
            (simulations and simulations.left, "some simulations did not settle in time"),
            (simulations and simulations.interrupted, "the search was interrupted"),
        )
        return tuple(doubt for count, doubt in doubts if count)

    @property
    def sentence(self) -> str:
        """What was searched and what was not, in words."""
        searched = [self._near_guesses]
        searched += [part.sentence for part in (self.relay, self.simulations) if part is not None]
        simulated = "stable orbits that none of these initial states leads to"
        others = f"other unstable orbits, {simulated}" if self.simulations else _NOT_SIMULATED
        return f"searched: {'; '.join(searched)}. Not searched: {others}."

    def _starts(self, count: int) -> str:
        return (
            f"{counted(count, 'prediction')} of harmonic balance"
            if self.predicted
            else counted(count, "guess")
        )

    @property
    def _near_guesses(self) -> str:
        how = "" if self.balance is None else f" ({self.balance.sentence})"
        if not self.guesses:
            none = f"harmonic balance{how}, which predicts no limit cycle"
            return none if self.predicted else "near no guess"
        led = "all led to an orbit" if not self.failed else f"{self.failed} led to none"
        return f"near {self._starts(self.guesses)}{how} ({led})"


_NOT_SIMULATED = "other orbits, which simulations look for if they are asked for (--simulate)"


@dataclass(frozen=True, eq=False, repr=False)
class PeriodicOrbits(Tabular, Drawn, Sequence[PeriodicOrbit]):
    """Orbits by falling amplitude, and what was searched for them.

    It is a sequence, and equal to any other with the same orbits.

    ``plot`` draws them in the phase plane of the element's input: stable ones solid, others dashed.

    Attributes:
        orbits: The orbits.
        search: What was searched; an empty answer means no more than that.
        families: Continua, each of which one of the orbits stands for.
    """

    orbits: tuple[PeriodicOrbit, ...]
    search: OrbitSearched
    families: tuple[OrbitFamily, ...] = ()

    @overload
    def __getitem__(self, place: int) -> PeriodicOrbit: ...
    @overload
    def __getitem__(self, place: slice) -> tuple[PeriodicOrbit, ...]: ...
    def __getitem__(self, place: int | slice) -> PeriodicOrbit | tuple[PeriodicOrbit, ...]:
        return self.orbits[place]

    def __len__(self) -> int:
        return len(self.orbits)

    @property
    def success(self) -> bool:
        """Whether the search went to its end: each guess led to an orbit, and nothing beside them is open."""
        return not self.search.doubts

    @property
    def message(self) -> str:
        """What came out, in words."""
        found = f"{counted(len(self), 'periodic orbit')} found"
        return "; ".join([found, *self._continua, *self.search.doubts, self.search.sentence])

    @property
    def _continua(self) -> list[str]:
        return [family.sentence for family in self.families]

    def _told(self) -> str:
        found = counted(len(self), "periodic orbit")
        return "; ".join([found, *self._continua, *(self.search.doubts or ["the search went to its end"])])

    def _table(self) -> Table:
        amplitude = attributes(amplitude=self.orbits[0].unit if self.orbits else "")
        return Table("Periodic orbits", self.orbits, (*amplitude, *ORBIT_COLUMNS))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and list(self) == list(other)

    def __hash__(self) -> int:
        return hash(self.orbits)


class OrbitSearchInterrupted(KeyboardInterrupt):
    """An interrupt (Ctrl-C) ended the search by simulation.

    Attributes:
        orbits: Those found until then; their ``message`` tells how far the search went.
    """

    def __init__(self, orbits: PeriodicOrbits) -> None:
        super().__init__(orbits.message)
        self.orbits = orbits
