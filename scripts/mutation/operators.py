"""The ways to change a node of the syntax tree, by kind."""

import ast
from collections.abc import Callable, Iterator
from copy import deepcopy
from enum import Enum
from itertools import pairwise

from scripts.mutation.exclusions import (
    is_extreme,
    is_look,
    is_plain_number,
    is_setting,
    is_setting_name,
    is_setting_word,
)

Outer = tuple[ast.AST, ...]


class Kind(Enum):
    """What is changed."""

    ARITHMETIC = "arithmetic operator"
    COMPARISON = "comparison"
    CONSTANT = "constant"
    INDEX = "index"
    SIGN = "removed minus or not"
    LOGIC = "and, or, condition"
    REMOVAL = "removed statement"
    CALL = "removed call"
    ARGUMENTS = "swapped arguments"
    FUNCTION = "another function"
    RETURN = "another name returned"
    KEYWORD = "dropped keyword"
    DEFAULT = "changed default"
    SETTING = "changed setting"


ARITHMETIC: dict[type[ast.operator], tuple[type[ast.operator], ...]] = {
    ast.Add: (ast.Sub,),
    ast.Sub: (ast.Add,),
    ast.Mult: (ast.Div,),
    ast.Div: (ast.Mult,),
    ast.FloorDiv: (ast.Div,),
    ast.Mod: (ast.Mult,),
    ast.Pow: (ast.Mult,),
    ast.BitOr: (ast.BitAnd,),
    ast.BitAnd: (ast.BitOr,),
}
COMPARISON: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
}
PAIRS = (
    *(
        ("sin", "cos"),
        ("sinh", "cosh"),
        ("asin", "acos"),
        ("arcsin", "arccos"),
        ("real", "imag"),
        ("re", "im"),
    ),
    *(("min", "max"), ("minimum", "maximum"), ("argmin", "argmax"), ("floor", "ceil"), ("any", "all")),
    *(("zeros", "ones"), ("vstack", "hstack"), ("hypot", "arctan2"), ("diff", "cumsum"), ("sum", "prod")),
    *(("amplitude", "omega"), ("period", "frequency"), ("append", "remove")),
)
FUNCTIONS = {"tan": "sin", "tanh": "sinh", **dict(PAIRS), **{other: one for one, other in PAIRS}}
WRAPPERS = frozenset(
    [
        "abs",
        "sqrt",
        "conj",
        "conjugate",
        "real",
        "imag",
        "sorted",
        "reversed",
        "exp",
        "log",
        "log1p",
        "expm1",
        "round",
        "floor",
        "ceil",
        "sign",
        "unwrap",
        "radians",
        "degrees",
        "transpose",
        "cumsum",
        "diff",
        "simplify",
        "expand",
        "factor",
        "cancel",
        "together",
        "trigsimp",
        "unique",
        "fabs",
        "flip",
        "sum",
        "mean",
    ]
)
"""Functions of one argument that can be left out without an error at once."""
UNORDERED = frozenset(
    [
        *("range", "min", "max", "hypot", "isclose", "zip", "map", "next", "filter", "print", "brentq"),
        *("minimum", "maximum", "fmin", "fmax", "allclose", "array_equal", "logical_and", "logical_or"),
        "union1d",
    ]
)
"""Functions whose arguments, when swapped, give the same or an error at once."""
CONFIRMING = frozenset(["close", "equal", "same"])
"""Confirmations of the report: first their words, then two ways to one thing, in whatever order."""


