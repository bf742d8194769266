"""LaTeX of the derivations: dots for time derivatives, functions of time without their argument."""

import re
import string
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.printing.latex import LatexPrinter

from derivations.symbols import t

SPECIAL = {
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "`": r"\textasciigrave{}",
    **{character: f"\\{character}" for character in "{}$&#_%"},
}
DOTS = {1: r"\dot", 2: r"\ddot", 3: r"\dddot"}


class _MechanicsPrinter(LatexPrinter):
    """SymPy's LaTeX printer with Newton's dots."""

    def _print_Derivative(self, expr: sympy.Derivative) -> str:
        known = isinstance(expr.expr, AppliedUndef) and expr.variables == (t,) * len(expr.variables)
        if not known or len(expr.variables) not in DOTS:
            return super()._print_Derivative(expr)
        name, _, index = self._print(sympy.Symbol(expr.expr.func.__name__)).partition("_")
        dotted = f"{DOTS[len(expr.variables)]}{{{name}}}"
        return f"{dotted}_{index}" if index else dotted

    def _print_Function(self, expr: sympy.Function, exp: Any = None) -> str:
        if isinstance(expr, AppliedUndef) and expr.args == (t,):
            name = self._print(sympy.Symbol(expr.func.__name__))
            return f"{name}^{{{exp}}}" if exp is not None else name
        return super()._print_Function(expr, exp)

    def _print_re(self, expr: sympy.re, exp: Any = None) -> str:
        return rf"\operatorname{{Re}}\left({self._print(expr.args[0])}\right)"

    def _print_im(self, expr: sympy.im, exp: Any = None) -> str:
        return rf"\operatorname{{Im}}\left({self._print(expr.args[0])}\right)"

    def _print_Integral(self, expr: sympy.Integral) -> str:
        return str(super()._print_Integral(expr)).replace(r"\int\limits", r"\int")

    def _print_Mul(self, expr: sympy.Mul) -> str:
        # SymPy sends a power with a negative exponent here too, to be set as a fraction.
        if expr.is_Mul and not any(factor.is_Mul for factor in expr.args):
            expr = sympy.Mul(*sorted(expr.args, key=lambda factor: factor.sort_key()), evaluate=False)
        return str(super()._print_Mul(expr))


def latex(expression: sympy.Basic) -> str:
    """Return LaTeX of an expression, its terms in the order in which they are held."""
    settings = {
        "imaginary_unit": "j",
        "inv_trig_style": "power",
        "order": "none",
        "mat_delim": "(",
        "mat_str": "matrix",
        "long_frac_ratio": 3,
    }
    return _MechanicsPrinter(settings).doprint(expression)


def latex_number(value: float) -> str:
    """Return LaTeX of a number with at most 12 digits, a power of ten as such."""
    digits, _, exponent = f"{value:.12g}".partition("e")
    return f"${digits} \\cdot 10^{{{int(exponent)}}}$" if exponent else f"${digits}$"


def latex_text(words: str) -> str:
    """Return LaTeX of plain words, in which no character has a meaning of its own."""
    return "".join(SPECIAL.get(character, character) for character in words)


def escaped(words: str) -> str:
    """Return plain words for the prose of a step: no character has a meaning of its own."""
    return re.sub(f"([{re.escape(string.punctuation)}])", r"\\\1", words)


def latex_prose(text: str) -> str:
    """Return LaTeX of the prose of a step."""
    return _MARKED.sub(_as_latex, text)


_MARKED = re.compile(
    rf"(?P<mathematics>\$(?:\\.|[^$\\])*\$)|\\(?P<character>[{re.escape(string.punctuation)}])|`(?P<code>[^`]*)`"
)


def _as_latex(marked: re.Match[str]) -> str:
    if marked["mathematics"]:
        return marked["mathematics"]
    if marked["character"]:
        return latex_text(marked["character"])
    return f"\\texttt{{{marked['code']}}}"


def latex_equation(left: sympy.Basic, right: sympy.Basic) -> str:
    """Return LaTeX of the equation ``left = right``; neither side is evaluated or reordered."""
    return f"{latex(left)} = {latex(right)}"
