"""Whether a list of limit cycles is that of harmonic balance: no more, no less, each at its place."""

from itertools import combinations

from flint import acb, arb, ctx, fmpq_poly

from trimmer.proof.balls import PRECISION, along_axis, exact, fraction_of, in_balls
from trimmer.proof.described import Parts
from trimmer.proof.outcome import RefutedError, UndecidedError
from trimmer.proof.plane import Plane
from trimmer.proof.proportional import Solution, keeps_direction, solutions
from trimmer.proof.statement import Coefficients, LimitCycles, Matrices, Place

NEAR = 1e-9  # Relative distance between a solution and its place in the list up to which it is the one listed
ROUNDED = 1e-6  # Relative distance up to which the list may only be less precise than it should be


def check_limit_cycles(data: LimitCycles) -> str:
    """Hold a list against all solutions of 1 + N(A, omega) G(j omega) = 0; return the theorem."""
    with ctx.workprec(PRECISION):
        _compare(all_solutions(data), data)
    return _theorem(data.limit_cycles, data.omega_range)


def all_solutions(data: LimitCycles) -> list[Solution]:
    """Enclose all solutions, of rising omega."""
    num, given = fraction_of(data.plant)
    parts = Parts.of(data.element)
    if num.is_zero():
        raise UndecidedError("G is zero")
    den = given + fmpq_poly([parts.gain, parts.damping]) * num
    if den.degree() < max(given.degree(), 1):
        raise UndecidedError("the linear part of the element cancels the highest derivative")
    omegas = data.omega_range
    if keeps_direction(parts):
        found = list(solutions(num, den, given, parts))
    else:
        found = list(Plane(num, den, parts).solutions(omegas))
    inside = [each for each in found if omegas is None or _is_within(each[1], omegas)]
    inside.sort(key=lambda each: (float(each[1].mid()), float(each[0].mid())))
    return inside


def _is_within(omega: arb, omegas: tuple[float, float]) -> bool:
    lowest, highest = (arb(exact(each)) for each in omegas)
    if omega < lowest or omega > highest:
        return False
    if omega > lowest and omega < highest:
        return True
    raise UndecidedError("a solution stands at an end of the range of omega")


def _compare(found: list[Solution], data: LimitCycles) -> None:
    left = list(found)
    for place, cycle in enumerate(data.limit_cycles, 1):
        distances = [(_distance(each, cycle), each) for each in left]
        if not distances:
            raise RefutedError(f"there is no solution for number {place} of the list")
        distance, nearest = min(distances, key=lambda each: float(each[0].mid()))
        if not distance < NEAR:
            at = f"the solution nearest to number {place} of the list is at {_told(nearest)}"
            if distance < ROUNDED or not distance > NEAR:
                raise UndecidedError(f"{at}, farther from it than {NEAR:g}, relative")
            raise RefutedError(at)
        left = [each for each in left if each is not nearest]
    for each in left:
        lacking = f"the list lacks the solution at {_told(each)}"
        if not _is_told(each[1], data.plant):
            raise UndecidedError(f"{lacking}, where rounding of G decides")
        raise RefutedError(lacking)
    for first, second in combinations(found, 2):
        if all(each.overlaps(other) for each, other in zip(first, second, strict=True)):
            raise UndecidedError(f"two solutions near {_told(first)} are too near to part")


def _distance(solution: Solution, cycle: Place) -> arb:
    """Bound the larger distance of amplitude and omega, as shares of those of the solution."""
    amplitude, omega = (arb(exact(each)) for each in (cycle.amplitude, cycle.omega))
    return abs(amplitude / solution[0] - 1).max(abs(omega / solution[1] - 1))


def _is_told(omega: arb, plant: Coefficients | Matrices) -> bool:
    """Return whether the denominator, each coefficient off by its last digit, still differs from 0."""
    ordered = fraction_of(plant)[1].coeffs()
    sizes = sum((abs(arb(each)) * omega**power for power, each in enumerate(ordered)), arb(0))
    value = in_balls(along_axis(fmpq_poly(ordered)))(acb(omega))
    return bool(abs(value) > sizes * arb(2) ** -50)


def _told(solution: Solution) -> str:
    return f"A = {float(solution[0].mid()):.12g}, omega = {float(solution[1].mid()):.12g} rad/s"


def _theorem(listed: tuple[Place, ...], omegas: tuple[float, float] | None) -> str:
    count = {0: "no solution", 1: "exactly one solution"}.get(len(listed), f"exactly {len(listed)} solutions")
    where = "omega > 0" if omegas is None else f"omega from {omegas[0]!r} to {omegas[1]!r} rad/s"
    places = "; ".join(f"A = {each.amplitude!r}, omega = {each.omega!r} rad/s" for each in listed)
    beside = f", each within {NEAR:g}, relative, of its place: {places}" if listed else ""
    return (
        "With the coefficients and the element of this file, taken as exact, 1 + N(A, omega) G(j omega) = 0 "
        f"has, with N not 0, {count} with an amplitude A > 0 at which the element has a steady output and "
        f"{where}{beside}."
    )
