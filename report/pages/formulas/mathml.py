"""Repairs of pandoc's MathML where browsers set it badly."""

import re
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

_NAMESPACE = "http://www.w3.org/1998/Math/MathML"
_MATH = re.compile(r"<math .*?</math>", re.DOTALL)
_SPACING_ACCENTS = {
    "\u0307": "\u02d9",
    "\u0308": "\u00a8",
    "\u0302": "\u02c6",
    "\u0303": "\u02dc",
    "\u203e": "\u00af",
}
"""Combining dots, hat, tilde and the overline of one letter, as the characters browsers place above it."""
_TALL = frozenset(
    f"{{{_NAMESPACE}}}{name}"
    for name in ("mfrac", "mtable", "munder", "mover", "munderover", "msqrt", "mroot")
)
_ROWS = frozenset(f"{{{_NAMESPACE}}}{name}" for name in ("mrow", "mtd", "msqrt"))
_SCRIPTED = frozenset(f"{{{_NAMESPACE}}}{name}" for name in ("msup", "msub", "msubsup"))
_APPLICATION = "\u2061"
_THIN_SPACE = "0.167em"


def repaired(html: str) -> str:
    """Return HTML with each formula in it repaired.

    - Accents are said to be accents and are spacing characters, so that browsers place them close above.
    - Brackets around content of ordinary height do not stretch; a subscript would enlarge them.
    - Functions keep a thin space from what stands before them.
    - Cells are aligned by the style sheet: an alignment in the cell has no effect on mathematics in Chromium.
    - Fractions in aligned lines have the size they have in a single line.
    """
    ElementTree.register_namespace("", _NAMESPACE)
    return _MATH.sub(lambda match: _repaired_formula(match.group()), html)


def _repaired_formula(source: str) -> str:
    root = ElementTree.fromstring(source)
    for accented in root.iter(_tag("mover")):
        _place_accent(accented)
    for table in root.iter(_tag("mtable")):
        _leave_alignment_to_style(table)
    for element in list(root.iter()):
        if element.tag == _tag("mrow") and not any(_is_tall(inner) for inner in element.iter()):
            _keep_brackets_flat(element)
        if element.tag in _ROWS:
            _space_functions(element)
    return ElementTree.tostring(root, encoding="unicode")


def _place_accent(accented: Element) -> None:
    letter, mark = accented
    if mark.get("accent") != "true":
        return
    del mark.attrib["accent"]
    accented.set("accent", "true")
    if letter.tag == _tag("mi"):
        mark.set("stretchy", "false")
        mark.text = _SPACING_ACCENTS.get(mark.text or "", mark.text)


def _leave_alignment_to_style(table: Element) -> None:
    cells = list(table.iter(_tag("mtd")))
    for cell in cells:
        cell.attrib.pop("style", None)
    if any(cell.get("columnalign") == "right" for cell in cells):
        table.set("displaystyle", "true")
        table.set("class", "aligned")


def _keep_brackets_flat(row: Element) -> None:
    for operator in row.findall(_tag("mo")):
        if operator.get("stretchy") == "true":
            operator.set("stretchy", "false")


def _space_functions(row: Element) -> None:
    """Put a thin space before a function that follows an operand, and after one without a bracket."""
    children = list(row)
    for before, child, after in zip([None, *children], children, [*children[1:], None], strict=False):
        if not _is_function(child):
            continue
        position = list(row).index(child)
        if after is not None and not _is_bracketed(after):
            row.insert(position + 1, _thin_space())
        if before is not None and _is_operand(before):
            row.insert(position, _thin_space())


def _is_function(element: Element) -> bool:
    if element.tag in _SCRIPTED:
        return _is_function(element[0])
    return element.tag == _tag("mrow") and len(element) > 0 and element[-1].text == _APPLICATION


def _is_operand(element: Element) -> bool:
    if element.tag == _tag("mo"):
        return element.get("form") == "postfix"
    return element.tag != _tag("mspace") and not _is_function(element)


def _is_bracketed(element: Element) -> bool:
    while element.tag == _tag("mrow") and len(element):
        element = element[0]
    return element.tag == _tag("mo")


def _is_tall(element: Element) -> bool:
    """Say whether an element makes its row higher than a line; an accent over a letter does not."""
    if element.tag == _tag("mover") and element.get("accent") == "true":
        return False
    return element.tag in _TALL


def _thin_space() -> Element:
    return Element(_tag("mspace"), width=_THIN_SPACE)


def _tag(name: str) -> str:
    return f"{{{_NAMESPACE}}}{name}"
