"""The figures of appendix E, each with its caption and alternative text."""

from __future__ import annotations

from report.chapters.appendix_e.figures.motion_amplitudes import drive_amplitudes
from report.chapters.appendix_e.figures.motion_released import closed_loop_for_four_gaps
from report.drawing.drawing import Drawing

DRAWINGS = (
    Drawing(
        "fig-E.1",
        "Closed loop for four gaps",
        "Settled output of the closed loop without drive, pin displacement only (thesis, figure E.1). The "
        "four motions are one and the same, scaled by the gap. Dotted: the amplitude.",
        "Four nearly sinusoidal curves over 12 ms with the same period; their amplitude rises from 2.5 "
        "to 5.0 mm.",
        closed_loop_for_four_gaps,
    ),
    Drawing(
        "fig-E.2",
        "Open loop for five amplitudes of the drive",
        "Settled input and output at 100 Hz, $b$ = 40 µm, over the amplitude of the input (thesis, figure "
        "E.2). At 1.5 µm the pin stays within its play. Bottom right: outputs without their first harmonic, "
        "which far above the gap no longer depend on the amplitude.",
        "Five panels with a sine and an output: zero in the first, rippled in the second, nearly the same "
        "sine in the others. The sixth panel shows ripples of 26 to 36 micrometres that nearly coincide.",
        drive_amplitudes,
    ),
)
