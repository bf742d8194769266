"""Claims of section 5.1.2 on the transfer function, its order and its Nyquist locus."""

from __future__ import annotations

from fractions import Fraction

import control
import numpy as np
import sympy
from numpy.typing import NDArray

from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.linear_numbers import LinearNumbers
from trimmer import encirclements, linear_model

PRINTED_NUMERATOR = ("1e7", "1.233e10", "5.939e14", "1.655e17", "4.079e21", "3.71e23", "5.79e27")
PRINTED_DENOMINATOR = (
    *("1", "1378", "7.0767", "3.878e10", "1.069e15"),
    *("2.676e17", "4.889e21", "4.595e23", "5.971e27"),
)
CUTTER, GUARD = 1, 3
ROUNDING = 1e-10


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    numbers = evidence.numbers
    return (_transfer_function(numbers), _order(numbers), _nyquist(numbers), _nyquist_locus(numbers))


def _transfer_function(numbers: LinearNumbers) -> Claim:
    wrong_output = numbers.combined_numerator({CUTTER: 1, GUARD: 1})
    static_gain = [float(rows[-1] / numbers.denominator[-1]) for rows in (numbers.numerator, wrong_output)]
    return Claim(
        id="eq-5.1",
        parts=(
            *_numerator_parts(numbers, wrong_output),
            *_denominator_parts(numbers),
            Part(
                "powers of ten",
                Assertion(
                    statement="$1.233^{10}$, read as printed, is the coefficient of $s^5$",
                    derived=PrintedDigits("1.233e10", 1.233**10).compare().agrees,
                    evidence=f"$1.233^{{10}} = {1.233**10:.2f}$; meant is $1.233\\cdot 10^{{10}}$",
                    method="evaluation as printed",
                ),
                Confirmation(
                    "ten factors in exact fractions", CloseNumbers(float(Fraction("1.233") ** 10), 1.233**10)
                ),
            ),
        ),
        explanation=(
            "The last four coefficients of the numerator belong to $q_2 + q_4$, not to the output $q_2 - "
            "q_4$ of equation 2.14; the first three are the same for both. Powers of ten are set as powers "
            "of the coefficient, and in the coefficient of $s^6$ below the fraction bar the exponent 7 "
            "stands behind the digits 7.076."
        ),
        consequence=(
            f"The printed function has a static gain of {static_gain[1]:.4f} instead of "
            f"{static_gain[0]:.4f}. Listing A.9, which computes the limit cycles, has the right "
            "coefficients, so no prediction changes."
        ),
        impact=Impact.LOCAL,
        source="derivations/transfer_function.py",
    )


def _numerator_parts(numbers: LinearNumbers, wrong_output: tuple[Fraction, ...]) -> list[Part]:
    system = control.ss2tf(linear_model(numbers.parameters)[0, 0])
    converted = np.trim_zeros(np.round(system.num[0][0], 0), "f")[-len(PRINTED_NUMERATOR) :]
    slip = "the output is q2 + q4 instead of q2 - q4"
    return [
        Part(
            f"above the bar, $s^{{{len(PRINTED_NUMERATOR) - 1 - index}}}$",
            PrintedDigits(printed, derived),
            Confirmation("conversion of the state space", CloseNumbers(other, float(derived), 1e-6)),
            Slip(slip, wrong, Verdict.EXPLAINED),
        )
        for index, (printed, derived, wrong, other) in enumerate(
            zip(PRINTED_NUMERATOR, numbers.numerator, wrong_output, converted, strict=True)
        )
    ]


def _denominator_parts(numbers: LinearNumbers) -> list[Part]:
    from_eigenvalues = np.poly(linear_model(numbers.parameters).A)
    return [
        Part(
            f"below the bar, $s^{{{len(PRINTED_DENOMINATOR) - 1 - index}}}$",
            PrintedDigits(printed, derived),
            Confirmation("the product of the eigenvalues", CloseNumbers(other, float(derived), 1e-6)),
            Slip(
                "the exponent of ten stands behind the digits", _exponent_as_digit(derived), Verdict.ERRATUM
            ),
        )
        for index, (printed, derived, other) in enumerate(
            zip(PRINTED_DENOMINATOR, numbers.denominator, from_eigenvalues, strict=True)
        )
    ]


def _exponent_as_digit(value: Fraction) -> Fraction:
    """Return what is read when 7.076e+07 is set with its exponent as a further digit, 7.0767."""
    digits, _, exponent = f"{float(value):.3e}".partition("e")
    return Fraction(f"{digits}{int(exponent)}")


