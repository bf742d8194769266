"""Names of what has to move with the curves when a reader zooms into a figure, and where it stands."""

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Annotation, Text

Place = tuple[float | None, float | None]
"""Where something stands in the data, across and up; None where it keeps its place on the page."""


def name_parts(figure: Figure) -> None:
    """Give axes, their labels and the texts and arrows in them names, which become ids in the drawing."""
    for index, axes in enumerate(figure.axes):
        axes.set_gid(axes_name(index))
        axes.xaxis.label.set_gid(f"label_x_{index}")
        axes.yaxis.label.set_gid(f"label_y_{index}")
        for number, text in enumerate(axes.texts):
            text.set_gid(_name(index, number))
            arrow = text.arrow_patch if isinstance(text, Annotation) else None
            if arrow is not None:
                arrow.set_gid(f"{_name(index, number)}_arrow")


def axes_name(index: int) -> str:
    """Return the name of a figure's axes."""
    return f"axes_{index + 1}"


def placed(axes: Axes, index: int) -> list[tuple[str, list[Place]]]:
    """Return names of the texts and arrows that stand at places of the data, with one place or two."""
    found = [(_name(index, number), _places(text, axes)) for number, text in enumerate(axes.texts)]
    return [(name, places) for name, places in found if places]


def _name(index: int, number: int) -> str:
    return f"placed_{index}_{number}"


def _places(text: Text, axes: Axes) -> list[Place]:
    if isinstance(text, Annotation):
        end = _in_data(text.xy, text.xycoords)
        start = _in_data(text.xyann, text.anncoords)
        return [end, *([start] if None not in start else [])] if end != (None, None) else []
    return [text.get_position()] if text.get_transform() == axes.transData else []


def _in_data(place: tuple[float, float], coordinates: object) -> Place:
    """Return what of a place is data; coordinates are one name, or one for each direction."""
    across, up = coordinates if isinstance(coordinates, tuple) else (coordinates, coordinates)
    return (place[0] if across == "data" else None, place[1] if up == "data" else None)
