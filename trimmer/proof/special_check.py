"""Whether a branch has a special point: its orbits on a short piece in balls, and a sign that changes on it.

The equations of a family over a number v are straight lines in v: those at one value, with slopes from two
values beside it. Planes cut the branch, and Krawczyk's operator says that each of a stack of them meets it in
exactly one orbit (``returning``); so it is one smooth curve there. Where dv, along the curve, has opposite
signs at both ends, v turns around: a fold. Where det(D - m) has, with D the derivative of the return, m is a
multiplier somewhere between. Where the modulus of a pair of eigenvalues of D passes 1, it is a torus. Where
motions have no events, and the smallest value of an event function passes 0, they graze.
"""

from collections.abc import Callable

from flint import acb_mat, arb, arb_mat, ctx

from trimmer.proof.balls import about
from trimmer.proof.following import PRECISION, RADIUS, BallMotion, Followed, diagonal
from trimmer.proof.form import require_form, require_shortest
from trimmer.proof.motion_check import at_instants, require_near, taken_as_zero, unchecked
from trimmer.proof.outcome import RefutedError, UndecidedError
from trimmer.proof.readings import readings, smallest
from trimmer.proof.returning import (
    Plane,
    Returned,
    derivative_of,
    first_guess,
    in_sizes,
    narrowed,
    nearer,
    scales,
    solve,
)
from trimmer.proof.statement import StatedSpecialPoint

HALF = RADIUS - 50  # Power of two of half the length of the piece, as a share of the sizes
TOUCH, WIDE = -32, -20  # For a grazing: half the length, in the number, and the balls of all motions on it
MOST_SECANTS = 25
Test = Callable[[BallMotion, Followed, Plane], arb]
"""What changes its sign, of a motion and its derivative on a plane."""
WITHIN = 1e-6  # Distance from the value as it was computed, as a share of it: six digits
BESIDE = 1e-5
"""Distance of its orbit from the computed one, as a share of the sizes: a multiplier near 1 costs digits."""
TOLD = 1e-9  # Precision, relative, with which the value is told


def check_special_point(data: StatedSpecialPoint) -> str:
    """Hold a special point against the branch around it; return the theorem."""
    kind = data.kind
    if kind not in (*TESTS, "grazing"):
        raise UndecidedError(f"special points of the kind {kind} are not covered")
    if (kind == "symmetry-breaking") != bool(data.motion.signs):
        raise UndecidedError(f"a {kind} of other than half a motion is not covered")
    with ctx.workprec(PRECISION):
        return (_grazing if kind == "grazing" else _checked)(BallMotion(data.motion, data), data)


def _about_zero(motion: BallMotion, plane: Plane, test: Test) -> tuple[list[arb], arb]:
    """Find about where a test is zero, by secants; return the unknowns and the height."""
    guess, seen, height = first_guess(motion), list[tuple[arb, arb]](), arb(0)
    over = motion.follow(guess, True)
    for _ in range(MOST_SECANTS):
        here = plane.at(height)
        guess, _ = nearer(motion, here, guess, over)
        over = motion.follow(guess, True)
        seen.append((height, arb(test(motion, over, here).mid())))
        following = height + arb(2) ** -30 if len(seen) == 1 else _secant(*seen[-2:])
        if following is None or abs(following - height) < arb(2) ** (HALF - 20):
            return guess, height
        if not abs(following) < 0.01:
            break
        height = following
    raise UndecidedError("no place where a sign changes was found near the point")


def _sign(motion: BallMotion, plane: Plane, test: Test, piece: Returned) -> int:
    """Return the sign of a test on a plane, on the piece."""
    value = test(motion, narrowed(motion, plane, piece).over, plane)
    if value.contains(0):
        raise UndecidedError("the sign of a determinant is not told")
    return 1 if value > 0 else -1


def _secant(before: tuple[arb, arb], last: tuple[arb, arb]) -> arb | None:
    change = last[1] - before[1]
    return None if change.contains(0) else arb((last[0] - last[1] * (last[0] - before[0]) / change).mid())


def _checked(motion: BallMotion, data: StatedSpecialPoint) -> str:
    require_form(motion)
    plane, test, half = _plane(motion, data.kind == "fold"), TESTS[data.kind], arb(2) ** HALF
    guess, height = _about_zero(motion, plane, test)
    piece = solve(motion, plane.at(height + about(half)), guess)
    require_near(motion, piece.unknown, BESIDE)
    if data.kind == "torus":
        _circling(motion, piece.over, plane)
    value = arb(data.value) + piece.unknown[-1] * motion.unit
    if not abs(value / arb(data.value) - 1) < WITHIN:
        raise RefutedError(f"the {data.kind} nearest to it is at {float(value.mid())!r}")
    whole = motion.at(piece.unknown[-1])
    readings(whole, piece.over, ())
    if not data.motion.signs:
        require_shortest(whole, piece.over)
    first, last = (_sign(motion, plane.at(each), test, piece) for each in (height - half, height + half))
    if first == last:
        raise UndecidedError("nothing changes its sign")
    told = f"{float(value.mid()):.10g}"
    if not abs(value / arb(float(told)) - 1) < TOLD:
        raise UndecidedError("the value is enclosed too widely")
    return _theorem(motion, data, told)


