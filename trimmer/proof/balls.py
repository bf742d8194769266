"""Exact numbers and balls: every real number below is exact or an interval that encloses it."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from flint import acb, acb_poly, arb, arb_mat, ctx, fmpq, fmpq_mat, fmpq_poly

from trimmer.proof.outcome import UndecidedError, require_time
from trimmer.proof.statement import Coefficients, Matrices

PRECISION = 192  # Bits of the midpoints of balls; 53 would be those of doubles
MOST_PIECES = 4000
UNEVEN = 0.4871  # Where an interval is divided: a root stands on no such place by chance
I = acb(0, 1)  # noqa: E741
with ctx.workprec(PRECISION):
    PI = arb.pi()


def exact(value: float) -> fmpq:
    """Return a double as the quotient of whole numbers that it is."""
    return fmpq(*float(value).as_integer_ratio())


def hull(lower: float | arb, upper: float | arb) -> arb:
    """Return a ball around everything between two ends."""
    return arb(lower).union(arb(upper))


def about(radius: float | arb) -> arb:
    """Return the ball from -radius to radius."""
    return hull(-arb(radius), arb(radius))


def krawczyk(around: Sequence[arb], lacking: Sequence[arb], derivative: arb_mat) -> list[arb]:
    """Return the image of a ball by Krawczyk's operator: all zeros of a function in the ball are in it.

    Where it lies inside the ball there is exactly one.

    Args:
        around: The ball, one for each unknown.
        lacking: What the function lacks of zero in the middle of the ball.
        derivative: Of the function, over the ball.

    Raises:
        ZeroDivisionError: if the middle of the derivative has no inverse.
    """
    middle = [arb(each.mid()) for each in around]
    inverse = derivative.mid().inv().mid()
    one = arb_mat([[arb(int(i == k)) for k in range(len(middle))] for i in range(len(middle))])
    reaches = arb_mat([[each - m] for each, m in zip(around, middle, strict=True)])
    image = inverse * arb_mat([[each] for each in lacking]) + (one - inverse * derivative) * reaches
    return [m + each for m, each in zip(middle, image.entries(), strict=True)]


def between(lower: arb, upper: arb, digits: int = 12) -> str:
    """Say bounds to some digits, 12 or 15, rounded outwards by more than these leave out."""
    share = arb(2) ** (3 - 10 * digits // 3)
    outwards = (lower - share * abs(lower)).lower(), (upper + share * abs(upper)).upper()
    words = [f"{float(each):.{digits}g}" for each in outwards]
    if not (arb(words[0]) <= lower and arb(words[1]) >= upper):
        raise UndecidedError("a number is too large or too small for the digits in which it is told")
    return f"between {words[0]} and {words[1]}"


def along_axis(polynomial: fmpq_poly) -> tuple[fmpq_poly, fmpq_poly]:
    """Return real and imaginary part of a polynomial in s at s = j omega, as polynomials in omega."""
    parts: tuple[list[fmpq], list[fmpq]] = ([], [])
    for power, each in enumerate(polynomial.coeffs()):
        sign = -1 if power % 4 in (2, 3) else 1
        parts[power % 2].append(sign * each)
        parts[1 - power % 2].append(fmpq(0))
    return fmpq_poly(parts[0]), fmpq_poly(parts[1])


def in_balls(parts: tuple[fmpq_poly, fmpq_poly], reversed_to: int | None = None) -> acb_poly:
    """Return a polynomial in omega with complex balls, or omega**n times it as a polynomial in 1/omega."""
    size = max(len(each.coeffs()) for each in parts)
    filled = [each.coeffs() + [fmpq(0)] * (size - len(each.coeffs())) for each in parts]
    values = [acb(arb(above), arb(beside)) for above, beside in zip(*filled, strict=True)]
    if reversed_to is not None:
        values = [acb(0)] * (reversed_to + 1 - len(values)) + values[::-1]
    return acb_poly(values)


def fraction_of(plant: Coefficients | Matrices) -> tuple[fmpq_poly, fmpq_poly]:
    """Return numerator and denominator of a plant without common factors, exact."""
    if isinstance(plant, Coefficients):
        sides = [
            fmpq_poly([exact(each) for each in side[::-1]]) for side in (plant.numerator, plant.denominator)
        ]
    else:
        sides = _from_states(plant)
    if sides[1].is_zero():
        raise ValueError("the denominator of the plant is zero")
    common = sides[0].gcd(sides[1])
    return sides[0] // common, sides[1] // common


def _from_states(plant: Matrices) -> list[fmpq_poly]:
    """Return det(sI - A + BC) - (1 - D) det(sI - A), and det(sI - A)."""
    size = range(len(plant.A))
    entries = [[exact(each) for each in row] for row in plant.A]
    column, row = [exact(each[0]) for each in plant.B], [exact(each) for each in plant.C[0]]
    fed_back = [[entries[i][k] - column[i] * row[k] for k in size] for i in size]
    below, above = fmpq_mat(entries).charpoly(), fmpq_mat(fed_back).charpoly()
    return [above - below + exact(plant.D[0][0]) * below, below]


def positive_roots(polynomial: fmpq_poly) -> list[tuple[arb, int]] | None:
    """Isolate the positive roots of a polynomial that is not zero, each with its multiplicity.

    Returns:
        Of rising size; None if balls do not tell whether a root is positive.
    """
    found: list[tuple[arb, int]] = []
    for factor, multiplicity in polynomial.numer().factor_squarefree()[1]:
        isolated: Any = factor.complex_roots() if factor.degree() > 0 else []
        for root, _ in isolated:
            if not root.imag.is_zero() or root.real.is_zero():
                continue
            if not (root.real > 0 or root.real < 0):
                return None
            if root.real > 0:
                found.append((root.real, int(multiplicity)))
    return sorted(found, key=lambda each: float(each[0].mid()))


def roots_between(function: Callable[[arb], tuple[arb, arb]], lower: arb, upper: arb) -> Iterator[arb]:
    """Enclose all roots between two ends of a function that gives its value and its slope."""
    waiting, pieces = [(lower, upper)], 0
    while waiting:
        require_time()
        pieces += 1
        if pieces > MOST_PIECES:
            raise UndecidedError("a function nearly touches zero")
        first, last = waiting.pop()
        value, slope = function(hull(first, last))
        if not value.contains(0):
            continue
        if not slope.contains(0):
            ends = [function(each)[0] for each in (first, last)]
            if (ends[0] < 0 and ends[1] > 0) or (ends[0] > 0 and ends[1] < 0):
                yield _narrowed(function, hull(first, last))
                continue
            if (ends[0] < 0 and ends[1] < 0) or (ends[0] > 0 and ends[1] > 0):
                continue
        middle = (first + UNEVEN * (last - first)).mid()
        waiting += [(first, middle), (middle, last)]


def _narrowed(function: Callable[[arb], tuple[arb, arb]], around: arb) -> arb:
    """Narrow the only root in an interval by Newton's method."""
    for _ in range(60):
        middle = arb(around.mid())
        following = around.intersection(middle - function(middle)[0] / function(around)[1])
        if not following.rad() < 0.9 * around.rad():
            break
        around = following
    return around
