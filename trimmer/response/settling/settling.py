"""A motion followed until it repeats: orbits are sought on the way, and accepted when it settles to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.motion.flow import Flow
from trimmer.motion.subject import Subject
from trimmer.response.flows import known_flow_of
from trimmer.response.periodic.orbit import Orbit, orbit_of
from trimmer.response.periodic.pace import pace_of
from trimmer.response.periodic.shooting import CLOSED, Patience, Return, sizes_of, solve
from trimmer.response.settling.recurrence import approach, candidates, has_returned, settles_to
from trimmer.response.settling.solved import Solved, solved
from trimmer.response.without_events.linear_motion import grows_for_ever
from trimmer.response.without_events.rest import Rest
from trimmer.response.without_events.sampled_rest import sampled_rest

FIRST, LONGEST = 8, 128  # Drive periods before the first look at a motion, and at most between two looks
KEPT = 256  # Drive periods that are kept for a look
LONG_LOOK = 2048  # Drive periods over which a slow approach is measured
MOST_REPEATS = 24  # The largest number of drive periods after which a motion is taken to repeat
PATIENCE = Patience(iterations=12, halvings=4, followed=0)  # With which an orbit is looked for on the way


@dataclass(eq=False)
class Settling:
    """One motion, followed from its start."""

    flow: Flow  # The motion of the mechanism
    instant: Instant  # Where it is
    # Stable orbits that it may settle to; those found on the way are added
    known: list[Orbit] = field(default_factory=list)
    # At the start of each of the last drive periods, (count, n), shifted so that leaders are at 0
    states: Reals = field(init=False)
    periods: int = 0  # Drive periods that were followed
    ending: Ending = Ending.REACHED_END  # Why it cannot be followed further, if so
    solved: Solved | None = None  # What it comes to, if it was seen that no event comes any more
    grows: bool = False  # Whether it was seen that no event comes any more and it grows for ever
    rest: Rest | None = None  # Where it rests under samples that never return together
    _quiet: bool = True

    def __post_init__(self) -> None:
        self.states = self.flow.reduced(self.instant.state[None])

    @property
    def can_go_on(self) -> bool:
        """Whether the motion can be followed further, and is not known for all time."""
        known = self.solved is not None or self.rest is not None or self.grows
        return self.ending is Ending.REACHED_END and not known

    def follow(self, periods: int) -> bool:
        """Go on; returns whether that was possible."""
        strobe = self.flow.strobe(self.instant, periods)
        self.instant, self.ending = strobe.end, strobe.ending
        self.states = np.concatenate([self.states, self.flow.reduced(strobe.states[1:])])[-KEPT:]
        self.periods += len(strobe.states) - 1
        self._quiet = not strobe.counts[-1].any()
        return self.can_go_on

    def until_settled(self, most_periods: int) -> Orbit | None:
        """Return the orbit that the motion settles to within some drive periods, None if it does not.

        Where it meets no event any more, ``solved`` is set, and the motion is not followed further.
        """
        longest = LONGEST * pace_of(self.flow.subject)
        block, look = FIRST, FIRST
        while self.periods < most_periods:
            if not self.follow(min(block, most_periods - self.periods)):
                return None
            orbit = next((each for each in self.known if settles_to(each, self.states)), None)
            if orbit is None and self.periods >= look:
                orbit, look = self._looked_for(), self.periods + min(self.periods, longest)
            if orbit is None and self._quiet:
                self.solved = solved(self.flow, self.instant)
                if self.solved is not None:
                    return self.solved.orbit
                self.grows = grows_for_ever(self.flow, self.instant)
                if self.grows:
                    return None
            if orbit is not None or self.rest is not None:
                return orbit
            block = FIRST if self._is_near() else min(look - self.periods, longest)
        return None

    @property
    def approaches(self) -> bool:
        """Whether it comes ever nearer to a stable orbit that is known, however slowly."""
        return any(approach(orbit, self.states) for orbit in self.known)

    def slowly_approached(self, instant: Instant) -> Orbit | None:
        """Return the stable orbit to which a motion comes nearer as slowly as its multipliers say.

        Args:
            instant: Where the motion is, after a long wait.
        """
        if not self.known:
            return None
        strobe = self.flow.strobe(instant, LONG_LOOK)
        if strobe.ending is not Ending.REACHED_END:
            return None
        return next((each for each in self.known if 0.5 <= approach(each, strobe.states) <= 2.0), None)

    def _is_near(self) -> bool:
        """Return whether the last state is near a stable orbit that is known."""
        last = self.states[-1]
        return any(
            (abs((orbit.strobed - last) / orbit.sizes).max(axis=1) < 0.5).any() for orbit in self.known
        )

    def _looked_for(self) -> Orbit | None:
        together = self.flow.modes.system.layout.recurrence
        if not together:  # Its drives never return together.
            self.rest = self._rest() if self._quiet else None
            return None
        late = -self.instant.periods % together
        if late and not self.follow(late):
            return None
        # Seen where all drives have returned.
        alike = self.states[(len(self.states) - 1) % together :: together]
        most = max(MOST_REPEATS // together, 1)
        course = self.flow.course(self.instant, 1)
        if course.ending is not Ending.REACHED_END:
            return None
        sizes, here = sizes_of(course), self.instant.state
        tried = [(periods * together, here) for periods in candidates(alike, sizes, most)]
        if not self.known:
            # A motion that winds around an orbit for long comes near itself late, but has it in its middle.
            tried.append((together, alike[len(alike) // 2 :].mean(axis=0)))
        for periods, state in tried:
            orbit = orbit_near(self.flow, state, self.instant, periods)
            if orbit is None:
                continue
            if (orbit.stable or orbit.neutral) and has_returned(self.states, sizes, periods):
                return orbit
            if orbit.stable and not _listed(orbit, self.known):
                self.known.append(orbit)
                if settles_to(orbit, self.states):
                    return orbit
        return None

    def _rest(self) -> Rest | None:
        """Return where it rests, if nothing moves."""
        return sampled_rest(self.flow, self.instant, sizes_of(self.flow.course(self.instant, 1)))


def orbit_near(flow: Flow, state: Reals, like: Instant, periods: int) -> Orbit | None:
    """Return the orbit near a state that closes after some drive periods, over as few as it needs.

    Args:
        flow: What moves.
        state: Near the start of a period of the orbit, (n,).
        like: An instant whose statuses hold there too.
        periods: Drive periods after which it may close.
    """
    begin, passed = flow.at(state, like=like), False
    while True:
        shot = solve(Return(flow, periods), begin, patience=PATIENCE)
        if shot is None:
            return None
        orbit = orbit_of(flow, shot, periods)
        if not orbit.success:
            if passed or shot.miss > CLOSED:
                return None
            # It passes the state where it began, on another side of a relay.
            passed, periods = True, 2 * periods
            continue
        if orbit.period_count == periods:
            return orbit
        begin, periods = orbit.instant, orbit.period_count


def orbit_from_rest(subject: Subject, most_periods: int) -> Orbit | None:
    """Return the orbit that a mechanism or a loop settles to from rest, or from its own start.

    Args:
        subject: What moves; it has a frequency.
        most_periods: Drive periods to wait at most.

    Returns:
        The orbit over its smallest number of drive periods; None if the motion does not settle until then.
    """
    flow = known_flow_of(subject)
    return Settling(flow, flow.rest()).until_settled(most_periods)


def _listed(orbit: Orbit, known: Sequence[Orbit]) -> bool:
    from trimmer.response.results.same import same_orbit

    return any(same_orbit(orbit, other) for other in known)
