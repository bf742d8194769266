"""The linear trimmer with numbers: coefficients, modes, frequency response, Nyquist locus, motion in time."""

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction

from derivations.step import Formula, NarrativeStep
from report.judging.text import one_line
from report.numbers.evidence import Evidence
from report.numbers.linear_numbers import solve_linear
from trimmer import modes, resonance_peaks, response_at, transfer_function
from trimmer.linear import asymptotic_roll_off, bandwidth, encirclements, time_response


def linear_steps(known: Evidence) -> tuple[NarrativeStep, ...]:
    """Return the steps with numbers of the linear trimmer."""
    return (
        _coefficients(known),
        _modes(known),
        _frequency_response(known),
        _nyquist(known),
        _time_response(),
    )


def _coefficients(known: Evidence) -> NarrativeStep:
    return NarrativeStep(
        "numbers",
        "The transfer function with numbers",
        "The parameters of the thesis put into the coefficients. They are computed as fractions, and are "
        "exact to the last digit of the parameters; six digits are shown.",
        (Formula(_table(known.numbers.numerator, known.numbers.denominator)),),
        code=(solve_linear, transfer_function),
    )


def _table(numerator: Sequence[Fraction], denominator: Sequence[Fraction]) -> str:
    """Return the coefficients by power as an array of TeX, highest power first."""
    highest = len(denominator) - 1
    missing = highest + 1 - len(numerator)
    above = ["" for _ in range(missing)] + [_digits(float(each)) for each in numerator]
    rows = (
        (str(power), b, _digits(float(a)))
        for power, b, a in zip(range(highest, -1, -1), above, denominator, strict=True)
    )
    return array((("i", "b_i", "a_i"), *rows))


def array(rows: Iterable[Sequence[str]]) -> str:
    """Return rows of cells as an array of TeX, its columns flush right and well apart."""
    lines = [r" & \quad ".join(row) for row in rows]
    columns = lines[0].count("&") + 1
    return rf"\begin{{array}}{{{'r' * columns}}} " + r" \\ ".join(lines) + r" \end{array}"


def _digits(value: float) -> str:
    digits, _, exponent = f"{value:.5e}".partition("e")
    return digits if int(exponent) == 0 else rf"{digits} \cdot 10^{{{int(exponent)}}}"


def _modes(known: Evidence) -> NarrativeStep:
    return NarrativeStep(
        "modes",
        "Modes",
        "Without the pin the trimmer swings in its modes. Each is a solution $\\psi\\, e^{\\lambda t}$ of "
        "the equations of motion; $\\lambda$ is a zero of the denominator, and an eigenvalue of the state "
        "matrix. Its imaginary part is the frequency of a free oscillation, its real part how fast that dies "
        "away.",
        (
            Formula(
                r"\left(M \lambda^2 + C \lambda + K\right) \psi = 0, \quad "
                r"\zeta = -\frac{\operatorname{Re} \lambda}{|\lambda|}"
            ),
            Formula(_modes_table(known), words="For the thesis's trimmer:"),
        ),
        code=(modes,),
    )


def _modes_table(known: Evidence) -> str:
    rows = (
        (
            f"{each.eigenvalue.real:.2f}",
            f"{each.eigenvalue.imag:.2f}",
            f"{each.eigenvalue.imag / (2 * math.pi):.2f}",
            f"{-each.eigenvalue.real / abs(each.eigenvalue):.4f}",
        )
        for each in known.numbers.modes
    )
    head = (
        r"\operatorname{Re} \lambda \text{ (1/s)}",
        r"\operatorname{Im} \lambda \text{ (rad/s)}",
        r"\text{frequency (Hz)}",
        r"\zeta",
    )
    return array((head, *rows))


def _frequency_response(known: Evidence) -> NarrativeStep:
    system = known.numbers.displacement_only
    peaks = ", ".join(f"{peak.omega / (2 * math.pi):.2f}" for peak in resonance_peaks(system))
    text = one_line(rf"""
        A pin that moves as $\sin\omega t$ moves the output by the complex factor $G(j\omega)$. Its modulus is
        largest at the resonances, zeros of the derivative of $|G|^2$, which is a polynomial in $\omega^2$
        over another: they are at {peaks} Hz. At high frequency the two highest powers are left. The
        denominator has two powers more than the numerator, so $|G|$ falls by
        {-asymptotic_roll_off(system):.0f} dB per decade. It is 3 dB below its value at rest from
        {bandwidth(system):.1f} rad/s on.
    """)
    return NarrativeStep(
        "frequency-response",
        "Frequency response: resonances and roll-off",
        text,
        (
            Formula(r"|G(j\omega)|^2 = G(j\omega)\, G(-j\omega), \quad \frac{d}{d\omega} |G(j\omega)|^2 = 0"),
            Formula(r"G(j\omega) \to -\frac{b_6}{\omega^2} \quad \text{for} \quad \omega \to \infty"),
        ),
        code=(response_at, resonance_peaks, bandwidth, asymptotic_roll_off),
    )


def _nyquist(known: Evidence) -> NarrativeStep:
    turns = encirclements(known.numbers.displacement_only)
    return NarrativeStep(
        "nyquist",
        "Nyquist locus",
        one_line(f"""
            How often $1 + G$ turns round the origin, while $s$ runs up the imaginary axis and back at
            infinity, is the number of its zeros less that of its poles in the right half-plane: the sum of
            the residues of its logarithmic derivative. The open loop is stable, so $P = 0$. The locus turns
            {turns} times round $-1$, so the closed loop without a nonlinearity is stable.
        """),
        (Formula(r"\frac{1}{2\pi j} \oint \frac{G'(s)}{1 + G(s)}\, ds = Z - P"),),
        code=(encirclements,),
    )


def _time_response() -> NarrativeStep:
    return NarrativeStep(
        "time-response",
        "Motion of the linear trimmer in time",
        "The state at the end of a time step is a matrix exponential times that at its start, plus what the "
        "input has added. For an input that runs straight between its samples this is exact.",
        (Formula(r"x(t) = e^{At} x(0) + \int_0^t e^{A(t - \tau)} B\, u(\tau)\, d\tau"),),
        code=(time_response,),
    )
