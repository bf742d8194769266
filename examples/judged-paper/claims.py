"""What the paper states, held against what was derived and computed: a function for each statement."""

import math
from pathlib import Path

import sympy
from matplotlib.figure import Figure
from scipy.integrate import quad

from report.judging.figure import figure
from report.judging.parts import assertion, close, digits, expression, made_here, repeated, same, so
from report.judging.record import Record, claim, text

from .evidence import BETA, NATURAL, SHARE, Evidence, U, V, approximate

m, k, x, v, a, F, P, w, c, x0 = sympy.symbols("m k x v a F P omega c x_0", positive=True)
HARMONIC = 4 * SHARE / sympy.pi
TABLE = Path(__file__).with_name("table-1.csv").read_text("utf-8").splitlines()[1:]
SWAPPED = "the names of the two curves of figure 2 are exchanged"


@claim("eq-1")
def motion(known: Evidence) -> Record:
    lagrange = (m * v**2 / 2).diff(v, v) * a + (k * x**2 / 2).diff(x) + F - P
    second = same("the balance of power", (m * v * a + k * x * v + F * v - P * v) / v, lagrange)
    yield expression("left less right side, $\\dot x > 0$", m * a + k * x + F - P, lagrange, second=second)
    yield text("Lagrange's equation of a mass on a spring.")


@claim("eq-2")
def natural_frequency(known: Evidence) -> Record:
    yield expression("", sympy.sqrt(k / m), sympy.solve(k - m * w**2, w)[0], left=r"\omega_n")
    yield text("A cosine solves equation (1) without friction and force at this frequency alone.")


@claim("txt-natural-frequency")
def in_hertz(known: Evidence) -> Record:
    hertz, slip = NATURAL / (2 * math.pi), made_here("rad/s are called Hz", NATURAL)
    second = close("the square of the period", (2 * math.pi) ** 2 * 0.5 / 2000, hertz**-2)
    yield digits("", "63.25", hertz, "Hz", second=second, slip=slip)
    yield text(f"It is {NATURAL:.2f} rad/s, which are {hertz:.2f} Hz.")


@claim("eq-3")
def forced_part(known: Evidence) -> Record:
    yield expression("", V, sympy.solve(x0 - BETA**2 * x0 - 1, x0)[0], left="V")
    yield text(r"A cosine is put into equation (1), in units of $P/k$ and $1/\omega_n$.")


@claim("eq-4")
def sine_part(known: Evidence) -> Record:
    second = same("the tangent of half the angle", known.lag, sympy.tan(sympy.pi / (2 * BETA)) / BETA)
    yield expression("", U, known.lag, left="U", second=second)
    yield text("The four conditions at the turning points give it.")


@claim("eq-5")
def exact_amplitude(known: Evidence) -> Record:
    printed, slip = V**2 + SHARE**2 * U**2, "a minus became a plus"
    second = close("the library's exact orbit at 1.5", known.exact(1.5), known.orbit(1.5))
    more = {"printed_form": r"V^2 + \rho^2 U^2", "derived_form": r"V^2 - \rho^2 U^2", "second": second}
    yield expression("$(k x_0/P)^2$", printed, known.squared, slip=made_here(slip, printed), **more)
    yield text("Friction ($\\rho = F/P$) lowers the amplitude.\n\nTable 1 was computed with the minus.")


@claim("tab-1")
def table(known: Evidence) -> Record:
    for row, forced, sine, amplitude in (line.split(",") for line in TABLE):
        beta = float(row)
        second = close("the library's exact orbit", known.orbit(beta), known.exact(beta))
        yield digits(f"$V$ at {row}", forced, float(V.subs(BETA, beta)))
        yield digits(f"$U$ at {row}", sine, float(known.lag.subs(BETA, beta)))
        yield digits(f"amplitude at {row}", amplitude, known.exact(beta), second=second)
    yield text("At 1.2 two digits are exchanged; all else in the table is right.")


