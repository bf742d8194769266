"""Figures of section 5.2 that rest on simulation, each with its caption and alternative text."""

from __future__ import annotations

from report.chapters.chapter_5.figures import closed_loop_motion, driven_loop_motion, relay_loop_motion
from report.drawing.drawing import Drawing

THREE_GAPS = Drawing(
    "fig-5.7",
    "Three gaps after one impulse",
    "How far the closed loop swings after an impulse, for the gaps of figure 5.7 of the thesis. All three go "
    "on after the stronger impulse, with 8.29 gaps each. After the weaker one the largest gap dies out, not "
    "the smallest.",
    "Six bands over 160 milliseconds. In the left column they widen to 83, 166 and 249 nanometres from top "
    "to bottom; in the right column the first two do the same and the third shrinks to nothing.",
    closed_loop_motion.three_gaps,
)

SMALL_GAP = Drawing(
    "fig-5.9",
    "Limit cycle for a gap of 4 µm",
    "a: settled output with the readings of the thesis (figure 5.9). b: its spectrum over one second, whose "
    "highest bin is 734 Hz, and over the stated 0.1 s, whose highest bin is 730 Hz. Dotted: the limit cycle.",
    "A sine of 33 micrometres between two dotted lines. Below it a narrow peak at 734 hertz and one ten "
    "times as wide at 730, on both sides of a dotted line at 733.6.",
    closed_loop_motion.small_gap,
)

RESPONSES = Drawing(
    "fig-5.11",
    "Driven loop over time",
    "Output and bridge with a drive of 1.5 mm at 100 Hz and $b$ = 40 µm (thesis, figure 5.11). Above: open "
    "loop. Below: the same blocks with the output subtracted from the drive, which swing between −1 and 1 mm "
    "(dotted) with a faster oscillation on top, as the text describes the figure.",
    "Above, a sine of 1.48 millimetres that bridge and output share. Below, a wave of one millimetre made of "
    "a slow and a fast oscillation, the bridge in opposite phase to the fast one.",
    driven_loop_motion.time_responses,
)

SPECTRA = Drawing(
    "fig-5.12",
    "Closed and driven loop in spectra",
    "a: closed loop (thesis, figure 5.12). b: open loop, odd multiples of 100 Hz only; and the same blocks "
    "with the output subtracted from the drive, where the limit cycle shows. Dotted: its frequency without "
    "drive.",
    "Three spectra. The first has one line at 733.6 hertz; the second has lines at 100, 300, 500, 700, 900 "
    "and 1100 hertz, none of them there; the third has large lines at 100 and at 733 hertz.",
    driven_loop_motion.spectra,
)

INERTIA = Drawing(
    "fig-5.14",
    "Inertia-controlled backlash, driven",
    "From rest, 1.5 mm at 100 Hz, $b$ = 0.4 mm (thesis, figure 5.14). Above: open loop. Below: Listing A.8's "
    "block in the loop with the drive as reference; its largest line beside multiples of 100 Hz (points) is "
    "where the thesis reads 659 Hz.",
    "Above, a distorted sine, and a spectrum that falls smoothly between odd multiples of 100 hertz. Below, "
    "a fast oscillation on a slow one, and a spectrum with a hump at 660 hertz beside a line at 700.",
    driven_loop_motion.inertia,
)

RELAY = (
    Drawing(
        "fig-5.19",
        "Relay in the loop",
        "Size and frequency of the swings after an impulse, in the loop with an ideal relay (thesis, figure "
        "5.19). They never stop becoming smaller and faster; runs end after 3000 switchings. Dotted: what a "
        "simulation keeps up that looks at the relay's input once a step.",
        "Falling lines of size and rising lines of frequency over time, straight on logarithmic scales and "
        "parallel in the end; a dotted level lies across each panel.",
        relay_loop_motion.relay_swings,
    ),
    Drawing(
        "fig-5.20",
        "Coulomb and viscous friction in the loop",
        "Left, the block on the output: a periodic motion would need $y$ to be zero where a square wave "
        "jumps, which it is only at the edges of the grey strip, there in phase. Right, the block on the "
        "output's velocity: the loop moves a little and stays (thesis, figure 5.20).",
        "Left, two nearly equal curves with peaks at low frequency that fall as a straight line on "
        "logarithmic scales. Right, three curves that rise within five microseconds to a constant value.",
        relay_loop_motion.friction_and_condition,
    ),
)
