"""The search for exact limit cycles of a closed loop, from predictions of harmonic balance."""

import math
import warnings
from collections.abc import Iterable, Sequence
from itertools import chain

import numpy as np

from trimmer.arguments import positive_number, require_instance, require_instances, shown
from trimmer.balance.limit_cycle import HarmonicBalance, LimitCycle
from trimmer.balance.loop_first import takes_any_loop
from trimmer.balance.many_harmonics.feedback import feedback_balance
from trimmer.balance.solve import CALLER, limit_cycles
from trimmer.errors import OrbitNotFoundWarning, WrongTypeError
from trimmer.loops import ClosedLoop, Feedback
from trimmer.loops.flow import LoopFlow
from trimmer.loops.integration import instant_in
from trimmer.orbits.balanced_start import balanced_starts, starts_of_motion
from trimmer.orbits.describe import orbit_of_loop
from trimmer.orbits.distinct import closed, collapsed, same, shortest
from trimmer.orbits.families import by_families
from trimmer.orbits.guess import Start, starting_point
from trimmer.orbits.periodic_orbit import PeriodicOrbit, in_other_loop
from trimmer.orbits.realization import restated
from trimmer.orbits.relay_orbits import relay_orbits
from trimmer.orbits.search import (
    BalanceSearch,
    OrbitSearch,
    OrbitSearched,
    OrbitSearchInterrupted,
    PeriodicOrbits,
    RelaySearch,
    Simulations,
    SimulationSearch,
)
from trimmer.orbits.settling import settled_orbits
from trimmer.response.periodic.shooting import Return, Shot


@takes_any_loop
def periodic_orbits(
    loop: ClosedLoop | Feedback,
    guesses: HarmonicBalance | Sequence[LimitCycle | tuple[float, float]] | None = None,
    search: OrbitSearch | None = None,
) -> PeriodicOrbits:
    """Find exact periodic motions of the loop 1 + N G = 0, stable or not, by Newton's method.

    Each guess gives a first harmonic from which the motion is followed exactly through its events for half a
    period; the state that returns with its signs changed belongs to an orbit. Where that fails, as with brief
    contacts, more harmonics are balanced first. All elements are odd, so the orbits that harmonic balance can
    predict have this symmetry.

    Not every orbit is near a guess. Those of a relay that return with their signs changed after one switch
    are all found, on an interval of periods (``trimmer.orbits.half_period``). Other stable ones are found by
    long simulations from many initial states, if these are asked for, or if harmonic balance predicts nothing
    or a guess leads to no orbit. The answer tells what was searched. Of a ``Feedback`` of several
    elements or with frictions the guesses are the motions that ``harmonic_balance`` finds, which may miss
    some, and simulations go beside them unless they are never to.

    Args:
        loop: The closed loop, or a ``Feedback`` without drives; or ``system, element`` in its place. The
            system is strictly proper, with one input and one output, and continuous in time.
        guesses: All limit cycles that harmonic balance predicts, as it gives them or, if none are given, as
            ``limit_cycles`` does; or else limit cycles and pairs of amplitude (in the unit of the element's
            input) and omega (rad/s).
        search: What to search beside them; if not given ``OrbitSearch()`` beside all predictions, and nothing
            beside other guesses.

    Returns:
        The orbits found, by falling amplitude, each once, whatever its phase; an orbit that is not its own
        mirror image stands for that, too, and the largest that was met of a continuum for all of it
        (``families``). Its ``search`` is what was searched.

    Raises:
        WrongTypeError: if neither a closed loop nor a system and an element are given.
        ValueError: if a guess is not positive and finite, or the loop is not well posed.
        UnsupportedMotionError: if the element or the system cannot be simulated.

        OrbitSearchInterrupted: if an interrupt (Ctrl-C) ended the simulations; it holds what was found until
            then.

    Warns:
        OrbitNotFoundWarning: for each guess from which no orbit was found; often there is none.
    """
    if search is not None:
        require_instance("search", search, OrbitSearch, "a trimmer.OrbitSearch")
    given = loop
    if isinstance(loop, Feedback):
        one = loop.as_closed_loop()
        if one is None:
            return _of_feedback(loop, guesses, search or OrbitSearch())
        loop = one
    known = restated(loop)
    orbits: list[PeriodicOrbit] = []
    predicted = guesses is None or isinstance(guesses, HarmonicBalance)
    tried = _guesses(loop, guesses)
    failed = 0
    for guess in tried:
        amplitude, omega = (guess.amplitude, guess.omega) if isinstance(guess, LimitCycle) else guess
        orbit = _near(known.loop, amplitude, omega, guess if isinstance(guess, LimitCycle) else None)
        if orbit is None:
            failed += 1
            _warn(f"the amplitude {amplitude:.6g} and omega {omega:.6g} rad/s")
        else:
            _add(orbits, [orbit])
    settings = OrbitSearch() if search is None and predicted else search
    relay, simulated = _wider(known.loop, settings, orbits, failed > 0 or not tried)
    searched = OrbitSearched(len(tried), predicted, failed, relay, simulated)
    told = [known.told(orbit) for orbit in orbits]
    return _found(told if given is loop else [in_other_loop(each, given) for each in told], searched)