@claim("fig-1")
def over_frequency(known: Evidence) -> Record:
    falls = sympy.simplify(known.squared.diff(SHARE) + 2 * SHARE * U**2) == 0
    more = {"method": "differentiated", "second": so("the library's orbit at 1.5", known.orbit(1.5) < 0.8)}
    yield assertion(
        "", "Friction lowers all curves.", falls, r"$(k x_0/P)^2$ has the slope $-2 \rho U^2$.", **more
    )
    yield text("This follows from the right equation (5); with its printed sign friction would raise them.")


@claim("eq-6")
def equivalent_damper(known: Evidence) -> Record:
    second = close("the first harmonic by quadrature", quad(math.sin, 0, math.pi)[0] / math.pi, 2 / math.pi)
    damper = sympy.solve(sympy.pi * c * w * x0**2 - 4 * F * x0, c)[0]
    yield expression("", 4 * F / (sympy.pi * w * x0), damper, left="c", second=second)
    yield text("The damper takes the work of the friction.")


@claim("eq-7")
def approximation(known: Evidence) -> Record:
    (squared,) = sympy.solve(x * (1 - BETA**2) ** 2 + HARMONIC**2 - 1, x)
    yield expression("$(k x_0/P)^2$", V**2 * (1 - HARMONIC**2), squared)
    yield text("The damper's force and that of mass and spring are at right angles, and give the drive.")


@claim("txt-resonance")
def resonance(known: Evidence) -> Record:
    limit = float(-sympy.limit(V / U, BETA, 1, "-"))
    yield digits("", "0.785", limit, second=close(r"the works $\pi P x_0$ and $4 F x_0$", math.pi / 4, limit))
    yield text("By the right equation (5) the amplitude grows without bound at resonance for less friction.")


@claim("fig-2")
def over_friction(known: Evidence) -> Record:
    exact, other = known.exact(1.5), approximate(1.5)
    second = close("the library's exact orbit", known.orbit(1.5), exact)
    yield digits("curve called exact", "0.74", exact, second=second, slip=made_here(SWAPPED, other))
    yield digits("curve called approximation", "0.72", other, slip=made_here(SWAPPED, exact))
    yield text("The upper curve is the approximation, and the lower one the exact amplitude.")


@figure(
    "fig-2", title="At 1.5", caption="Both from $F = 0$ on.", alternative_text="The approximation is above."
)
def drawn_again(known: Evidence) -> Figure:
    drawn, shares = Figure((6.0, 3.0), layout="constrained"), [each / 50 for each in range(31)]
    panel = drawn.subplots()
    panel.plot(shares, [approximate(1.5, each) for each in shares], label="approximation")
    panel.plot(shares, [known.exact(1.5, each) for each in shares], label="exact")
    panel.set(xlabel="friction F/P", ylabel="amplitude per P/k")
    panel.legend()
    return drawn


@claim("txt-safe-side")
def safe_side(known: Evidence) -> Record:
    exact, other = known.exact(1.5), approximate(1.5)
    more = {"second": so("the library's exact orbit", known.orbit(1.5) < other), "method": "computed"}
    told, slip = f"{other:.4f} is approximated, and {exact:.4f} exact.", repeated(SWAPPED, True)
    yield assertion("", "The approximation is too small.", other < exact, told, slip=slip, **more)
    yield text("It is too large at 1.5: on the safe side.\n\nWhat the paper advises turns round.")


@claim("eq-8")
def work(known: Evidence) -> Record:
    heat = known.orbits[1.5].measures.frictions["guide"].work
    second = close("the work in the library's orbit", heat, 4 * 1.2 * 0.002 * known.exact(1.5))
    yield expression("", 4 * F * x0, 2 * sympy.integrate(F, (x, -x0, x0)), left="W", second=second)
    yield digits("at 1.5", "6.9", 4 * 1.2 * 2 * known.exact(1.5), "mJ")
    yield text("Friction acts against both ways of $2 x_0$.")
