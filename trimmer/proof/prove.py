"""Prove what was computed: the check gets a statement with its data, and nothing of what computed it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from trimmer.arguments import require_instance, require_instances
from trimmer.balance.limit_cycle import HarmonicBalance, LimitCycle
from trimmer.balance.loop_first import takes_a_loop
from trimmer.balance.solve import checked_range
from trimmer.branches.followed import FollowedBranch
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.errors import OrbitNotFoundError
from trimmer.loops.loops import ClosedLoop
from trimmer.proof.modes import UncoveredError, orbit_data
from trimmer.proof.outcome import Verdict
from trimmer.proof.proof import Proof, proof_of
from trimmer.proof.terms import element_data, plant_data
from trimmer.response.flows import flow_of, require_subject
from trimmer.response.forced_orbit import exact_orbit
from trimmer.response.orbit import Orbit

if TYPE_CHECKING:
    from trimmer.motion.subject import Subject

ASIDE = 4e-7
"""Distance of the orbits on both sides of a special point from its value, as a share of it."""


@takes_a_loop
def prove_limit_cycles(
    loop: ClosedLoop,
    limit_cycles: Sequence[LimitCycle] | HarmonicBalance,
    omega_range: tuple[float, float] | None = None,
) -> Proof:
    """Prove that a list of limit cycles is that of harmonic balance: no more, no less.

    All solutions of 1 + N(A, omega) G(j omega) = 0 are enclosed in balls from the coefficients and the closed
    forms alone: where N keeps its direction by the roots of a polynomial, else by boxes of the whole plane.

    Args:
        loop: The closed loop, as for ``limit_cycles``; its numbers are taken as exact.
        limit_cycles: The list, or the result of ``harmonic_balance``.
        omega_range: Lowest and highest angular frequency, rad/s, within which the list is complete; all if
            not given.

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
    return proof_of("limit cycles", data)


def prove_orbit(system: Subject, orbit: Orbit) -> Proof:
    """Prove that a system has a periodic motion where one was computed, with these events and no other.

    What is taken for granted are the equations of each mode, as the assembler of the system gives them: flow,
    event functions, and what an event makes of the state; their doubles are taken as exact, and so is the
    period of a drive. What the law of an event makes zero is taken as zero.

    Args:
        system: The mechanism or loop; its modes are those of the statement.
        orbit: The orbit, as ``forced_orbit``, ``periodic_orbits`` or ``respond`` gives it.

    Returns:
        Proven, with the largest modulus of its multipliers enclosed. Refuted, if the motion is elsewhere, has
        another sequence of events or another stability. Undecided, with the reason, where balls do not tell,
        as at a grazing, or where it is not covered: rigid walls, samples, what returns but for a shift.

    Raises:
        WrongTypeError: if an argument is of another type.
        MissingPackageError: if python-flint is not installed.
    """
    require_subject(system)
    require_instance("orbit", orbit, Orbit, "an orbit")
    flow = orbit.flow if orbit.subject is system else flow_of(system)
    try:
        data = orbit_data(orbit, flow)
    except UncoveredError as error:
        return Proof("orbit", Verdict.UNDECIDED, "", str(error), {})
    return proof_of("orbit", data)


def prove_special_point(system: Subject, branch: FollowedBranch, special: SpecialPoint) -> Proof:
    """Prove that a multiplier passes -1 or 1 where a branch has a special point, to six digits of its value.

    Two orbits are computed, a little before the value and a little behind it, and proven as ``prove_orbit``
    does. Between them a determinant changes its sign: each continuous family of such motions between them has
    a period doubling, or a symmetry breaking, there. That there is such a family is not proven.

    Args:
        system: The mechanism or loop that was followed; of the number that was varied any value will do.
        branch: The branch.
        special: One of its special points.

    Returns:
        Proven, refuted or undecided. Folds, grazings, tori, and what moves without a drive are undecided.

    Raises:
        WrongTypeError: if an argument is of another type.
        MissingPackageError: if python-flint is not installed.
    """
    require_subject(system)
    require_instance("branch", branch, FollowedBranch, "a branch")
    require_instance("special", special, SpecialPoint, "a special point")
    kind, place, value = special.kind, branch.map.place, float(special.value)
    data: dict[str, Any] = {"kind": kind.word, "place": place, "value": value}
    if kind not in (SpecialKind.PERIOD_DOUBLING, SpecialKind.SYMMETRY_BREAKING) or branch.finds_period:
        drive = "without" if branch.finds_period else "with"
        reason = f"{kind.word} of a motion {drive} a drive is not covered"
        return Proof("special point", Verdict.UNDECIDED, "", reason, data)
    data["sides"] = []
    for factor in (1.0 - ASIDE, 1.0 + ASIDE):
        changed = system.with_value(place, value * factor)
        try:
            orbit = exact_orbit(changed, periods=branch.periods, guess=special.state)
            data["sides"].append({"value": changed.value(place), "orbit": orbit_data(orbit, orbit.flow)})
        except (OrbitNotFoundError, UncoveredError) as error:
            return Proof("special point", Verdict.UNDECIDED, "", str(error).rstrip("."), data)
    return proof_of("special point", data)
