"""The response of a linear system over time."""

from matplotlib.axes import Axes

from trimmer.drawing.axes import add_legend
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import line, plain_label
from trimmer.drawing.signals.samples import finish_time, thinned
from trimmer.drawing.units import name_axis
from trimmer.linear.in_time import TimeResponse


@draw.register(TimeResponse)
def draw_time_response(response: TimeResponse, axes: Axes) -> None:
    """Draw inputs and outputs over time, s."""
    for number, (name, values) in enumerate(response.named.items()):
        axes.plot(*thinned(response.time, values), label=plain_label(name), **line(number))
    finish_time(axes)
    name_axis(axes.yaxis, "signal, in its unit", "")
    add_legend(axes)
