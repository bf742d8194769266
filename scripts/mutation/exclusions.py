"""What is not drawn: code whose change is no change of the mathematics."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

EXCLUDED = (
    "docstrings, annotations, decorators, overloads, assertions, `__all__`, `if TYPE_CHECKING`, `__repr__`, "
    "`__str__`",
    "the wording of errors and warnings (but not whether they are raised)",
    "strings",
    "numbers of 1e-5 and less within formulas; and whether a setting is included in a comparison",
    "looks of pictures: line widths, sizes, colours; and in the report what only draws",
    "what the report transcribes from the thesis: printed formulas and digits",
    "trimmer/generated, which a test derives again",
)
"""In words, for the summary."""
FOLDERS = ("trimmer/generated/", "report/pages/drawing/", "report/twin/figures/", "report/design/figures/")
DRAWINGS = "figures"
"""Folder or file of a chapter in which pictures are drawn."""
SHOWN = ("text", "note", "set_title", "set_xlabel", "set_ylabel", "suptitle", "grid", "legend", "annotate")
"""Calls that only say or show something."""
TRANSCRIBING = ("digits", "assertion", "expression", "matrix")
"""Functions of a claim's parts whose second argument is what the thesis prints."""
PRINTED = ("__repr__", "__str__", "_repr_html_", "__all__")
SETTING = re.compile(
    r"tol|iteration|points|samples|limit|most|steps|block|chunk|digits|worker|bins|patience", re.IGNORECASE
)
"""Names of numbers on which it rests how well something is solved."""
LOOK = re.compile(
    r"width|height|size|alpha|zorder|pad|color|colour|marker|label|linestyle|lw|dpi|strict|frozen|encoding|"
    r"stacklevel|maxsize|indent",
    re.IGNORECASE,
)
SMALL, LARGE = 1e-5, 1e5
SPECIAL = ("isinstance", "cast", "TypeVar", "field", "getattr", "hasattr", "warn", "NewType", "partial")
"""Calls that are left alone: their change either fails at once or changes nothing."""


def is_left_out(path: str) -> bool:
    """Say whether a source is left alone as a whole."""
    drawn = path.startswith("report/chapters/") and DRAWINGS in path.removesuffix(".py").split("/")
    return drawn or path.startswith(FOLDERS)


def live_nodes(tree: ast.Module) -> Iterator[tuple[ast.AST, tuple[ast.AST, ...]]]:
    """Yield each node that may be changed, with the nodes that it stands in, from the module inwards."""
    yield from _live(tree, ())


def _live(node: ast.AST, outer: tuple[ast.AST, ...]) -> Iterator[tuple[ast.AST, tuple[ast.AST, ...]]]:
    yield node, outer
    if isinstance(node, ast.Assign | ast.AnnAssign) and is_setting(node, outer[-1]):
        return  # It is changed as a whole.
    for child in _living_children(node):
        yield from _live(child, (*outer, node))


def _living_children(node: ast.AST) -> Iterator[ast.AST]:
    if isinstance(node, ast.arguments):
        yield from _living_defaults(node)
        return
    for name, value in ast.iter_fields(node):
        if name in (
            "annotation",
            "returns",
            "decorator_list",
            "type_comment",
            "type_params",
            "bases",
            "format_spec",
        ):
            continue
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST) and not is_dead(child, node):
                yield child


def _living_defaults(node: ast.arguments) -> Iterator[ast.AST]:
    positional = [*node.posonlyargs, *node.args]
    pairs = zip(
        [*positional[len(positional) - len(node.defaults) :], *node.kwonlyargs],
        [*node.defaults, *node.kw_defaults],
        strict=True,
    )
    for argument, default in pairs:
        if default is not None and not (LOOK.search(argument.arg) and is_plain_number(default)):
            yield default


def is_dead(node: ast.AST, parent: ast.AST) -> bool:
    """Say whether a part of a node is left alone with all that is in it."""
    match node:
        case ast.Assert() | ast.Import() | ast.ImportFrom() | ast.JoinedStr():
            return True
        case ast.Expr(value=ast.Constant()):
            return True
        case ast.Expr(value=ast.Call() as call) | ast.Expr(value=ast.Yield(value=ast.Call() as call)):
            return _says(call)
        case ast.FunctionDef(name=name) if name in PRINTED:
            return True
        case ast.FunctionDef(decorator_list=[ast.Name(id="overload")]):
            return True
        case ast.If(test=test) if _named(test) in ("TYPE_CHECKING", "__name__"):
            return True
        case ast.Call() if isinstance(parent, ast.Raise) or _named(node.func) in SPECIAL:
            return True
        case ast.keyword(arg=str(name)) if LOOK.search(name):
            return True
        case ast.Assign() | ast.AnnAssign():
            return _is_look(node)
    return _is_transcribed(node, parent)


def _is_look(node: ast.Assign | ast.AnnAssign) -> bool:
    """Say whether an assignment gives a name its type only, or something its looks."""
    name = _named(node.targets[0] if isinstance(node, ast.Assign) else node.target)
    return node.value is None or name in PRINTED or is_look(name)


def _says(call: ast.Call) -> bool:
    """Say whether a statement's call, or that whose result is given its numbers, only says something."""
    inner = call.func.value if isinstance(call.func, ast.Attribute) and call.func.attr == "given" else call
    return isinstance(inner, ast.Call) and _named(inner.func) in SHOWN


def _is_transcribed(node: ast.AST, parent: ast.AST) -> bool:
    """Say whether a node is what a claim holds against its own derivation."""
    return (
        isinstance(parent, ast.Call)
        and _named(parent.func) in TRANSCRIBING
        and len(parent.args) > 1
        and node is parent.args[1]
    )


def is_setting(node: ast.Assign | ast.AnnAssign, parent: ast.AST) -> bool:
    """Say whether an assignment gives a setting its number."""
    target = node.targets[0] if isinstance(node, ast.Assign) else node.target
    name, value = _named(target), node.value
    if value is None or not is_plain_number(value):
        return False
    return bool(SETTING.search(name)) or (isinstance(parent, ast.Module) and name.isupper())


def is_setting_word(name: str) -> bool:
    """Say whether an argument of this name says how well something is solved."""
    return bool(SETTING.search(name))


def is_look(name: str) -> bool:
    """Say whether an argument of this name has to do with how something looks."""
    return bool(LOOK.search(name))


def is_plain_number(value: ast.AST) -> bool:
    """Say whether an expression is made of nothing but numbers."""
    parts = (ast.Constant, ast.BinOp, ast.UnaryOp, ast.operator, ast.unaryop)
    if isinstance(value, ast.Attribute | ast.Call):  # 64 * np.finfo(float).eps
        return "finfo" in ast.unparse(value)
    if isinstance(value, ast.BinOp):
        return is_plain_number(value.left) and is_plain_number(value.right)
    return all(isinstance(part, parts) for part in ast.walk(value))


def is_setting_name(node: ast.AST) -> bool:
    """Say whether a side of a comparison is a setting: a name in capitals, or a small number."""
    named = any(_named(part).isupper() and len(_named(part)) > 1 for part in ast.walk(node))
    return named or any(isinstance(part, ast.Constant) and is_extreme(part.value) for part in ast.walk(node))


def is_extreme(value: object) -> bool:
    """Say whether a number is so small or large that it is a tolerance or a limit."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return value != 0 and not SMALL < abs(value) < LARGE


def _named(node: ast.AST) -> str:
    return getattr(
        node,
        "attr",
        getattr(node, "id", getattr(node.left, "id", "") if isinstance(node, ast.Compare) else ""),
    )
