"""What the report's figures show: words and their places, and of each curve its look, its ends and its size.

``python -m tests.report.figures.told`` writes ``told.txt`` anew; its diff is read.
"""

from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from report.numbers.evidence import Evidence, gather
from report.pages.drawing.letters import letter_panels, title_of
from tests.report.figures.conftest import DRAWN

KEPT = Path(__file__).with_suffix(".txt")
NOTHING = 1e-6  # Share of the largest coordinate below which one is rounding
CHAOTIC = "twin"  # Curves of motions of which one is chaotic: there rounding grows


def told(figure: Figure) -> Iterator[str]:
    """Yield the lines on a figure."""
    for axes in figure.axes:
        scales = ", ".join(_axis(axes, name) for name in "xy") if axes.axison else "no axes"
        yield f"{title_of(axes)!r} {scales}"
        yield from (f"  {_look(each)}: {_of_curve(each)}" for each in axes.lines)
        for patch in axes.patches:
            corners = patch.get_transform().transform(patch.get_path().vertices)
            place = axes.transData.inverted().transform(corners)
            yield f"  {type(patch).__name__} {_name(patch.get_label())}: {_sizes(place)}"
        for each in axes.collections:
            found = np.concatenate([*(path.vertices for path in each.get_paths()), each.get_offsets()])
            ends = _rounded(found, [found.min(axis=0), found.max(axis=0)])
            yield f"  collection {_name(each.get_label())}: within {ends}"
        for text in axes.texts:
            yield f"  {text.get_text()!r} at {_few(getattr(text, 'xyann', text.get_position()))}"
            if getattr(text, "arrow_patch", None):
                yield f"    arrow to {_few(text.xy)}"


def _axis(axes: Axes, name: str) -> str:
    axis = getattr(axes, f"{name}axis")
    scale = axis.get_scale()
    ends = f" {_few(getattr(axes, f'get_{name}lim')())}" if scale == "linear" else ""
    with_words = type(axis.get_major_formatter()).__name__ == "FixedFormatter"
    ticks = [each.get_text() for each in axis.get_ticklabels()] if with_words else []
    words = f" {ticks} at {_few(axis.get_ticklocs())}" if with_words else ""
    return f"{name} {axis.get_label_text()!r} {scale}{ends}{words}"


def _look(line: Line2D) -> str:
    face = "" if line.get_marker() in ("", "None") else f" {line.get_marker()} {line.get_markerfacecolor()}"
    return f"{_name(line.get_label())} {line.get_linestyle()} {line.get_color()}{face}"


def _name(label: object) -> str:
    return "-" if str(label).startswith("_") else repr(str(label))


def _of_curve(line: Line2D) -> str:
    return "not told" if line.get_label() == CHAOTIC else _sizes(line.get_xydata())


def _sizes(places: np.ndarray) -> str:
    """Say the first and the last place, and of each coordinate the least, the largest and the mean."""
    places = np.asarray(places, float)
    seen = places[np.isfinite(places).all(axis=1)]
    if not len(seen):
        return "nothing"
    ends = [seen[0], seen[-1], seen.min(axis=0), seen.max(axis=0), seen.mean(axis=0)]
    return f"{len(seen)} points {_rounded(seen, seen if len(seen) < 3 else ends)}"


def _rounded(places: np.ndarray, chosen: Iterable[np.ndarray]) -> str:
    largest = np.abs(places).max(axis=0)
    return " ".join(_few(np.where(np.abs(each) < NOTHING * largest, 0.0, each)) for each in chosen)


def _few(numbers: Iterable[float]) -> str:
    return f"({', '.join(f'{float(each):.5g}' for each in numbers)})"


def kept() -> dict[str, list[str]]:
    """Return the lines that are kept on each figure."""
    pieces = (each.splitlines() for each in KEPT.read_text("utf-8").split("== ")[1:])
    return {name: lines for name, *lines in pieces}


def _renew(evidence: Evidence) -> None:
    drawn = {name: record.draw(evidence) for name, record in DRAWN.items()}
    for figure in drawn.values():
        letter_panels(figure)
    KEPT.write_text("".join("\n".join([f"== {n}", *told(each), ""]) for n, each in drawn.items()), "utf-8")


if __name__ == "__main__":
    _renew(gather())