def changes(node: ast.AST, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    """Yield the ways to change a node itself: the kind, and what stands in its place.

    Args:
        node: From ``live_nodes``.
        outer: The nodes that it stands in.
    """
    way = WAYS.get(type(node))
    if way is not None:
        yield from way(node, outer)


def _operation(node: ast.BinOp | ast.AugAssign, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    if isinstance(node, ast.BinOp) and any(_is_text(side) for side in (node.left, node.right)):
        return
    if isinstance(node.op, ast.BitOr) and _is_type(node):
        return
    for other in ARITHMETIC.get(type(node.op), ()):
        yield Kind.ARITHMETIC, _with(node, op=other())
    if isinstance(node, ast.AugAssign):
        yield Kind.REMOVAL, ast.Pass()


def _comparison(node: ast.Compare, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    setting = any(is_setting_name(side) for side in (node.left, *node.comparators))
    for place, operator in enumerate(node.ops):
        boundary, *others = COMPARISON[type(operator)]
        for other in others if setting and others else (boundary, *others):
            yield Kind.COMPARISON, _with(node, ops=[*node.ops[:place], other(), *node.ops[place + 1 :]])


def _constant(node: ast.Constant, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    value = node.value
    if (kind := _setting_kind(outer)) is not None:
        for other in _other_values(node):
            yield kind, other
    elif isinstance(value, bool):
        yield Kind.CONSTANT, ast.Constant(not value)
    elif isinstance(value, int | float) and not is_extreme(value):
        kind = Kind.INDEX if _is_index(outer) else Kind.CONSTANT
        yield kind, ast.Constant(value + 1)
        negative = bool(outer) and isinstance(outer[-1], ast.UnaryOp)
        if kind is Kind.INDEX and value > 0:
            yield kind, ast.Constant(value - 1)
        elif value and not negative:
            yield kind, ast.UnaryOp(ast.USub(), ast.Constant(value))
        if value and kind is Kind.CONSTANT:
            yield kind, ast.Constant(type(value)(0))


def _setting_kind(outer: Outer) -> Kind | None:
    """Return what a number is if it stands as a default, or as a setting in a call."""
    match outer[-1] if outer else None:
        case ast.arguments():
            return Kind.DEFAULT
        case ast.keyword(arg=str(name)) if is_setting_word(name):
            return Kind.SETTING
    return None


def _sign(node: ast.UnaryOp, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    if isinstance(node.op, ast.USub | ast.Not | ast.Invert):
        yield Kind.SIGN, node.operand


def _logic(node: ast.BoolOp, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    yield Kind.LOGIC, _with(node, op=ast.Or() if isinstance(node.op, ast.And) else ast.And())


def _condition(node: ast.IfExp, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    yield Kind.LOGIC, _with(node, body=node.orelse, orelse=node.body)


def _statement(node: ast.stmt, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    yield Kind.REMOVAL, ast.Pass()


def _expression(node: ast.Expr, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    if isinstance(node.value, ast.Call | ast.Yield | ast.YieldFrom):
        yield Kind.REMOVAL, ast.Pass()


def _assignment(node: ast.Assign | ast.AnnAssign, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
    stored = all(isinstance(target, ast.Attribute | ast.Subscript) for target in targets)
    if stored or _is_given_again(targets, node, outer):
        yield Kind.REMOVAL, ast.Pass()
    elif node.value is not None and is_setting(node, outer[-1]):
        for other in _other_values(node.value):
            yield Kind.SETTING, _with(node, value=other)


def _is_given_again(targets: list[ast.expr], node: ast.stmt, outer: Outer) -> bool:
    """Say whether an assignment gives a local name another value, so that the code still runs without it."""
    function = next((each for each in reversed(outer) if isinstance(each, ast.FunctionDef)), None)
    if function is None or not all(isinstance(target, ast.Name) for target in targets):
        return False
    known = _local_names(function, node.lineno)
    return all(isinstance(target, ast.Name) and target.id in known for target in targets)


def _branch(node: ast.If, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    if not node.orelse:
        yield Kind.REMOVAL, ast.Pass()


def _call(node: ast.Call, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
    if name in FUNCTIONS and name not in ("real", "imag", "amplitude", "omega", "period", "frequency"):
        yield Kind.FUNCTION, _with(node, func=_renamed(node.func))
    yield from _keywords(node)
    plain = [argument for argument in node.args if not isinstance(argument, ast.Starred)]
    if len(plain) < len(node.args):
        return
    if len(plain) == 1 and name in WRAPPERS and not node.keywords:
        yield Kind.CALL, plain[0]
    for place in range(len(plain) - 1):
        first, second = plain[place : place + 2]
        if (
            name not in UNORDERED
            and not (name in CONFIRMING and place == 1)
            and not _differ_in_type(first, second)
            and ast.dump(first) != ast.dump(second)
        ):
            yield Kind.ARGUMENTS, _with(node, args=[*plain[:place], second, first, *plain[place + 2 :]])


def _keywords(node: ast.Call) -> Iterator[tuple[Kind, ast.AST]]:
    """Yield the call without each of its keywords, and with the values of neighbours swapped."""
    named = node.keywords
    for place, keyword in enumerate(named):
        if keyword.arg is not None and not is_look(keyword.arg):
            yield Kind.KEYWORD, _with(node, keywords=[*named[:place], *named[place + 1 :]])
    for first, second in pairwise(named):
        if first.arg is None or second.arg is None or is_look(first.arg) or is_look(second.arg):
            continue
        if not _differ_in_type(first.value, second.value) and ast.dump(first.value) != ast.dump(second.value):
            swapped = {
                id(first): ast.keyword(first.arg, second.value),
                id(second): ast.keyword(second.arg, first.value),
            }
            yield Kind.ARGUMENTS, _with(node, keywords=[swapped.get(id(each), each) for each in named])


def _other_values(value: ast.expr) -> Iterator[ast.expr]:
    """Yield other values of a default or setting: twice and half a number, or by orders if it is extreme."""
    if isinstance(value, ast.Constant) and isinstance(value.value, bool):
        yield ast.Constant(not value.value)
    elif is_plain_number(value) and not isinstance(value, ast.Constant | ast.UnaryOp):
        yield ast.BinOp(value, ast.Mult(), ast.Constant(1000))
        yield ast.BinOp(value, ast.Div(), ast.Constant(1000))
    elif isinstance(number := getattr(value, "value", None), int | float) and number:
        factor = 1000 if is_extreme(number) else 2
        for other in (number * factor, number / factor):
            yield ast.Constant(int(other) if isinstance(number, int) else float(f"{other:.12g}"))


def _attribute(node: ast.Attribute, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    called = bool(outer) and isinstance(outer[-1], ast.Call) and outer[-1].func is node
    if node.attr in FUNCTIONS and not called and isinstance(node.ctx, ast.Load):
        yield Kind.FUNCTION, _renamed(node)


def _return(node: ast.Return, outer: Outer) -> Iterator[tuple[Kind, ast.AST]]:
    """Yield the return of each other local name in place of the first one that is returned."""
    function = next((each for each in reversed(outer) if isinstance(each, ast.FunctionDef)), None)
    used = [each for each in ast.walk(node) if isinstance(each, ast.Name)] if node.value else []
    if function is None or isinstance(node.value, ast.Constant | None):
        if node.value is None or any(isinstance(each, ast.If) for each in outer[-1:]):
            yield Kind.REMOVAL, ast.Pass()
        return
    local = _local_names(function, node.lineno)
    for name in used:
        if name.id in local:
            for other in sorted(local - {name.id, "self", "cls"}):
                yield Kind.RETURN, _replaced(node, name, ast.Name(other, ast.Load()))
            return


def _local_names(function: ast.FunctionDef, before: int) -> set[str]:
    arguments = {
        each.arg for each in (*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs)
    }
    stored = (
        each for each in ast.walk(function) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)
    )
    return arguments | {each.id for each in stored if each.lineno < before}


def _replaced(node: ast.Return, old: ast.Name, new: ast.Name) -> ast.AST:
    class Change(ast.NodeTransformer):
        def visit_Name(self, name: ast.Name) -> ast.AST:
            same = (name.lineno, name.col_offset) == (old.lineno, old.col_offset)
            return new if same else name

    return Change().visit(deepcopy(node))


def _renamed(node: ast.expr) -> ast.expr:
    if isinstance(node, ast.Attribute):
        return _with(node, attr=FUNCTIONS[node.attr])
    assert isinstance(node, ast.Name)
    return ast.Name(FUNCTIONS[node.id], ast.Load())


def _with(node: ast.AST, **fields: object) -> ast.AST:
    changed = deepcopy(node)
    for name, value in fields.items():
        setattr(changed, name, value)
    return changed


def _differ_in_type(first: ast.expr, second: ast.expr) -> bool:
    """Say whether one of two arguments is a text, a function or a generator, so that a swap fails at once."""
    return any(_is_text(each) or isinstance(each, ast.Lambda | ast.GeneratorExp) for each in (first, second))


def _is_index(outer: Outer) -> bool:
    inner = [each for each in outer[-3:] if not isinstance(each, ast.UnaryOp | ast.Tuple | ast.Slice)]
    return bool(inner) and isinstance(inner[-1], ast.Subscript)


def _is_text(node: ast.AST) -> bool:
    return isinstance(node, ast.JoinedStr) or isinstance(getattr(node, "value", None), str | bytes)


def _is_type(node: ast.BinOp) -> bool:
    names = [each for each in ast.walk(node) if isinstance(each, ast.Name)]
    return any(each.id in ("int", "float", "str", "bool", "bytes", "complex") for each in names) or all(
        each.id[:1].isupper() and not each.id.isupper() for each in names
    )


Way = Callable[..., Iterator[tuple[Kind, ast.AST]]]
WAYS: dict[type[ast.AST], Way] = {
    ast.BinOp: _operation,
    ast.AugAssign: _operation,
    ast.Compare: _comparison,
    ast.Constant: _constant,
    ast.UnaryOp: _sign,
    ast.BoolOp: _logic,
    ast.IfExp: _condition,
    ast.Raise: _statement,
    ast.Continue: _statement,
    ast.Break: _statement,
    ast.Expr: _expression,
    ast.Assign: _assignment,
    ast.AnnAssign: _assignment,
    ast.If: _branch,
    ast.Delete: _statement,
    ast.Call: _call,
    ast.Attribute: _attribute,
    ast.Return: _return,
}
