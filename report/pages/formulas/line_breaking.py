"""Breaking of formulas that are too long for a line, at the signs of their sums."""

from report.pages.formulas.latex import Atom, Role, atoms

_OPENING = Atom("(", 0.4)
_INDENT = 2.0
_OWN_LINE_SHARE = 0.4


def fit(latex: str, line: float) -> str:
    """Break a formula over aligned lines if it is wider than a line.

    Lines start with a plus, a minus or a relation. A bracketed sum that is wider than a line is opened, so
    that it can break inside. What cannot be broken (a fraction, a matrix) is left as it is.

    Args:
        latex: the formula.
        line: width of a line, in em.

    Returns:
        The same formula, or an ``aligned`` environment.
    """
    left, rest = _sides(atoms(latex))
    indent = _width(left) if _width(left) <= _OWN_LINE_SHARE * line else _INDENT
    lines = _filled(_narrowed(rest, line - indent), line - indent)
    if len(lines) == 1:
        return latex
    return _aligned(_text(left), lines, own_line=_width(left) > _OWN_LINE_SHARE * line)


def _sides(row: tuple[Atom, ...]) -> tuple[tuple[Atom, ...], tuple[Atom, ...]]:
    """Part a formula before its first relation; without a relation all of it is the right side."""
    for position, atom in enumerate(row):
        if atom.role is Role.RELATION and position:
            return row[:position], row[position:]
    return (), row


def _narrowed(row: tuple[Atom, ...], line: float) -> list[tuple[Atom, ...]]:
    """Cut a row into terms; open the widest bracketed sum of each that would not fit, and cut that too."""
    cut = _terms(row)
    narrow = [cut[0]] if _fits(cut[0], line) else _opened(cut[0], line)
    for term in cut[1:]:
        narrow += [term] if _fits(term, line - _INDENT) else _opened(term, line)
    return narrow


def _fits(term: tuple[Atom, ...], room: float) -> bool:
    """Say whether a term fits, or has nothing to open."""
    return _width(term) <= room or not any(atom.inside for atom in term)


def _opened(term: tuple[Atom, ...], line: float) -> list[tuple[Atom, ...]]:
    """Replace the widest bracketed sum of a term by its bracket, its atoms and its bracket."""
    place = max((place for place, atom in enumerate(term) if atom.inside), key=lambda at: term[at].width)
    atom = term[place]
    closing = Atom(f"){atom.scripts}", 0.4)
    return _narrowed((*term[:place], _OPENING, *atom.inside, closing, *term[place + 1 :]), line)


def _terms(row: tuple[Atom, ...]) -> list[tuple[Atom, ...]]:
    """Cut a row before each relation and each sign that joins two terms."""
    terms: list[list[Atom]] = [[]]
    for position, atom in enumerate(row):
        before = row[position - 1] if position else None
        joins = before is not None and before.role is Role.ORDINARY and before is not _OPENING
        if atom.role is Role.RELATION or (atom.role is Role.SIGN and joins):
            terms.append([])
        terms[-1].append(atom)
    return [tuple(term) for term in terms if term]


def _filled(terms: list[tuple[Atom, ...]], line: float) -> list[tuple[Atom, ...]]:
    """Put as many terms on each line as fit; the first line is not indented."""
    lines: list[tuple[Atom, ...]] = []
    for term in terms:
        room = line if len(lines) <= 1 else line - _INDENT
        if lines and _width(lines[-1]) + _width(term) <= room:
            lines[-1] = (*lines[-1], *term)
        else:
            lines.append(term)
    return lines


def _aligned(left: str, lines: list[tuple[Atom, ...]], *, own_line: bool) -> str:
    first, *others = [_text(line) for line in lines]
    starts = [line[0].role is Role.RELATION for line in lines[1:]]
    head = [f"& {left}", rf"& \quad {first}"] if left and own_line else [f"{left} & {first}"]
    tail = [
        f"& {text}" if relation and not own_line else rf"& \quad {text}"
        for text, relation in zip(others, starts, strict=True)
    ]
    rows = r" \\ ".join([*head, *tail])
    return rf"\begin{{aligned}} {rows} \end{{aligned}}"


def _width(row: tuple[Atom, ...]) -> float:
    return sum(atom.width for atom in row)


def _text(row: tuple[Atom, ...]) -> str:
    return " ".join(atom.latex for atom in row)
