"""How the measures of samples are distributed."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.design import Measure, MeasureOfPart
from trimmer.drawing.dispatch import draw
from trimmer.drawing.units import name_axis
from trimmer.uncertainty.samples import Samples
from trimmer.uncertainty.study import name_of

COLUMNS = 2
INSIDE, OUTSIDE = "#0072B2", "#D55E00"
"""Of samples within and beyond a target: colours of Okabe and Ito."""


def sample_figure(samples: Samples) -> Figure:
    """Draw a histogram of each measure, with the targets."""
    asked = [each for each in samples.asked if each.measure is not Measure.PERIOD]
    rows = -(-len(asked) // COLUMNS)
    figure = Figure(figsize=(3.6 * COLUMNS, 2.1 * rows), layout="constrained")
    all_axes = figure.subplots(rows, COLUMNS, squeeze=False).ravel()
    for axes, each in zip(all_axes, asked, strict=False):
        draw_distribution(samples, each, axes)
    for axes in all_axes[len(asked) :]:
        axes.set_axis_off()
    return figure


@draw.register(Samples)
def draw_samples(samples: Samples, axes: Axes) -> None:
    """Draw the histogram of the first measure."""
    draw_distribution(samples, samples.asked[0], axes)


def draw_distribution(samples: Samples, asked: MeasureOfPart, axes: Axes) -> Axes:
    """Draw the histogram of a measure; what misses its target is hatched."""
    values = samples.measured(asked)
    values = values[np.isfinite(values)]
    bounds = [each for each in samples.targets if (each.measure, each.part) == (asked.measure, asked.part)]
    edges = np.histogram_bin_edges(values, bins="auto" if np.ptp(values) else 1).tolist()
    met = np.array([all(each.met_by(float(value)) for each in bounds) for value in values], dtype=bool)
    axes.hist(
        [values[met], values[~met]],
        bins=edges,
        stacked=True,
        color=[INSIDE, OUTSIDE],
        hatch=["", "//"],
        edgecolor="white",
        linewidth=0.4,
    )
    for each in bounds:
        axes.axvline(each.bound, color="black", linestyle="--", linewidth=1.0)
    axes.set_ylabel("samples")
    name_axis(axes.xaxis, name_of(asked), asked.unit(samples.flow))
    return axes