def _of_feedback(loop: Feedback, guesses: object, search: OrbitSearch) -> PeriodicOrbits:
    """Find the orbits of a loop of several elements near balanced motions, and by simulations."""
    if guesses is not None:
        raise WrongTypeError(
            "guesses of amplitude and omega are for loops of one element; forced_orbit takes a state as guess"
        )
    balance = feedback_balance(loop)
    near = [_first(loop, starts_of_motion(loop, each)) for each in balance.motions]
    for each, found in zip(balance.motions, near, strict=True):
        if found is None:
            _warn(f"the balanced motion of {each.omega:.6g} rad/s")
    orbits: list[PeriodicOrbit] = []
    _add(orbits, [orbit_of_loop(*shortest(*found)) for found in near if found is not None])
    simulated = None
    if search.simulations is not Simulations.NEVER:
        settled, simulated = settled_orbits(loop, search, orbits)
        orbits += settled
    tried = BalanceSearch(balance.order, balance.tried, balance.left)
    return _found(orbits, OrbitSearched(len(near), True, near.count(None), None, simulated, tried))


def _found(orbits: list[PeriodicOrbit], searched: OrbitSearched) -> PeriodicOrbits:
    """Return orbits by amplitude, with what was searched.

    Raises:
        OrbitSearchInterrupted: if an interrupt (Ctrl-C) ended the search.
    """
    by_amplitude, families = by_families(orbits)
    found = PeriodicOrbits(by_amplitude, searched, families)
    if searched.simulations is not None and searched.simulations.interrupted:
        raise OrbitSearchInterrupted(found)
    return found


def _guesses(
    loop: ClosedLoop, guesses: HarmonicBalance | Sequence[LimitCycle | tuple[float, float]] | None
) -> Sequence[LimitCycle | tuple[float, float]]:
    if guesses is None:
        return limit_cycles(loop)
    if isinstance(guesses, HarmonicBalance):
        return guesses.limit_cycles
    each = "a limit cycle or a pair of amplitude and omega"
    listed = require_instances("guesses", guesses, object, each)
    return [
        guess if isinstance(guess, LimitCycle) else _checked(f"guesses[{place}]", guess)
        for place, guess in enumerate(listed)
    ]


def _wider(
    loop: ClosedLoop, settings: OrbitSearch | None, orbits: list[PeriodicOrbit], needed: bool
) -> tuple[RelaySearch | None, SimulationSearch | None]:
    """Search beside the guesses, and add what is found.

    Args:
        loop: The closed loop.
        settings: What to search; nothing if there are none.
        orbits: Those that are known; others are added.
        needed: Whether a guess led to no orbit, or there was none.
    """
    if settings is None:
        return None, None
    relay = relay_orbits(loop, settings.half_periods)
    _add(orbits, [] if relay is None else relay[0])
    simulated = None
    when = settings.simulations
    if when is Simulations.ALWAYS or (when is Simulations.WHERE_PREDICTIONS_FAIL and needed):
        settled, simulated = settled_orbits(loop, settings, orbits)
        orbits += settled
    return None if relay is None else relay[1], simulated


def _add(orbits: list[PeriodicOrbit], found: list[PeriodicOrbit]) -> None:
    """Add those that are new."""
    for orbit in found:
        if not any(same(orbit, other) for other in orbits):
            orbits.append(orbit)


def _checked(name: str, guess: object) -> tuple[float, float]:
    """Return a guess as amplitude and omega."""
    if isinstance(guess, str) or not isinstance(guess, Sequence) or len(guess) != 2:
        raise WrongTypeError(
            f"{name} must be a limit cycle or a pair of amplitude and omega (rad/s), not {shown(guess)}"
        )
    amplitude, omega = guess
    return _positive("amplitude", amplitude), _positive("omega", omega)


def _positive(name: str, value: object) -> float:
    return positive_number(f"{name} of a guess", value)


def _near(
    loop: ClosedLoop, amplitude: float, omega: float, prediction: LimitCycle | None
) -> PeriodicOrbit | None:
    if np.isnan(loop.element.describing_function(amplitude, omega)):
        return None
    first = starting_point(loop, amplitude, omega), omega
    found = _first(loop, chain([first], balanced_starts(loop, amplitude, omega)))
    return None if found is None else orbit_of_loop(*shortest(*found), prediction)


def _first(loop: ClosedLoop | Feedback, starts: Iterable[tuple[Start, float]]) -> tuple[Return, Shot] | None:
    """Return what the first of the starts that leads to an orbit does."""
    shots = (_shot(loop, start, omega) for start, omega in starts)
    return next((found for found in shots if found is not None), None)


def _warn(start: str) -> None:
    warnings.warn(f"no periodic orbit was found from {start}", OrbitNotFoundWarning, stacklevel=CALLER + 2)


def _shot(loop: ClosedLoop | Feedback, start: Start, omega: float) -> tuple[Return, Shot] | None:
    problem = Return(LoopFlow(loop), 0, mirrored=True, alike=True)
    begin = instant_in(problem.flow.modes, start.mode, start.state)
    shot = closed(problem, begin, math.pi / omega, start.sizes)
    return None if shot is None or collapsed(shot, start.sizes) else (problem, shot)
