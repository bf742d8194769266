"""Functions of loaded modules get their changed code, so that nothing need be imported anew."""

import ast
import gc
import importlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

from scripts.mutation.mutants import Mutant


@dataclass(frozen=True)
class Patch:
    """The changed code of a function that stands in a module or class."""

    path: str  # Of its source from the project's folder
    name: str  # Of the function
    line: int  # First line of the function, from 1, that of its first decorator if it has one
    source: str  # The whole changed source

    def apply(self, root: Path) -> bool:
        """Give all functions that were made of this one the changed code; False if none can have it."""
        importlib.import_module(self.path.removesuffix(".py").removesuffix("/__init__").replace("/", "."))
        place = str(root / self.path)
        changed = _code(compile(self.source, place, "exec"), self.name, self.line)
        gc.unfreeze()
        found = [each for each in gc.get_objects() if type(each) is FunctionType and self._is_of(each, place)]
        if any(each.__code__.co_freevars != changed.co_freevars for each in found):
            return False
        for function in found:
            function.__code__ = changed
        return bool(found)

    def _is_of(self, function: FunctionType, place: str) -> bool:
        code = function.__code__
        return (code.co_filename, code.co_name, code.co_firstlineno) == (place, self.name, self.line)


def patch_of(mutant: Mutant, content: bytes) -> Patch | None:
    """Return a change as the changed code of a function; None if it is not inside the body of one.

    Args:
        mutant: The change.
        content: Of the source that it was made for.
    """
    source = mutant.text(content).decode()
    pairs = zip(_outermost(ast.parse(content)), _outermost(ast.parse(source)), strict=False)
    for before, after in pairs:
        if before.lineno <= mutant.line <= (before.end_lineno or 0):
            heads = [ast.dump(_without_body(each)) for each in (before, after)]
            return (
                Patch(mutant.path, before.name, _first_line(before), source) if len({*heads}) == 1 else None
            )
    return None


def with_patch(patch: Patch | None, work: Callable[..., Any], *arguments: Any) -> Any:
    """Do some work with a change in force; None if it could not be brought into force."""
    if patch is not None and not patch.apply(Path.cwd()):
        return None
    return work(*arguments)


def _outermost(node: ast.AST) -> Iterator[ast.FunctionDef]:
    """Yield the functions that stand in a module or its classes, in their order."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.FunctionDef):
            yield child
        elif isinstance(child, ast.ClassDef | ast.If | ast.Try | ast.With):
            yield from _outermost(child)


def _without_body(function: ast.FunctionDef) -> ast.FunctionDef:
    return ast.FunctionDef(function.name, function.args, [], function.decorator_list, function.returns)


def _first_line(function: ast.FunctionDef) -> int:
    return min([function.lineno, *(each.lineno for each in function.decorator_list)])


def _code(code: CodeType, name: str, line: int) -> CodeType:
    """Return the code of the function that begins at a line."""
    waiting = [code]
    for each in waiting:
        if (each.co_name, each.co_firstlineno) == (name, line):
            return each
        waiting += [inner for inner in each.co_consts if isinstance(inner, CodeType)]
    raise LookupError(f"no function {name} begins at line {line}")
