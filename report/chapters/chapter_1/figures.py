"""Figure of chapter 1, drawn after the text: shapes and proportions are free, connections are the text's."""

from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.pages.drawing import mechanical_symbols as draw
from report.pages.drawing.style import BLACK


@figure("fig-1.1")
def components(_: Evidence) -> Figure:
    figure, axes = draw.canvas(6.5, 4.0)
    draw.body(axes, (0.5, 0.2), (5.5, 0.35), "plastic housing", "#f2f2f2")
    draw.body(axes, (2.2, 0.55), (1.5, 0.75), "motor", draw.MOTOR)
    draw.body(axes, (2.6, 1.3), (0.7, 0.4), "shell", "#f5ecb0")
    draw.body(axes, (3.0, 1.7), (0.16, 0.55), "", draw.PIN)
    for edge in (2.62, 3.26):
        draw.body(axes, (edge, 1.95), (0.28, 0.5), "", draw.BRIDGE)
    draw.body(axes, (2.2, 2.45), (1.8, 0.25), "driving bridge", draw.BRIDGE)
    draw.body(axes, (1.5, 2.7), (2.9, 0.35), "cutter", draw.BRIDGE)
    draw.body(axes, (1.3, 3.05), (3.4, 0.3), "guard", draw.GUARD)
    draw.body(axes, (5.0, 0.55), (0.8, 2.8), "guard\nhousing", draw.HOUSING)
    draw.spring(axes, 4.4, 5.0, 2.8, "")
    axes.plot([4.7, 5.0], [3.2, 3.2], color=BLACK, linestyle="solid", linewidth=3)
    draw.called(axes, "eccentric pin", (3.08, 1.85), (4.2, 1.55))
    draw.called(axes, "play", (2.92, 2.08), (1.95, 1.75))
    draw.called(axes, "coil spring", (4.7, 2.74), (4.5, 2.2))
    draw.called(axes, "friction", (1.5, 3.05), (0.6, 2.75))
    draw.displacement(axes, 2.0, 3.65, "motion of cutter and bridge")
    return figure
