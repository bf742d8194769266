"""The steps from the derived equations to numbers of the thesis's trimmer, in the order of the derivation."""

from collections.abc import Sequence

from derivations.loop.narrative import loop_narrative
from derivations.step import Formula, NarrativeStep
from report.derivation.linear_steps import array, linear_steps
from report.judging.text import one_line
from report.numbers.evidence import Evidence
from report.numbers.exact_orbits import orbit_by_durations
from report.numbers.newton_by_hand import Iteration, newton_by_hand
from report.numbers.record import Record, line_amplitudes
from report.numbers.thesis import SMALL_GAP
from trimmer import FrictionBacklash, harmonic_leakage, limit_cycles, periodic_orbits
from trimmer.arrays import Reals
from trimmer.loops.simulation import simulate_loop


def number_steps(known: Evidence) -> tuple[NarrativeStep, ...]:
    """Return the steps, from the linear trimmer's numbers to what is only read in the text.

    Raises:
        UnprovenError: if an equation is not proven.
    """
    balance, method, loeb, dissipation = loop_narrative(known.derivation)
    return (
        *linear_steps(known),
        balance,
        method,
        _solution(known),
        loeb,
        _exact_orbit(known),
        _motion(),
        dissipation,
        _spectrum(),
        _reading(),
    )


def _solution(known: Evidence) -> NarrativeStep:
    numerator, denominator = (
        [float(each) for each in row] for row in (known.numbers.numerator, known.numbers.denominator)
    )
    iterations = newton_by_hand(numerator, denominator)
    last = iterations[-1]
    text = one_line(f"""
        The equations above with numbers: friction-controlled backlash in the loop of the thesis, the pin's
        displacement alone. The first guess is ten gaps at 740 Hz. The residual falls from
        {abs(iterations[0].residual):.2f} to rounding in {len(iterations) - 1} iterations; the right digits
        double each time. At the end $A/g = {last.amplitude:.4f}$, so for a gap of 4 µm the amplitude is
        {1e6 * SMALL_GAP * last.amplitude:.3f} µm, and the frequency is {last.omega:.2f} rad/s or
        {last.frequency:.2f} Hz.
    """)
    return NarrativeStep(
        "solution",
        "Amplitude and frequency with numbers: 733.63 Hz",
        f"{text}\n\n{_left_out(known)}",
        (
            Formula(_table(iterations)),
            Formula(
                rf"N = {_complex(last.gain)}, \quad G = {_complex(1 / last.inverse)}, \quad "
                rf"N G = {_complex(last.gain / last.inverse)}",
                words="To check, the last line put into the condition:",
            ),
        ),
        code=(newton_by_hand, limit_cycles, harmonic_leakage),
    )


def _left_out(known: Evidence) -> str:
    cycle = known.cycles.friction.stable
    third, *_ = harmonic_leakage(known.numbers.displacement_only, FrictionBacklash(1.0), cycle)
    return one_line(f"""
        Newton's method finds what lies near its guess. That there are no others, besides the unstable one at
        {known.cycles.friction.unstable.frequency:.2f} Hz, is proven by a search that excludes the rest of the
        plane. What harmonic balance leaves out is small here: of the third harmonic {third:.2%} of the
        fundamental comes back.
    """)


def _table(iterations: Sequence[Iteration]) -> str:
    """Return the iterations as an array of TeX."""
    head = (r"\text{step}", r"\ell \text{ (rad)}", "A/g", r"f \text{ (Hz)}", "N", "1/G", "|N + 1/G|")
    rows = (
        (
            str(number),
            f"{each.angle:.6f}",
            f"{each.amplitude:.5f}",
            f"{each.frequency:.4f}",
            _complex(each.gain),
            _complex(each.inverse),
            _power(abs(each.residual)),
        )
        for number, each in enumerate(iterations)
    )
    return array((head, *rows))


def _complex(value: complex) -> str:
    real = 0.0 if abs(value.real) < 5e-7 else value.real
    imaginary = 0.0 if abs(value.imag) < 5e-7 else value.imag
    return f"{real:.5f} {'-' if imaginary < 0 else '+'} {abs(imaginary):.5f}\\,j"


def _power(value: float) -> str:
    digits, exponent = f"{value:.1e}".split("e")
    return rf"{digits} \cdot 10^{{{int(exponent)}}}"


