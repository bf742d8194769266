"""What the paper states, held against what was derived and computed: a function for each statement."""

import math

from matplotlib.figure import Figure
from sympy import integrate, limit, pi, simplify, sin, solve, sqrt, symbols, tan

from report.judging.figure import figure
from report.judging.parts import assertion, close, digits, expression, made_here, repeated, same, so
from report.judging.record import Record, claim, text

from .evidence import APPROXIMATION, BETA, HERTZ, SHARE, TABLE, Evidence, U, V, amplitude

m, k, x, v, a, F, P, w, c, x0 = symbols("m k x v a F P omega c x_0", positive=True)
SWAPPED = "the names of the two curves of figure 2 are exchanged"


@claim("eq-1")
def motion(known: Evidence) -> Record:
    lagrange = (m * v**2 / 2).diff(v, v) * a + (k * x**2 / 2).diff(x) + F - P
    second = same("the balance of power", (m * v * a + k * x * v + F * v - P * v) / v, lagrange)
    yield expression("left less right side, $\\dot x > 0$", m * a + k * x + F - P, lagrange, second=second)
    yield text("Lagrange's equation of a mass on a spring.")


@claim("eq-2")
def natural_frequency(known: Evidence) -> Record:
    yield expression("", sqrt(k / m), solve(k - m * w**2, w)[0], left=r"\omega_n")
    yield text("A cosine solves equation (1) without friction and force at this frequency alone.")


@claim("txt-natural-frequency")
def in_hertz(known: Evidence) -> Record:
    second = close("the square of the period", (2 * math.pi) ** 2 * 0.5 / 2000, HERTZ**-2)
    slip = made_here("rad/s are called Hz", 2 * math.pi * HERTZ)
    yield digits("", "63.25", HERTZ, "Hz", second=second, slip=slip)
    yield text(f"It is {slip.derived:.2f} rad/s, which are {HERTZ:.2f} Hz.")


@claim("eq-3")
def forced_part(known: Evidence) -> Record:
    yield expression("", V, solve(x0 - BETA**2 * x0 - 1, x0)[0], left="V")
    yield text(r"A cosine is put into equation (1), in units of $P/k$ and $1/\omega_n$.")


@claim("eq-4")
def sine_part(known: Evidence) -> Record:
    second = same("the tangent of half the angle", known.lag, tan(pi / (2 * BETA)) / BETA)
    yield expression("", U, known.lag, left="U", second=second)
    yield text("The four conditions at the turning points give it.")


@claim("eq-5")
def exact_amplitude(known: Evidence) -> Record:
    printed, slip = V**2 + SHARE**2 * U**2, "a minus became a plus"
    second = close("the library's exact orbit at 1.5", amplitude(known.squared, 1.5), known.orbits[1.5])
    more = {"printed_form": r"V^2 + \rho^2 U^2", "derived_form": r"V^2 - \rho^2 U^2", "second": second}
    yield expression("$(k x_0/P)^2$", printed, known.squared, slip=made_here(slip, printed), **more)
    yield text("Friction ($\\rho = F/P$) lowers the amplitude.\n\nTable 1 was computed with the minus.")


@claim("tab-1")
def table(known: Evidence) -> Record:
    for row, forced, sine, both in TABLE:
        beta, exact = float(row), amplitude(known.squared, float(row))
        second = close("the library's exact orbit", known.orbits[beta], exact)
        yield digits(f"$V$ at {row}", forced, float(V.subs(BETA, beta)))
        yield digits(f"$U$ at {row}", sine, float(known.lag.subs(BETA, beta)))
        yield digits(f"amplitude at {row}", both, exact, second=second)
    yield text("At 1.2 two digits are exchanged; all else in the table is right.")


@claim("fig-1")
def over_frequency(known: Evidence) -> Record:
    falls = simplify(known.squared.diff(SHARE) + 2 * SHARE * U**2) == 0
    more = {"method": "differentiated", "second": so("the library's orbit at 1.5", known.orbits[1.5] < 0.8)}
    yield assertion("", "Friction lowers all curves.", falls, r"The square has slope $-2 \rho U^2$.", **more)
    yield text("This follows from the right equation (5); with its printed sign friction would raise them.")


@claim("eq-6")
def equivalent_damper(known: Evidence) -> Record:
    damper = solve(pi * c * w * x0**2 - 4 * F * x0, c)[0]
    second = same("the first harmonic", damper * w * x0, 2 * F * integrate(sin(x), (x, 0, pi)) / pi)
    yield expression("", 4 * F / (pi * w * x0), damper, left="c", second=second)
    yield text("The damper takes the work of the friction.")


@claim("eq-7")
def approximation(known: Evidence) -> Record:
    squared = solve(x * (1 - BETA**2) ** 2 + (4 * SHARE / pi) ** 2 - 1, x)[0]
    yield expression("$(k x_0/P)^2$", APPROXIMATION, squared)
    yield text("The damper's force and that of mass and spring are at right angles, and give the drive.")


@claim("txt-resonance")
def resonance(known: Evidence) -> Record:
    least = float(-limit(V / U, BETA, 1, "-"))
    yield digits("", "0.785", least, second=close(r"the works $\pi P x_0$ and $4 F x_0$", math.pi / 4, least))
    yield text("By the right equation (5) the amplitude grows without bound at resonance for less friction.")


@claim("fig-2")
def over_friction(known: Evidence) -> Record:
    exact, other = amplitude(known.squared, 1.5), amplitude(APPROXIMATION, 1.5)
    second = close("the library's exact orbit", known.orbits[1.5], exact)
    yield digits("curve called exact", "0.74", exact, second=second, slip=made_here(SWAPPED, other))
    yield digits("curve called approximation", "0.72", other, slip=made_here(SWAPPED, exact))
    yield text("The upper curve is the approximation, and the lower one the exact amplitude.")


@figure("fig-2", title="At 1.5", caption="Both from $F = 0$ on.", alternative_text="Two falling curves.")
def drawn_again(known: Evidence) -> Figure:
    drawn, shares = Figure((6.0, 3.0), layout="constrained"), [each / 50 for each in range(31)]
    panel = drawn.subplots(subplot_kw={"xlabel": "friction F/P", "ylabel": "amplitude per P/k"})
    for name, squared in (("approximation", APPROXIMATION), ("exact", known.squared)):
        panel.plot(shares, [amplitude(squared, 1.5, each) for each in shares], label=name)
    panel.legend()
    return drawn


@claim("txt-safe-side")
def safe_side(known: Evidence) -> Record:
    exact, other = known.orbits[1.5], amplitude(APPROXIMATION, 1.5)
    more = {"second": so("the conditions", amplitude(known.squared, 1.5) < other), "method": "computed"}
    told, slip = f"{other:.4f} is approximated, and {exact:.4f} exact.", repeated(SWAPPED, True)
    yield assertion("", "The approximation is too small.", other < exact, told, slip=slip, **more)
    yield text("It is too large at 1.5: on the safe side.\n\nWhat the paper advises turns round.")


@claim("eq-8")
def work(known: Evidence) -> Record:
    heat = 4 * 1.2 * 2 * amplitude(known.squared, 1.5)
    yield expression("", 4 * F * x0, 2 * integrate(F, (x, -x0, x0)), left="W")
    yield digits("at 1.5", "6.9", heat, "mJ", second=close("the exact orbit", 1e3 * known.heat, heat))
    yield text("Friction acts against both ways of $2 x_0$.")
