"""SymPy's expressions and python-control's systems, taken apart into data and put together again."""

from collections.abc import Callable
from typing import Any

Parts = tuple[Any, ...]


def taken_apart(value: Any) -> tuple[str, Parts]:
    """Return the tag and the parts of an expression or a system.

    Raises:
        TypeError: if it is of a type that is not put together again.
    """
    import control  # Whatever is kept was computed with these two, so they are loaded already.
    import sympy
    from sympy.core.function import AppliedUndef

    match value:
        case sympy.Symbol():
            (name,), assumptions = value.__getnewargs_ex__()
            return "symbol", (name, dict(assumptions))
        case sympy.Rational():
            return "rational", (int(value.p), int(value.q))
        case AppliedUndef():
            # SymPy keeps what is assumed of a function there, as its own pickling does.
            return "function of", (value.func.__name__, dict(value.func._kwargs), value.args)
        case sympy.ImmutableDenseMatrix():
            return "matrix", (*value.shape, tuple(value.flat()))
        case sympy.Add() | sympy.Mul() | sympy.Pow() | sympy.Tuple() | sympy.Derivative():
            return type(value).__name__, value.args
        case control.StateSpace():
            labels = (value.name, value.state_labels, value.input_labels, value.output_labels)
            return "state space", (value.A, value.B, value.C, value.D, value.dt, *labels)
        case control.TransferFunction():
            coefficients = (value.num_list, value.den_list)
            return "transfer function", (*coefficients, value.dt, value.name)
    raise TypeError(f"{type(value).__module__}.{type(value).__qualname__} cannot be kept: it is no data")


def put_together(tag: str, parts: Parts) -> Any:
    """Return what was taken apart.

    Raises:
        KeyError: if there is no such tag.
        TypeError: if a part is not what it should be.
    """
    import sympy

    makers: dict[str, Callable[..., Any]] = {
        "symbol": lambda name, assumed: sympy.Symbol(_text(name), **_assumptions(assumed)),
        "rational": lambda p, q: sympy.Rational(_whole(p), _whole(q)),
        "function of": lambda name, assumed, of: sympy.Function(_text(name), **_assumptions(assumed))(
            *_expressions(of)
        ),
        "matrix": lambda rows, columns, of: sympy.ImmutableDenseMatrix(
            _whole(rows), _whole(columns), _expressions(of)
        ),
        # With its terms in the order in which they stood: SymPy would put them in its own.
        "Add": lambda *terms: sympy.Add(*_expressions(terms), evaluate=False),
        "Mul": lambda *terms: sympy.Mul(*_expressions(terms), evaluate=False),
        "Pow": lambda *of: sympy.Pow(*_expressions(of)),
        "Tuple": lambda *of: sympy.Tuple(*_expressions(of)),
        "Derivative": lambda *of: sympy.Derivative(*_expressions(of)),
        "state space": _state_space,
        "transfer function": _transfer_function,
    }
    return makers[tag](*parts)


def _expressions(parts: Parts) -> Parts:
    """Refuse text among expressions: SymPy would evaluate it as Python."""
    import sympy

    return tuple(_checked(part, sympy.Basic) for part in parts)


def _assumptions(assumed: Any) -> dict[str, bool]:
    return {_text(name): bool(_checked(value, bool)) for name, value in assumed.items()}


def _text(part: Any) -> str:
    return str(_checked(part, str))


def _whole(part: Any) -> int:
    return int(_checked(part, int))


def _checked(part: Any, kind: type) -> Any:
    if not isinstance(part, kind):
        raise TypeError(f"{part!r} is no {kind.__name__}")
    return part


def _state_space(A: Any, B: Any, C: Any, D: Any, dt: Any, name: str, *labels: list[str]) -> Any:
    import control

    states, inputs, outputs = labels
    return control.StateSpace(A, B, C, D, dt, name=name, states=states, inputs=inputs, outputs=outputs)


def _transfer_function(numerators: Any, denominators: Any, dt: Any, name: str) -> Any:
    import control

    return control.TransferFunction(numerators, denominators, dt, name=name)
