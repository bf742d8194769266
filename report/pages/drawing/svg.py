"""Matplotlib figure to SVG text that can stand inside a page."""

import io
import re
from xml.sax.saxutils import escape, quoteattr

from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter

from report.pages.drawing.letters import letter_panels
from report.pages.drawing.placed import name_parts
from report.pages.drawing.read_out import read_out
from report.pages.drawing.style import style
from trimmer.drawing.content import unwarned

_METADATA = re.compile(r"\s*<metadata>.*?</metadata>", re.DOTALL)
_OPENING = re.compile(r"<svg\b[^>]*>", re.DOTALL)
_STYLE = re.compile(r"\s*<defs>\s*<style.*?</style>\s*</defs>", re.DOTALL)
_MATHEMATICS = re.compile(r"^\$\\mathdefault\{(.*)\}\$$")
_PLACED = re.compile(r'(?<=\s)(?:d|x|y|points)="[^"]*"')
_LONG = re.compile(r"-?\d+\.\d{3,}")
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_BETWEEN = re.compile(r">\s+<")
_REFERENCE = re.compile(r'(?P<before>\bid="|href="#|url\(#)')
_HASHED = re.compile(r'(?<=[#"])([A-Za-z]\w*?)[0-9a-f]{10}(?=["\)])')
"""An id with a hash in it: of a clipping box, a mark or a hatching."""
_LETTER = re.compile(r'(?<=[#"])STIXGeneral-([A-Za-z]+)-')
"""The font in the id of a letter's outline."""


def to_svg(figure: Figure, identifier: str, title: str, alternative_text: str) -> str:
    """Return a figure as an ``svg`` element; the same figure gives the same text in every process.

    It is drawn inside ``report.pages.drawing.style.style()``. All ids begin with the identifier, so that two
    figures in one page do not share one.
    """
    import matplotlib

    buffer = io.StringIO()
    with unwarned(), style(), matplotlib.rc_context({"svg.hashsalt": identifier}):
        letter_panels(figure)
        name_parts(figure)
        _write_ticks_plainly(figure)
        figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})
        axes = read_out(figure)
    document = buffer.getvalue()
    # The file's style would reach out of the figure; the page reads values off the axes given as data.
    svg = _STYLE.sub("", _METADATA.sub("", document[document.index("<svg") :])).strip()
    svg = _BETWEEN.sub("><", _COMMENT.sub("", _PLACED.sub(_rounded, svg))).replace(" \n", "")
    svg = _LETTER.sub(lambda font: re.sub("[a-z]", "", font[1]), _numbered(svg))
    svg = _REFERENCE.sub(lambda match: f"{match['before']}{identifier}-", svg)
    if axes:
        svg = svg.replace("<svg ", f"<svg data-axes={quoteattr(axes)} ", 1)
    return _described(svg, identifier, title, alternative_text)


def _rounded(attribute: re.Match[str]) -> str:
    """Write places to a hundredth of a point: more is not seen at any zoom, and costs a third of the size."""
    return _LONG.sub(
        lambda number: f"{round(float(number[0]), 2) + 0.0:.2f}".rstrip("0").rstrip("."), attribute[0]
    )


def _numbered(svg: str) -> str:
    """Write numbers for the hashes in ids: they are of all digits of a place, the last of which may differ.

    The layout adds up in the order in which its parts lie in memory.
    """
    numbers: dict[str, int] = {}
    return _HASHED.sub(lambda found: f"{found[1]}{numbers.setdefault(found[0], len(numbers) + 1)}", svg)


class _PlainTicks(ScalarFormatter):
    """Numbers at ticks without the mathematics around them; a power of ten beside the axis keeps it."""

    def __call__(self, x: float, pos: int | None = None) -> str:
        return _MATHEMATICS.sub(r"\1", super().__call__(x, pos))


def _write_ticks_plainly(figure: Figure) -> None:
    """Have numbers at linear axes set as text: as mathematics they take half of the time of a drawing."""
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            if type(axis.get_major_formatter()) is ScalarFormatter:
                axis.set_major_formatter(_PlainTicks())


def _described(svg: str, identifier: str, title: str, alternative_text: str) -> str:
    """Give the element a role, a title and a description."""
    opening = _OPENING.match(svg)
    if opening is None:
        raise ValueError(f"the drawing {identifier} is not an svg element")
    label = quoteattr(f"{identifier}-title {identifier}-description")
    described = (
        f'{opening[0][:-1]} stroke-linejoin="round" role="img" aria-labelledby={label}>'
        f'<title id="{identifier}-title">{escape(title)}</title>'
        f'<desc id="{identifier}-description">{escape(alternative_text)}</desc>'
    )
    return described + svg[opening.end() :]
