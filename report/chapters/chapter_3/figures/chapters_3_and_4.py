"""The figures of chapters 3 and 4, each with its caption and alternative text.

The experiment's data and parameters are confidential, so all are drawn with the parameters of Listing A.1.
"""

from __future__ import annotations

from report.chapters.appendix_e.figures import motion_released
from report.chapters.chapter_3.figures import motion_driven
from report.chapters.chapter_4 import figures as motion_blocks
from report.drawing.drawing import Drawing

_DRIVEN = "Simulated with the parameters of Listing A.1, driven with 1.5 mm at 109.945 Hz"

DRAWINGS = (
    Drawing(
        "fig-3.1",
        "Motions without play",
        f"{_DRIVEN}, settled, in place of the measured motions (thesis, figure 3.1): cutter, guard, and "
        "difference. Friction of 0.5 N between cutter and guard, no play. The guard's motion, two percent of "
        "the cutter's, shows higher harmonics most clearly.",
        "Three curves over 50 ms: cutter and difference are sines of 1.5 mm with flattened peaks, the guard "
        "moves by 20 micrometres to either side and less smoothly.",
        motion_driven.motions_without_play,
    ),
    Drawing(
        "fig-3.2",
        "Spectrum without play",
        f"{_DRIVEN}: 2001 samples at 20 kHz of the motion of figure 3.1, bins of 9.995 Hz (thesis, figure "
        "3.2). Only odd harmonics; the fifth is raised by a natural mode at 549.6 Hz.",
        "Amplitude on a logarithmic scale against frequency up to 1000 Hz, with peaks at the first, third, "
        "fifth, seventh and ninth multiple of the drive and nothing between them.",
        motion_driven.spectrum_without_play,
    ),
    Drawing(
        "fig-3.3",
        "Motions with play",
        f"{_DRIVEN}, settled (thesis, figure 3.3): as figure 3.1, with a play of 0.2 mm between pin and "
        "bridge.",
        "Three curves over 50 ms: cutter and difference show a fast oscillation on top of a sine of 1.5 mm, "
        "the guard moves by 20 micrometres to either side.",
        motion_driven.motions_with_play,
    ),
    Drawing(
        "fig-3.4",
        "Spectrum with play",
        f"{_DRIVEN}: the motions of figures 3.3 and 3.1 (thesis, figure 3.4). Play raises the odd harmonics "
        "and adds no others.",
        "Two spectra on a logarithmic scale. Both have peaks at the odd multiples of the drive only; with "
        "play the third, fifth and seventh are higher.",
        motion_driven.spectrum_with_play,
    ),
    Drawing(
        "fig-3.5",
        "Spectrum with play, 200 to 1000 Hz",
        "The spectrum of figure 3.4 above the drive, with the measured peaks of table 3.2 as symbols; their "
        "height means nothing (thesis, figure 3.5). Dotted: multiples of 109.945 Hz. The measurement has "
        "even harmonics, which the model cannot have.",
        "Peaks of the model at the third and fifth harmonic. Symbols of three measurements stand near the "
        "second, third, fourth and fifth harmonic.",
        motion_driven.enlarged_spectrum,
    ),
    Drawing(
        "fig-3.6",
        "Open loop, gap 0.2 mm",
        f"{_DRIVEN}, with friction of 0.25, 0.50 and 0.75 N between cutter and guard (thesis, figure 3.6). "
        "Third and fifth harmonic are the largest; friction makes the fifth smaller.",
        "Left: displacement from rest over 30 ms for three frictions, a sine with a faster oscillation on "
        "top. Right: amplitudes of the third to ninth harmonic, the fifth falling from 259 to 154 "
        "micrometres.",
        motion_driven.open_loop_with_small_gap,
    ),
    Drawing(
        "fig-3.7",
        "Open loop, larger gaps",
        f"{_DRIVEN}. Left: with the printed gap of 20 mm the pin swings inside of its play and nothing else "
        "moves (thesis, figure 3.7). Right: the middle one of the three gaps, 2 mm, with three frictions.",
        "Left: a small sine in a wide grey band, and a line at zero. Right: three curves with a strong "
        "oscillation on top of the drive's, smaller with more friction.",
        motion_driven.open_loop_with_large_gap,
    ),
    Drawing(
        "fig-3.8",
        "What the start adds to a spectrum",
        f"{_DRIVEN}, gap 2 mm, friction 0.25 N (thesis, figure 3.8). Left: a record from rest and one of the "
        "settled motion, whole periods. Right: spectrum of their difference over time; dotted lines are "
        "natural modes. The peak that the thesis takes for a limit cycle stands beside the second.",
        "Left: the settled record has three narrow peaks and nothing between them; the record from rest has "
        "a floor with a hump near 355 Hz. Right: peaks at the dotted lines near 355 and 550 Hz.",
        motion_driven.open_loop_spectrum_with_large_gap,
    ),
    Drawing(
        "fig-3.9",
        "Closed loop released without drive",
        "Spectra of the first 0.3 s with the parameters of Listing A.1, over the gap (thesis, figure 3.9). "
        "Left: released inside of the play, natural modes die out, near 355 Hz for every gap. Right: "
        "released outside, the limit cycle. Friction acts by its ratio to the gap. Dotted: the second "
        "natural mode.",
        "Four panels for two gaps and two starts. Left peaks at 355 and 550 Hz, which friction of 0.25 N "
        "removes for the small gap only. Right one peak at 728 Hz, hardly changed by friction.",
        motion_released.closed_loop_spectra,
    ),
    Drawing(
        "fig-4.1",
        "Two blocks of friction-controlled backlash",
        "Listing A.7 and python-control's backlash from rest, $b$ = 0.4 mm, pin 1.5 mm at 100 Hz (thesis, "
        "figure 4.1, whose built-in block is Simulink's). Below: their difference, zero.",
        "A sine and a clipped, delayed copy of it over two periods; circles of the second block lie on the "
        "first one's line. The difference is a line at zero.",
        lambda _: motion_blocks.two_friction_blocks(),
    ),
    Drawing(
        "fig-4.2",
        "Block of inertia-controlled backlash",
        "Input and output of Listing A.8, $b$ = 0.4 mm, and how far the output is from the exact waveform "
        "(thesis, figure 4.2). The offset of -12.4 µm comes from a rounded constant.",
        "A sine and an output that leads into straight flights twice a period. Below, the deviation is zero "
        "but for one flight in each period, where it is minus 12.4 micrometres.",
        lambda _: motion_blocks.inertia_block_over_time(),
    ),
    Drawing(
        "fig-4.3",
        "Inertia-controlled backlash for several gaps",
        "Exact output for a pin of 1.5 mm at 100 Hz and gaps of our choice (thesis, figure 4.3, which names "
        "none). Without gap it is the input; the wider the gap, the longer the flight and the larger the "
        "output.",
        "Five periodic curves; the one without gap is a sine, the others rise higher and later, along "
        "straight lines.",
        lambda _: motion_blocks.inertia_waveforms(),
    ),
)
