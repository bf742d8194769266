"""Whether a multiplier passes 1 or -1 between two values of a number: the orbits at both, and signs there.

At each value the orbit is proven as any other. The determinant of D - m, with the derivative D of the return
and m = 1 or -1, changes its sign between them. A continuous family of such motions over the values between
them so has one at which m is a multiplier.
"""

from __future__ import annotations

from typing import Any

from flint import arb, arb_mat, ctx

from trimmer.proof.following import ORBIT_PRECISION, Motion
from trimmer.proof.orbit_check import require_orbit
from trimmer.proof.outcome import Outcome, Verdict
from trimmer.proof.undecided import RefutedError, UndecidedError

WIDEST = 1e-6
"""Largest distance of both values, as a share of them: six digits."""
BESIDE = 1e-5
"""Distance of an orbit from the computed one, as a share of the sizes: a multiplier near 1 costs digits."""
MULTIPLIERS = {"period-doubling": -1, "symmetry-breaking": 1}
"""What is a multiplier at a special point, by its kind."""


def check_special_point(data: dict[str, Any]) -> Outcome:
    """Hold a special point against the orbits on both sides.

    Args:
        data: ``kind``, ``place``, ``value``, and ``sides``: two, each with ``value`` and ``orbit``.
    """
    kind, value = data["kind"], data["value"]
    if kind not in MULTIPLIERS:
        return Outcome(Verdict.UNDECIDED, "", f"special points of the kind {kind} are not covered")
    values = sorted(side["value"] for side in data["sides"])
    if not values[0] < value < values[1] or values[1] - values[0] > WIDEST * abs(value):
        return Outcome(Verdict.REFUTED, "", f"the values of both orbits are not within {WIDEST:g} around it")
    with ctx.workprec(ORBIT_PRECISION):
        try:
            signs = [_sign(side["orbit"], MULTIPLIERS[kind]) for side in data["sides"]]
        except UndecidedError as error:
            return Outcome(Verdict.UNDECIDED, "", str(error))
        except RefutedError as error:
            return Outcome(Verdict.REFUTED, "", str(error))
    if len({_sequence(side["orbit"]) for side in data["sides"]}) > 1:
        return Outcome(Verdict.UNDECIDED, "", "the orbits on both sides have other events")
    if signs[0] == signs[1]:
        return Outcome(Verdict.REFUTED, "", f"no multiplier passes {MULTIPLIERS[kind]} between {values}")
    return Outcome(Verdict.PROVEN, _theorem(data, values), "")


def _sign(data: dict[str, Any], multiplier: int) -> int:
    """Prove an orbit, and return the sign of the determinant of D - m.

    Raises:
        UndecidedError, RefutedError: if it is none, or balls do not tell.
    """
    motion = Motion(data)
    if motion.autonomous:
        raise UndecidedError("special points without a drive are not covered")
    over = require_orbit(motion, data, BESIDE)
    n, sizes = motion.n, motion.sizes
    shifted = arb_mat(
        [
            [over.change[i, k] * sizes[k] / sizes[i] - (multiplier if i == k else 0) for k in range(n)]
            for i in range(n)
        ]
    )
    determinant: arb = shifted.det()
    if determinant.contains(0):
        raise UndecidedError("the sign of a determinant is not told")
    return 1 if determinant > 0 else -1


def _sequence(data: dict[str, Any]) -> tuple[tuple[tuple[int, ...], int | None], ...]:
    """Return the statuses of all parts in each segment, and what ends it."""
    modes = [tuple(each["statuses"]) for each in data["modes"]]
    return tuple((modes[each["mode"]], each["fired"]) for each in data["segments"])


def _theorem(data: dict[str, Any], values: list[float]) -> str:
    orbit, multiplier = data["sides"][0]["orbit"], MULTIPLIERS[data["kind"]]
    return (
        f"The system of this file ({orbit['about']}) has at {data['place']} = {values[0]!r} and at "
        f"{values[1]!r} one periodic motion each with the period and the {len(orbit['segments']) - 1} events "
        f"of this file and no other, within {BESIDE:g} of its states as a share of their largest values, and "
        f"det(D - m), m = {multiplier}, D the derivative of the return, has opposite signs there: each "
        f"continuous family of such motions over the values between them has the multiplier {multiplier} at "
        f"one, a {data['kind']} within {WIDEST:g}, relative, of {data['value']!r}."
    )
