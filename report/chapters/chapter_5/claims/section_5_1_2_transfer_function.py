"""Claims of section 5.1.2 on the transfer function: its coefficients (equation 5.1) and its order."""

from fractions import Fraction

import control
import numpy as np
import sympy

from report.judging.claim import CopyFault
from report.judging.comparisons.digits import PrintedDigits
from report.judging.comparisons.printed import power
from report.judging.parts import assertion, close, digits, equal, lost_in_the_copy, repeated
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent import linear_trimmer
from trimmer import linear_model
from trimmer.thesis import TrimmerBody

PRINTED_NUMERATOR = ("1e7", "1.233e10", "5.939e14", "1.655e17", "4.079e21", "3.71e23", "5.79e27")
PRINTED_DENOMINATOR = (
    *("1", "1378", "7.0767", "3.878e10", "1.069e15"),
    *("2.676e17", "4.889e21", "4.595e23", "5.971e27"),
)
CUTTER, GUARD = TrimmerBody.CUTTER.index, TrimmerBody.GUARD.index


@claim("eq-5.1")
def transfer_function(known: Evidence) -> Record:
    numbers, model = known.numbers, linear_model(known.numbers.parameters)
    wrong_output = numbers.combined_numerator({CUTTER: 1, GUARD: 1})
    converted = np.trim_zeros(np.round(control.ss2tf(model[0, 0]).num[0][0], 0), "f")
    highest = len(PRINTED_NUMERATOR) - 1
    judged_together = "coefficients of s^3 to s^0 above the bar in equation 5.1"
    above = zip(PRINTED_NUMERATOR, numbers.numerator, wrong_output, converted[-highest - 1 :], strict=True)
    for place, (printed, derived, wrong, other) in enumerate(above):
        second = close("conversion of the state space", other, float(derived), 1e-6)
        slip = repeated("the output is q2 + q4 instead of q2 - q4", wrong)
        item = "" if derived == wrong else judged_together
        label = f"above the bar, $s^{{{highest - place}}}$"
        form = _as_in_the_copy(printed)
        yield digits(label, printed, derived, second=second, slip=slip, item=item, printed_form=form)
    highest = len(PRINTED_DENOMINATOR) - 1
    below = zip(PRINTED_DENOMINATOR, numbers.denominator, np.poly(model.A), strict=True)
    for place, (printed, derived, other) in enumerate(below):
        second = close("the product of the eigenvalues", other, float(derived), 1e-6)
        label = f"below the bar, $s^{{{highest - place}}}$"
        fault, form = _superscript(printed, derived), _as_in_the_copy(printed)
        yield digits(label, printed, derived, second=second, copy_fault=fault, printed_form=form)
    as_printed, in_fractions = 1.233**10, float(Fraction("1.233") ** 10)
    name = "a factor of ten under each exponent, or the letter e of 1.233e10"
    yield assertion(
        "powers of ten",
        "$1.233^{10}$, as it stands in the copy, is the coefficient of $s^5$",
        PrintedDigits("1.233e10", as_printed).compare().agrees,
        rf"$1.233^{{10}} = {as_printed:.2f}$; meant is $1.233\cdot 10^{{10}}$",
        method="evaluation as it stands",
        second=close("ten factors in exact fractions", in_fractions, as_printed),
        copy_fault=lost_in_the_copy(name, PrintedDigits("1.233e10", float(numbers.numerator[1]))),
    )
    static = numbers.denominator[-1]
    of_the_sum, right = float(wrong_output[-1] / static), float(numbers.numerator[-1] / static)
    yield text(f"""
        The last four coefficients of the numerator belong to $q_2 + q_4$, not to the output $q_2 - q_4$ of
        equation 2.14; the first three are the same for both. In the copy the powers of ten stand as powers of
        the digits before them, and once, in 7.0767, as a further digit. The machine that read the page may
        have done that; the page would decide it.

        The printed function has a static gain of {of_the_sum:.4f} instead of {right:.4f}. Listing A.9, which
        computes the limit cycles, has the right coefficients, so no prediction changes.
    """)


def _as_in_the_copy(printed: str) -> str:
    """Return a coefficient as the copy has it: its power of ten as one of the digits before it."""
    mantissa, _, exponent = printed.partition("e")
    return f"{mantissa}^{{{exponent}}}" if exponent else mantissa


def _superscript(printed: str, derived: Fraction) -> CopyFault | None:
    """Return what the copy may have lost in a coefficient without an exponent: its last digit may be one."""
    if "e" in printed or "." not in printed:
        return None
    restored = f"{printed[:-1]}e{printed[-1]}"
    name = rf"the last digit is an exponent, as in ${printed[:-1]}^{printed[-1]}$, for {power(restored)}"
    return lost_in_the_copy(name, PrintedDigits(restored, derived))


@claim("txt-5.1.2-order")
def order(known: Evidence) -> Record:
    numbers, system = known.numbers, known.numbers.displacement_only
    above, below = (
        sympy.Poly([sympy.Rational(c.numerator, c.denominator) for c in coefficients], sympy.Symbol("s"))
        for coefficients in (numbers.numerator, numbers.denominator)
    )
    minimal = below.degree() - sympy.gcd(above, below).degree()
    seen = linear_trimmer.states_in_use(linear_model(numbers.parameters)[0, 0])
    nearest = min(abs(pole - zero) / abs(pole) for pole in system.poles() for zero in system.zeros())
    second = equal("the Popov-Belevitch-Hautus test of every eigenvalue", seen, minimal)
    yield digits("", "8", minimal, second=second)
    yield text(f"""
        Numerator and denominator have no common factor in exact arithmetic, so all eight states count. One
        pair of poles comes within {100 * nearest:.3f} % of a pair of zeros, which hides a resonance and keeps
        the order.
    """)
