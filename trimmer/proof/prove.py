"""Prove what was computed: the check gets a statement with its data, and nothing of what computed it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from trimmer.arguments import require_instance, require_instances
from trimmer.balance.limit_cycle import HarmonicBalance, LimitCycle
from trimmer.balance.loop_first import takes_a_loop
from trimmer.balance.solve import checked_range
from trimmer.branches.followed import FollowedBranch
from trimmer.branches.period_maps.driven_passage import DrivenPassage
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.contact.flow import MechanismFlow
from trimmer.errors import TrimmerError
from trimmer.hybrid.stretch import Ending
from trimmer.loops.loops import ClosedLoop
from trimmer.loops.motion import LoopMotion
from trimmer.mechanism import Mechanism
from trimmer.motion.course import Course
from trimmer.proof.modes import begun_amid, equations_data, motion_data, orbit_data, stated_motion, told_once
from trimmer.proof.outcome import LIMIT, UndecidedError, Verdict
from trimmer.proof.proof import Proof, proof_of
from trimmer.proof.read_of import functionals_data, read_of_motion
from trimmer.proof.terms import element_data, plant_data
from trimmer.response.flows import flow_of, require_subject
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.simulation.motion import MechanismMotion

if TYPE_CHECKING:
    from trimmer.branches.period_maps.driven_map import DrivenMap
    from trimmer.motion.flow import Flow
    from trimmer.motion.subject import Subject

ASIDE = 1e-6
"""Distance from a special point of the values between which slopes are taken, as a share of its value."""
LATER, CLOSED = 0.37, 1e-3
"""Share of a drive period after which to begin if the motion does not return, to a share of its size."""
COVERED = (
    SpecialKind.GRAZING,
    SpecialKind.TORUS,
    SpecialKind.FOLD,
    SpecialKind.PERIOD_DOUBLING,
    SpecialKind.SYMMETRY_BREAKING,
)


@takes_a_loop
def prove_limit_cycles(
    loop: ClosedLoop,
    limit_cycles: Sequence[LimitCycle] | HarmonicBalance,
    omega_range: tuple[float, float] | None = None,
    limit: float = LIMIT,
) -> Proof:
    """Prove that a list of limit cycles is that of harmonic balance: no more, no less.

    All solutions of 1 + N(A, omega) G(j omega) = 0 are enclosed in balls from the coefficients and the closed
    forms alone: where N keeps its direction by the roots of a polynomial, else by boxes of the whole plane.

    Args:
        loop: The closed loop, as for ``limit_cycles``; its numbers are taken as exact.
        limit_cycles: The list, or the result of ``harmonic_balance``.
        omega_range: Lowest and highest angular frequency, rad/s, within which the list is complete; all if
            not given.
        limit: Time after which the check gives up, undecided, s.

    Returns:
        Proven, if there are exactly these, each within 1e-9 of its amplitude and omega. Refuted, if one is
        missing or is none. Undecided, with the reason, where balls do not tell.

    Raises:
        WrongTypeError: if an argument is of another type.
        FrequencyRangeError: if the range is not 0 < lowest < highest < inf.
        MissingPackageError: if python-flint is not installed.
    """
    listed = limit_cycles.limit_cycles if isinstance(limit_cycles, HarmonicBalance) else limit_cycles
    cycles = require_instances("limit_cycles", listed, LimitCycle, "a LimitCycle")
    data = {
        "plant": plant_data(loop.system),
        "element": element_data(loop.element),
        "omega_range": None if omega_range is None else list(checked_range(omega_range)),
        "limit_cycles": [{"amplitude": float(each.amplitude), "omega": float(each.omega)} for each in cycles],
    }
    if data["element"] is None:
        reason = f"{loop.element!r} has no closed form that the check knows"
        return Proof("limit cycles", Verdict.UNDECIDED, "", reason, data)
    return proof_of("limit cycles", data, limit)


def prove_orbit(system: Subject, orbit: Orbit, limit: float = LIMIT, readings: Sequence[str] = ()) -> Proof:
    """Prove that a system has a periodic motion where one was computed, with these events and no other.

    What is taken for granted are the equations of each mode, as the assembler of the system gives them: flow,
    event functions, and what an event makes of the state; their doubles are taken as exact, and so is the
    period of a drive. What the law of an event makes zero is taken as zero.

    Args:
        system: The mechanism or loop; its modes are those of the statement.
        orbit: The orbit, as ``forced_orbit``, ``periodic_orbits`` or ``respond`` gives it.
        limit: Time after which the check gives up, undecided, s.
        readings: What is told of the motion too, by name: extremes, integral, mean and root mean square of
            ``outputs.NAME``, of its rate beside the ground ``rates.NAME``, of an acceleration
            ``bodies.NAME``, of what is 1 in stick and else 0 ``frictions.NAME``, and of ``contacts.NAME``
            how fast its sides meet at each contact made. These functionals are taken for granted as the
            equations are. Of a motion that advances nothing is read that changes with a shift.

    Returns:
        Proven, with the largest modulus of its multipliers enclosed. Refuted, if the motion is elsewhere, has
        another sequence of events or another stability. Undecided, with the reason, where balls do not tell,
        as at a grazing, or where it is not covered: several impacts at one instant, a chatter that ends, two
        drives. A motion that advances is proven relative to one body of it; samples come at the times of
        the file, each demand within its limit or beyond it as the file says.

    Raises:
        WrongTypeError: if an argument is of another type.
        MissingPackageError: if python-flint is not installed.
    """
    require_subject(system)
    require_instance("orbit", orbit, Orbit, "an orbit")
    flow = orbit.flow if orbit.subject is system else flow_of(system)
    try:
        data = {
            **orbit_data(orbit, flow),
            "functionals": functionals_data(orbit, flow, readings),
            "levels": [],
        }
    except UndecidedError as error:
        return Proof("orbit", Verdict.UNDECIDED, "", str(error), {})
    return proof_of("orbit", data, limit)


def prove_motion(
    system: Subject, motion: MechanismMotion | LoopMotion, limit: float = LIMIT, readings: Sequence[str] = ()
) -> Proof:
    """Prove that a system moves so from a state: with these events and no other, over a time.

    What is taken for granted are the equations of each mode, which mode follows an event and what becomes of
    the states there, and what a controller's clock or a reference makes of them at which times. Each mode is
    held against its event functions from there on. Where several frictions come to rest at one instant,
    another mode may be as right.

    Args:
        system: The mechanism or loop.
        motion: What ``simulate`` gives of it, or ``step``.
        limit: Time after which the check gives up, undecided, s.
        readings: As for ``prove_orbit``, and at the end; ``outputs.NAME = VALUE`` tells when that is so.

    Returns:
        Proven, with the times of events enclosed. Undecided or refuted, as for ``prove_orbit``.

    Raises:
        WrongTypeError: if an argument is of another type.
        MissingPackageError: if python-flint is not installed.
    """
    require_subject(system)
    require_instance("motion", motion, (MechanismMotion, LoopMotion), "a motion")
    flow = MechanismFlow(system) if isinstance(system, Mechanism) else flow_of(system)
    try:
        course = motion.course if isinstance(motion, MechanismMotion) else _course_of(motion, flow)
        data = {**stated_motion(course, flow), **read_of_motion(course, flow, readings)}
    except UndecidedError as error:
        return Proof("motion", Verdict.UNDECIDED, "", str(error), {})
    return proof_of("motion", data, limit)


def _course_of(motion: LoopMotion, flow: Flow) -> Course:
    begin = flow.at(motion.log.state[0, : flow.size])
    ending = Ending.REACHED_END if motion.success else Ending.DIVERGED
    return Course(motion.loop.modes, begin, begin, ending, motion.duration, motion.log)


def prove_special_point(
    system: Subject, branch: FollowedBranch, special: SpecialPoint, limit: float = LIMIT
) -> Proof:
    """Prove that a branch has a special point, and where: to nine digits, within six of what was computed.

    The equations are taken as straight lines over the number, through those at two values a millionth aside.
    Orbits on a short piece of the branch are enclosed, each alone, so that they are one curve; on it the
    number turns around (a fold), or a determinant changes its sign.

    Args:
        system: The mechanism or loop that was followed; of the number that was varied any value will do.
        branch: The branch.
        special: One of its special points.
        limit: Time after which the check gives up, undecided, s.

    Returns:
        Proven, refuted or undecided. A grazing of what has events or samples besides, a symmetry breaking of
        other than a motion that is its own mirror image after half a period, and of a sampled motion a number
        on which the clock, demands or their limits depend, are undecided.

    Raises:
        WrongTypeError: if an argument is of another type.
        MissingPackageError: if python-flint is not installed.
    """
    require_subject(system)
    require_instance("branch", branch, FollowedBranch, "a branch")
    require_instance("special", special, SpecialPoint, "a special point")
    try:
        data = _special_data(system, branch, special)
    except (TrimmerError, UndecidedError) as error:
        told = {"kind": special.kind.word, "place": branch.map.place, "value": float(special.value)}
        return Proof("special point", Verdict.UNDECIDED, "", str(error).rstrip("."), told)
    return proof_of("special point", data, limit)


def _returns(passage: DrivenPassage) -> bool:
    gap = abs(passage.end - passage.begin.state)
    return bool((gap <= CLOSED * passage.sizes.max(initial=0.0)).all())


def _course_at(branch: FollowedBranch, special: SpecialPoint, over: DrivenMap) -> tuple[Course, DrivenMap]:
    """Return the motion at a special point, and the map over which it returns."""
    value = float(special.value)
    passage = over.passage(value, special.state)
    if special.kind is SpecialKind.GRAZING:
        return passage.course.alone, over  # What it touches it does not meet.
    if not (over.mirrored or branch.finds_period or _returns(passage)):
        # An event at the start of the period itself is before it or behind it, as rounding has it.
        over = over.begun_at(LATER)
        passage = over.passage(value, over.phases(value, special.state)[0])
    return passage.course if over.mirrored else begun_amid(passage.course), over


def _clock_of(motion: dict[str, Any], flow: Flow) -> tuple[Any, ...]:
    """Return what a file says but once of a clock: its samples, what is positive at them, and the period."""
    period = flow.modes.system.layout.period
    return motion["clock"], [each["strict"] for each in motion["segments"]], motion["clock"] and period


def _special_data(system: Subject, branch: FollowedBranch, special: SpecialPoint) -> dict[str, Any]:
    kind, place, value = special.kind, branch.map.place, float(special.value)
    if kind not in COVERED:
        raise UndecidedError(f"special points of the kind {kind.word} are not covered")
    if special.note and kind is SpecialKind.FOLD:
        raise UndecidedError(f"it is {special.note}, which is not covered")
    over = branch.map
    if kind is SpecialKind.SYMMETRY_BREAKING:
        if branch.finds_period or not over.is_mirror_symmetric or over.periods % 2 == 0:
            raise UndecidedError("a symmetry breaking of what is no mirror image of itself is not covered")
        over = replace(over, mirrored=True, single=None)
    course, over = _course_at(branch, special, over)
    flow = flow_of(system.with_value(place, value))
    if flow.shifts:
        raise UndecidedError(
            "motions that return but for a shift along which no force changes are not covered"
        )
    motion = motion_data(course, flow, 0 if branch.finds_period else over.length)
    if motion["clock"] and kind is SpecialKind.GRAZING:
        raise UndecidedError("a grazing of sampled motions is not covered")
    if over.mirrored:
        motion["signs"] = [int(each) for each in flow.mirrored_states]
    beside = []
    for factor in (1.0 - ASIDE, 1.0 + ASIDE):
        changed = system.with_value(place, value * factor)
        other = flow_of(changed)
        if _clock_of(motion_data(course, other, motion["periods"]), other) != _clock_of(motion, flow):
            raise UndecidedError("a number on which samples, demands or their limits depend is not covered")
        beside.append((float(changed.value(place)), equations_data(course, other)))
    beside.sort(key=itemgetter(0))
    told_once(motion, *(equations for _, equations in beside))
    told = {"kind": kind.word, "place": place, "value": value, "motion": motion}
    return {**told, "beside": [{"value": at, "equations": equations} for at, equations in beside]}