def _exact_orbit(known: Evidence) -> NarrativeStep:
    orbit, cycle = known.orbits.friction.stable, known.cycles.friction.stable
    contact, flight = _durations(orbit.switching_times, orbit.period)
    text = one_line(
        r"""
        Harmonic balance keeps one harmonic; the loop itself can be solved without leaving anything out.
        Between two events it is linear, so its motion is known in closed form. On the contact the element's
        output follows its input $-y$ at the distance $g/2$; in the flight of a load without inertia it rests
        at $r$, where it was left.
        """
    )
    by_frequency = abs(cycle.frequency / orbit.frequency - 1)
    by_amplitude = abs(cycle.amplitude / orbit.amplitude - 1)
    numbers = one_line(f"""
        There are as many equations as unknowns: the state $x_0$ at an impact and the two durations. For given
        durations all of them are linear in the state. Solved by Newton's method, they give a contact of
        {1e3 * contact:.5f} ms, a flight of {1e3 * flight:.5f} ms, a frequency of {orbit.frequency:.2f} Hz and
        an amplitude of {orbit.amplitude:.4f} gaps. Harmonic balance gives {cycle.frequency:.2f} Hz and
        {cycle.amplitude:.4f} gaps: its error is {by_frequency:.3%} in frequency and {by_amplitude:.2%} in
        amplitude.
    """)
    return NarrativeStep(
        "exact-orbit",
        "The exact orbit",
        text,
        (
            Formula(
                r"\dot{x} = (A - B C)\, x - \frac{g}{2} B \ \text{ (contact)}, \quad "
                r"\dot{x} = A x + B r \ \text{ (flight)}, \quad y = C x"
            ),
            Formula(
                r"x(t) = e^{St} x(0) + \int_0^t e^{S \tau} d\tau \; h \quad \text{for} \quad "
                r"\dot{x} = S x + h",
                words="With constant $S$ and $h$ the solution is a matrix exponential.",
            ),
            Formula(
                r"x_1 = x(t_c) \ \text{ from } x_0 \text{ on the contact}, \quad "
                r"x_2 = x(t_f) \ \text{ from } x_1 \text{ in the flight}",
                words="A contact of the duration $t_c$ and a flight of the duration $t_f$ make half of the "
                "period. Then everything has changed its sign.",
            ),
            Formula(
                r"x_2 = -x_0, \quad C \dot{x}(t_c) = 0, \quad -C x_2 - r + \frac{g}{2} = 0, \quad "
                r"r = -C x_1 - \frac{g}{2}",
                words="The contact ends where the velocity changes its sign, the flight where the input has "
                "crossed the gap:",
            ),
            Formula(
                r"f = \frac{1}{2 (t_c + t_f)}" + rf" = {orbit.frequency:.2f}\ \mathrm{{Hz}}", words=numbers
            ),
        ),
        code=(orbit_by_durations, periodic_orbits),
    )


def _durations(switches: Reals, period: float) -> tuple[float, float]:
    """Return the durations of contact and flight in half a period, s."""
    leave, meet = map(float, switches[:2])
    return period / 2 - (meet - leave), meet - leave


def _motion() -> NarrativeStep:
    return NarrativeStep(
        "motion-in-time",
        "Exact motion in time",
        "A motion from any start is put together in the same way. Within a segment the loop is linear, and "
        "its state, with the drive among the states, is a matrix exponential. The segment ends at the first "
        "zero of an event function: a contact force, a distance to a wall, a relative velocity. It is "
        "isolated on a polynomial whose truncation is below rounding, so that no event is passed over. Then "
        "the next segment begins, with the impact's new velocity where there is one.",
        (
            Formula(r"x(t) = e^{S_i (t - t_i)} x(t_i), \quad t_i \le t \le t_{i+1}"),
            Formula(r"t_{i+1} = \min \left\{ t > t_i : e_i(x(t)) = 0 \right\}"),
        ),
        code=(simulate_loop,),
    )


def _spectrum() -> NarrativeStep:
    return NarrativeStep(
        "spectrum",
        "What a spectrum of a record can tell",
        "A record of $n$ samples over the time $T$, both of whose ends belong to it, has the sample rate "
        "$(n - 1)/T$. Its discrete Fourier transform has a value at every whole multiple of the bin width. A "
        "peak is read at a bin, so a frequency that is read is right to half a bin at best.",
        (
            Formula(
                r"X_k = \sum_{m=0}^{n-1} x_m\, e^{-2\pi j k m/n}, \quad f_k = k\, \Delta f, \quad "
                r"\Delta f = \frac{n - 1}{n\, T}"
            ),
        ),
        code=(Record, line_amplitudes),
    )


def _reading() -> NarrativeStep:
    return NarrativeStep(
        "reading",
        "What is only read",
        "Some statements compare places of the thesis with each other: a name, a caption, a reference, a "
        "number quoted from elsewhere. Nothing is derived for them. Their cards say which places were read.",
        (),
    )
