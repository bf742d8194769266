"""SymPy expressions as MATLAB/Octave code: names, line breaks and matrices."""

import re
import textwrap
from collections.abc import Mapping, Sequence

import sympy

LINE_LENGTH = 100
INDENT = 4
CONTINUATION = " ..."
_BREAKABLE = re.compile(r"(?<=[\w.)\]]) (?=[+-] )")
_CONTINUED = re.compile(r"\s*\.\.\.\s*")


class UnnamedSymbolError(ValueError):
    """An expression holds a symbol for which the program has no variable."""


class CodePrinter:
    """Print expressions as code that runs in MATLAB and in GNU Octave.

    Products, quotients and powers of symbols are printed element by element, so variables may be arrays.

    Args:
        names: The variable of the program that stands for each symbol.
    """

    def __init__(self, names: Mapping[sympy.Expr, str]) -> None:
        self._variables = {symbol: sympy.Symbol(name) for symbol, name in names.items()}

    def expression(self, expression: sympy.Expr) -> str:
        """Return an expression as code in one line.

        Raises:
            UnnamedSymbolError: if a symbol has no name.
        """
        unnamed = sorted(str(symbol) for symbol in expression.free_symbols - self._variables.keys())
        if unnamed:
            raise UnnamedSymbolError(
                f"no variable stands for {', '.join(unnamed)} in {expression}: add it to the printer's names"
            )
        return _CONTINUED.sub(" ", sympy.octave_code(expression.xreplace(self._variables)))

    def assignment(self, target: str, expression: sympy.Expr, indent: int = INDENT) -> str:
        """Return ``target = expression;``, broken before a plus or minus where it is too long."""
        return broken(f"{target} = {self.expression(expression)};", indent)

    def matrix(self, target: str, matrix: sympy.MatrixBase) -> str:
        """Return ``target = [...];`` with one line for each row."""
        start = f"{' ' * INDENT}{target} = ["
        rows = (
            ", ".join(self.expression(entry) for entry in matrix.row(index)) for index in range(matrix.rows)
        )
        return start + (";\n" + " " * len(start)).join(rows) + "];"

    def polynomials(self, targets: Mapping[str, Sequence[sympy.Expr]]) -> str:
        """Return vectors of coefficients, one line for each, after the subexpressions that they share."""
        coefficients = [entry for entries in targets.values() for entry in entries]
        names = sympy.numbered_symbols("shared")
        shared, reduced = sympy.cse(coefficients, symbols=names, order="none")
        inner = CodePrinter(
            {symbol: str(variable) for symbol, variable in self._variables.items()}
            | {symbol: str(symbol) for symbol, _ in shared}
        )
        lines = [inner.assignment(str(symbol), value) for symbol, value in shared]
        remaining = iter(reduced)
        for target, entries in targets.items():
            lines += [
                inner.assignment(f"{target}({place})", next(remaining))
                for place, _ in enumerate(entries, start=1)
            ]
        return "\n".join(lines)


def broken(code: str, indent: int = INDENT) -> str:
    """Break a statement before a plus or minus, as far outside of its parentheses as possible."""
    lines, rest, margin = [], code, indent
    while margin + len(rest) > LINE_LENGTH:
        possible = [match.start() for match in _BREAKABLE.finditer(rest)]
        short_enough = [place for place in possible if margin + place + len(CONTINUATION) <= LINE_LENGTH]
        place = max(short_enough or possible[:1], key=lambda end: (-_depth(rest[:end]), end))
        lines.append(" " * margin + rest[:place] + CONTINUATION)
        rest, margin = rest[place + 1 :], indent + INDENT
    return "\n".join([*lines, " " * margin + rest])


def _depth(code: str) -> int:
    return code.count("(") - code.count(")")


def comment(text: str, first: str = "%   ", rest: str = "%   ") -> str:
    """Return text as comment lines, the first with its own prefix."""
    return "\n".join(textwrap.wrap(text, LINE_LENGTH, initial_indent=first, subsequent_indent=rest))