def _order(numbers: LinearNumbers) -> Claim:
    power = sympy.Symbol("s")
    above, below = (
        sympy.Poly([sympy.Rational(c.numerator, c.denominator) for c in coefficients], power)
        for coefficients in (numbers.numerator, numbers.denominator)
    )
    minimal = below.degree() - sympy.gcd(above, below).degree()
    poles, zeros = numbers.displacement_only.poles(), numbers.displacement_only.zeros()
    nearest = min(abs(pole - zero) / abs(pole) for pole in poles for zero in zeros)
    seen = _eigenvalues_seen(linear_model(numbers.parameters)[0, 0])
    return Claim(
        id="txt-5.1.2-order",
        parts=(
            Part(
                "",
                PrintedDigits("8", minimal),
                Confirmation(
                    "the Popov-Belevitch-Hautus test of every eigenvalue", CloseNumbers(seen, minimal)
                ),
            ),
        ),
        explanation=(
            "Numerator and denominator have no common factor, in exact arithmetic, so all eight states "
            f"count. One pair of poles comes within {100 * nearest:.3f} % of a pair of zeros, which hides a "
            "resonance but keeps the order."
        ),
        source="derivations/transfer_function.py",
    )


def _eigenvalues_seen(system: control.StateSpace) -> int:
    """Count the eigenvalues that the input reaches and the output shows."""
    scale = float(np.abs(system.poles()).max())
    states = np.repeat([1.0, scale], system.nstates // 2)
    a = system.A * states / states[:, None] / scale
    b, c = system.B / states[:, None] / scale, system.C * states
    shifted = [a - eigenvalue * np.eye(system.nstates) for eigenvalue in np.linalg.eigvals(a)]
    return sum(
        min(_smallest_singular_value(np.hstack([each, b])), _smallest_singular_value(np.vstack([each, c])))
        > ROUNDING
        for each in shifted
    )


def _smallest_singular_value(matrix: NDArray[np.complex128]) -> float:
    return float(np.linalg.svd(matrix, compute_uv=False).min())


def _no_encirclement_part(numbers: LinearNumbers) -> Part:
    system = numbers.displacement_only
    sampled = control.nyquist_response(system).count
    turns = encirclements(system, -1.0)
    return Part(
        "encirclements of $-1$",
        PrintedDigits("0", turns),
        Confirmation("python-control's Nyquist count", CloseNumbers(1.0 + sampled, 1.0 + turns)),
    )


def _nyquist(numbers: LinearNumbers) -> Claim:
    unstable = control.tf([0.5], [1, -1])
    silent = encirclements(unstable, -1.0) == 0
    open_loop_stable = all(pole.real < 0 for pole in unstable.poles())
    early, late = control.impulse_response(unstable, np.array([1.0, 2.0])).outputs
    return Claim(
        id="txt-5.1.2-nyquist",
        parts=(
            _no_encirclement_part(numbers),
            Part(
                "the conclusion drawn",
                Assertion(
                    statement="a locus that does not encircle $-1$ shows that the open loop is stable",
                    derived=not silent or open_loop_stable,
                    evidence=(
                        "$0.5/(s - 1)$ does not encircle $-1$ and is unstable. The count gives unstable "
                        "poles of the closed loop, and needs those of the open loop to be known"
                    ),
                    method="counterexample",
                ),
                second_way(
                    "python-control's Nyquist count of it, zero, and its response to an impulse, which grows",
                    control.nyquist_response(unstable).count == 0 and abs(late) > abs(early),
                ),
            ),
        ),
        explanation=(
            "The count is right, the conclusion is not: with no encirclement and no unstable pole of the "
            "open loop (its eigenvalues show that), it is the closed loop with unit gain that is stable."
        ),
        consequence=(
            "None: the trimmer is stable in open loop by equation 5.2. The right conclusion matters later, "
            "since unit gain is the limit of a small gap: the trimmer without play is stable in the thesis's "
            "loop."
        ),
        impact=Impact.LOCAL,
        source="trimmer/nyquist.py",
    )


def _nyquist_locus(numbers: LinearNumbers) -> Claim:
    return Claim(
        id="fig-5.3",
        parts=(_no_encirclement_part(numbers),),
        explanation=(
            "The redrawn locus stays clear of $-1$, as the text reads from it. It meets the real axis on the "
            "positive side only, so every positive gain would leave the loop stable."
        ),
        source="trimmer/nyquist.py",
    )