def _grazing(motion: BallMotion, data: StatedSpecialPoint) -> str:
    """Follow motions without events up to where one of them touches, and beyond as if nothing were there."""
    require_form(motion)
    functions = tuple(range(motion.segments[0].functions.nrows()))
    if len(motion.segments) > 1 or not functions:
        raise UndecidedError("a grazing of motions that have events besides is not covered")
    plane, half = _plane(motion, False), arb(2) ** TOUCH
    whole = solve(motion, plane.at(about(half)), radius=WIDE)
    before, near, after = (narrowed(motion, plane.at(height), whole) for height in (-half, arb(0), half))
    require_near(motion, near.unknown, BESIDE)
    heights = [abs(smallest(motion, near.over, k, functions)) for k in functions]
    touching = [k for k, height in enumerate(heights) if height < BESIDE]
    if len(touching) != 1:
        raise UndecidedError("it is not one event function alone that comes to zero")
    around = motion.at(whole.unknown[-1])
    readings(around, whole.over, (), free=tuple(touching))
    require_shortest(around, whole.over)
    ends = before, after
    first, last = (smallest(motion.at(e.unknown[-1]), e.over, touching[0], functions) for e in ends)
    if not ((first < 0 and last > 0) or (last < 0 and first > 0)):
        raise UndecidedError("the smallest value of an event function does not change its sign")
    return _theorem(motion, data, f"{data.value:.10g}", touching[0])


def _plane(motion: BallMotion, is_fold: bool) -> Plane:
    """Return the plane through the computed orbit: of one value, or at a fold across the branch."""
    place, count = first_guess(motion), motion.unknowns
    if not is_fold:
        return Plane(place, [arb(int(k == count - 1)) for k in range(count)], arb(0))
    sizes, over = scales(motion), motion.follow(first_guess(motion), True)
    some = Plane(place, [arb(1) / (k + 1) / size for k, size in enumerate(sizes)], arb(0))
    along = [each[0] / size for each, size in zip(_along(motion, over, some).tolist(), sizes, strict=True)]
    square = sum((each * each for each in along), arb(0))
    weights = [arb((each / square.sqrt() / size).mid()) for each, size in zip(along, sizes, strict=True)]
    return Plane(place, weights, arb(0))


def _along(motion: BallMotion, over: Followed, plane: Plane) -> arb_mat:
    """Return the derivative of the unknowns by the height of the plane."""
    derivative = derivative_of(motion, over, plane)
    size = derivative.nrows()
    try:
        return derivative.solve(arb_mat([[arb(int(i == size - 1))] for i in range(size)]))
    except ZeroDivisionError:
        raise UndecidedError("the branch has no tangent, as near as balls tell") from None


def _turning(motion: BallMotion, over: Followed, plane: Plane) -> arb:
    return _along(motion, over, plane)[motion.unknowns - 1, 0]


def _crossing(motion: BallMotion, over: Followed, plane: Plane) -> arb:
    """Return det(D + 1): of half of a motion that is its mirror image, D squared is that of the whole."""
    return (in_sizes(motion, over) + diagonal([1] * motion.n)).det()


def _circling(motion: BallMotion, over: Followed, plane: Plane) -> arb:
    """Return the square of the modulus, less 1, of the only multiplier above the axis near the circle."""
    found = acb_mat(in_sizes(motion, over)).eig(multiple=True)
    near = [each for each in found if not each.imag <= 0 and not (abs(each) < 0.9 or abs(each) > 1.1)]
    if len(near) != 1 or not near[0].imag > 0:
        raise UndecidedError("no pair of multipliers is alone near the unit circle")
    return arb(abs(near[0]) ** 2 - 1)


TESTS: dict[str, Test] = {
    "fold": _turning,
    "period-doubling": _crossing,
    "symmetry-breaking": _crossing,
    "torus": _circling,
}


def _theorem(motion: BallMotion, data: StatedSpecialPoint, told: str, touching: int | None = None) -> str:
    kind, (first, second) = data.kind, (each.value for each in data.beside)
    motions, modes = "periodic motions", "modes"
    if kind == "symmetry-breaking":
        motions = "motions whose end is the mirror image of their start"
        modes = "modes, and their mirror images by the signs of this file,"
    aside = "" if touching is None else f" (event function {touching} aside)"
    happens = {
        "grazing": f"the smallest value of event function {touching} over the motion has opposite signs at "
        "its ends, so it comes to zero",
        "torus": "one pair of multipliers, not real and alone near the unit circle, has moduli below and "
        "above 1 at its ends, so it passes the circle",
        "fold": "the rate of v has opposite signs at its ends, so it turns around",
        "period-doubling": "det(D + 1), D the derivative of the return, has opposite signs at its ends, so "
        "-1 is a multiplier on it",
        "symmetry-breaking": "det(D + 1), D the derivative of that return, has opposite signs at its ends, "
        "so 1 is a multiplier on it of a motion twice as long",
    }[kind]
    return (
        f"The systems over a number v ({data.place!r}, as this file says unchecked) that are linear between "
        f"events, with {modes} on the straight line through those of this file at v = {first!r} and "
        f"{second!r} {unchecked(data.motion.about)}, and so with what it says of the states after each "
        f"event, all numbers taken as exact, have one smooth curve of {motions} with the "
        f"{len(motion.segments) - 1} events of this file{at_instants(data.motion)} in its order and no "
        f"other{aside}, within {BESIDE:g} of its state as a share of the sizes of the states."
        f"{taken_as_zero(data.motion)} On this curve, "
        f"{happens}: a {kind} within {TOLD:g}, relative, of v = {told}."
    )
