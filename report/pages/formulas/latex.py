"""Reading LaTeX as a row of atoms with estimated widths, in em; nothing here is exact typesetting."""

from __future__ import annotations

import functools
import itertools
import re
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, auto

_COMMAND = re.compile(r"\\[A-Za-z]+\*?")
_TOKEN = re.compile(r"\\text\{[^{}]*\}|\\[A-Za-z]+\*?|\\.|\S", re.DOTALL)
_RELATIONS = frozenset(
    ("=", "<", ">", r"\leq", r"\geq", r"\le", r"\ge", r"\neq", r"\approx", r"\equiv", r"\to")
)
_SIGNS = frozenset(("+", "-", r"\pm", r"\mp"))
_SPACES = {r"\,": 0.17, r"\:": 0.22, r"\;": 0.28, r"\ ": 0.3, r"\quad": 1.0, r"\qquad": 2.0, r"\!": -0.17}
_WIDE = {r"\sum": 1.4, r"\int": 0.9, r"\infty": 0.9, r"\cdot": 0.7, r"\times": 1.2, "m": 0.85, "M": 0.95}
_WITHOUT_WIDTH = frozenset((r"\limits", r"\displaystyle", r"\big", r"\Big", r"\bigl", r"\bigr"))
_ACCENTS = frozenset(
    (r"\dot", r"\ddot", r"\hat", r"\bar", r"\tilde", r"\vec", r"\overline", r"\mathbf", r"\mathrm")
)
_TEXTS = frozenset((r"\operatorname", r"\operatorname*", r"\mathit"))
_RELATION_WIDTH, _SIGN_WIDTH, _LETTER_WIDTH, _DIGIT_WIDTH, _TEXT_WIDTH = 1.35, 1.25, 0.58, 0.5, 0.47
_RADICAL_WIDTH, _DELIMITERS_WIDTH, _COLUMN_GAP = 0.9, 0.9, 0.6
_SCRIPT_SCALE, _CELL_FRACTION_SCALE = 0.75, 0.72


class Role(Enum):
    """What an atom means to somebody who looks for a place to break the line."""

    ORDINARY = auto()
    RELATION = auto()
    SIGN = auto()


@dataclass(frozen=True)
class Atom:
    """A piece of a formula that stays together.

    ``inside`` is what stands between round brackets that stretch, empty for all else; ``scripts`` is the part
    of ``latex`` that is its sub- and superscripts; ``width`` is in em.
    """

    latex: str
    width: float
    role: Role = Role.ORDINARY
    inside: tuple[Atom, ...] = ()
    scripts: str = ""


@functools.lru_cache(maxsize=10_000)
def atoms(latex: str) -> tuple[Atom, ...]:
    """Split LaTeX into atoms: symbols with their scripts, fractions, bracketed groups, environments."""
    return tuple(_atoms(_Tokens(_TOKEN.findall(latex))))


def width(latex: str) -> float:
    """Estimate the width of LaTeX set as a formula, in em."""
    return sum(atom.width for atom in atoms(latex))


class _Tokens:
    """A list of tokens that is read from the front."""

    def __init__(self, tokens: list[str]) -> None:
        self._tokens = tokens
        self._position = 0

    def peek(self) -> str:
        return self._tokens[self._position] if self._position < len(self._tokens) else ""

    def take(self) -> str:
        token = self.peek()
        self._position += 1
        return token

    def rest(self) -> str:
        """Return what has not been taken."""
        return _joined(self._tokens[self._position :])

    def argument(self) -> str:
        """Take one argument: a group without its braces, or a single token."""
        return self.until("{", "}") if self.peek() == "{" else self.take()

    def until(self, opening: str, closing: str) -> str:
        """Take from an opening token to the closing one that matches it; return what is between."""
        return _joined(self.between(opening, closing))

    def between(self, opening: str, closing: str) -> list[str]:
        """Do the same; return the tokens."""
        taken = [self.take()]
        depth = 1
        while depth and self.peek():
            taken.append(self.take())
            depth += (taken[-1] == opening) - (taken[-1] == closing)
        return taken[1:-1]


def _joined(tokens: list[str]) -> str:
    """Join tokens again; a command and a letter after it need a space between them."""
    return "".join(
        f"{token} " if _COMMAND.fullmatch(token) and after[:1].isalpha() else token
        for token, after in itertools.zip_longest(tokens, tokens[1:], fillvalue="")
    )


def _atoms(tokens: _Tokens) -> Iterator[Atom]:
    while tokens.peek():
        yield _with_scripts(_atom(tokens), tokens)


