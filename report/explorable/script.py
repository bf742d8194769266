"""The formulas of the explorable as JavaScript, printed by SymPy."""

import re

import sympy

from report.explorable.formulas import Function

OWN = {"expm1": "Math.expm1"}  # Functions of JavaScript that SymPy's printer does not know
HEAD = "// Printed by SymPy from the derivation when the report was made; nothing here is written by hand.\n"


def script(functions: tuple[Function, ...]) -> str:
    """Return the functions as one constant of a script, ``explorableFormulas``."""
    return f"{HEAD}const explorableFormulas = {{\n{''.join(map(_function, functions))}}};\n"


def _function(function: Function) -> str:
    """Return one function; subexpressions that its results share are computed once."""
    arguments = ", ".join(_code(argument) for argument in function.arguments)
    lines = [f"    const {_code(symbol)} = {_code(value)};" for symbol, value in function.given]
    shared, results = sympy.cse(
        list(function.results.values()), symbols=sympy.numbered_symbols("shared"), order="none"
    )
    lines += [f"    const {_code(symbol)} = {_code(value)};" for symbol, value in shared]
    returned = ",\n".join(
        f"      {name}: {_code(value)}" for name, value in zip(function.results, results, strict=True)
    )
    body = "\n".join(lines) + "\n" if lines else ""
    return f"  {function.name}({arguments}) {{\n{body}    return {{\n{returned},\n    }};\n  }},\n"


def _code(expression: sympy.Expr) -> str:
    """Return an expression as JavaScript in one line.

    Raises:
        ValueError: if SymPy has no JavaScript for a part of it.
    """
    code = sympy.jscode(expression, user_functions=OWN)
    if "//" in code:
        raise ValueError(f"SymPy cannot print {expression} as JavaScript")
    return re.sub(r"\s+", " ", code)