def _atom(tokens: _Tokens) -> Atom:
    token = tokens.peek()
    if token == "{":
        content = tokens.until("{", "}")
        return Atom(f"{{{content}}}", width(content))
    if token == r"\left":
        return _bracketed(tokens)
    if token == r"\begin":
        return _environment(tokens)
    tokens.take()
    if token in _RELATIONS:
        return Atom(token, _RELATION_WIDTH, Role.RELATION)
    if token in _SIGNS:
        return Atom(token, _SIGN_WIDTH, Role.SIGN)
    return _command(token, tokens)


def _command(token: str, tokens: _Tokens) -> Atom:
    if token in (r"\frac", r"\dfrac", r"\tfrac"):
        above, below = tokens.argument(), tokens.argument()
        return Atom(f"{token}{{{above}}}{{{below}}}", max(width(above), width(below)) + 0.25)
    if token == r"\sqrt":
        index = f"[{tokens.until('[', ']')}]" if tokens.peek() == "[" else ""
        content = tokens.argument()
        return Atom(f"{token}{index}{{{content}}}", width(content) + _RADICAL_WIDTH)
    if token in _ACCENTS:
        content = tokens.argument()
        return Atom(f"{token}{{{content}}}", width(content))
    if token in _TEXTS:
        content = tokens.argument()
        return Atom(f"{token}{{{content}}}", len(content) * _TEXT_WIDTH + 0.2)
    return Atom(token, _symbol_width(token))


def _symbol_width(token: str) -> float:
    if token in _SPACES or token in _WIDE:
        return _SPACES.get(token, 0.0) + _WIDE.get(token, 0.0)
    if token in _WITHOUT_WIDTH:
        return 0.0
    if token.startswith(r"\text{"):
        return (len(token) - len(r"\text{}")) * _TEXT_WIDTH + 0.2
    if token.isdigit():
        return _DIGIT_WIDTH
    if re.fullmatch(r"\\(a?(sin|cos|tan|cot|sec)h?|arc\w+|log|ln|exp|det|max|min|arg|lim|sup|inf)", token):
        return (len(token) - 1) * _TEXT_WIDTH + 0.2
    return _LETTER_WIDTH


def _bracketed(tokens: _Tokens) -> Atom:
    """Read a pair of stretching brackets as one atom that remembers what is inside."""
    opening, *inside = tokens.between(r"\left", r"\right")
    closing = tokens.take()
    content = _joined(inside)
    return Atom(
        rf"\left{opening}{content} \right{closing}",
        width(content) + _DELIMITERS_WIDTH,
        inside=atoms(content) if (opening, closing) == ("(", ")") else (),
    )


def _environment(tokens: _Tokens) -> Atom:
    inside = _Tokens(tokens.between(r"\begin", r"\end"))
    tokens.argument()
    name = inside.argument()
    options = f"{{{inside.argument()}}}" if name == "array" else ""
    content = inside.rest()
    return Atom(rf"\begin{{{name}}}{options}{content}\end{{{name}}}", _table_width(content))


def _table_width(content: str) -> float:
    """Estimate the width of the rows and cells of a table; around a nested table, cells run together."""
    if r"\begin" in content:
        return max(width(line.replace("&", " ")) for line in content.split(r"\\")) + _DELIMITERS_WIDTH
    rows = [[_cell_width(cell) for cell in row.split("&")] for row in content.split(r"\\")]
    columns = max(len(row) for row in rows)
    widest = [max(row[column] for row in rows if column < len(row)) for column in range(columns)]
    return sum(widest) + _COLUMN_GAP * (columns - 1) + _DELIMITERS_WIDTH


def _cell_width(cell: str) -> float:
    """Estimate the width of a cell; fractions in it are set small."""
    return width(cell) * (_CELL_FRACTION_SCALE if r"\frac" in cell else 1.0)


def _with_scripts(atom: Atom, tokens: _Tokens) -> Atom:
    scripts, widest = "", 0.0
    while tokens.peek() in ("^", "_", "'"):
        mark = tokens.take()
        if mark == "'":
            scripts, widest = scripts + mark, max(widest, 0.3)
            continue
        content = tokens.argument()
        scripts, widest = f"{scripts}{mark}{{{content}}}", max(widest, width(content) * _SCRIPT_SCALE)
    if not scripts:
        return atom
    return Atom(atom.latex + scripts, atom.width + widest, atom.role, atom.inside, scripts)
