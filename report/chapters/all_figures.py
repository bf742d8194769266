"""All figures of the report, each with its caption and alternative text."""

from __future__ import annotations

from report.chapters.appendix_e.figures import appendix_e
from report.chapters.chapter_2.figures import chapters_1_and_2
from report.chapters.chapter_3.figures import chapters_3_and_4
from report.chapters.chapter_5.figures import section_5_2, section_5_2_simulated
from report.chapters.chapter_5.figures.limit_cycles import friction_intersections, inertia_intersections
from report.chapters.chapter_5.figures.linear import (
    bode_plot,
    bode_plot_light_damping,
    linear_time_response,
    nyquist_locus,
)
from report.drawing.drawing import Drawing

DRAWINGS = (
    *chapters_1_and_2.DRAWINGS,
    *chapters_3_and_4.DRAWINGS,
    Drawing(
        "fig-5.1",
        "Time response of the linear trimmer",
        "Pin and output for $u(t) = 0.0015\\sin(2\\pi 100 t)$ m, started from rest (thesis, figure 5.1). "
        "Below: their difference. The start excites the natural modes, which take some periods to decay.",
        "Two curves of displacement against time, six periods of a sine of 1.5 mm that nearly coincide; a "
        "third curve below shows their difference, which starts at 0.3 mm and decays.",
        lambda evidence: linear_time_response(evidence.numbers),
    ),
    Drawing(
        "fig-5.2",
        "Bode plot",
        "Bode plot of $q_2 - q_4$ (thesis, figure 5.2). Circle: the frequency quoted as cutoff, where the "
        "gain is one. Square: 3 dB below the static gain. The dotted line falls by 40 dB per decade.",
        "Magnitude and phase against frequency for two systems that nearly coincide up to ten thousand "
        "radians per second. Two sharp peaks near 2221 and 3453; above them the magnitude falls.",
        lambda evidence: bode_plot(evidence.numbers),
    ),
    Drawing(
        "fig-5.3",
        "Nyquist locus",
        "Nyquist locus of $q_2 - q_4$ from the pin's displacement (thesis, figure 5.3). Arrows: rising "
        "frequency. The locus does not encircle $-1$.",
        "Closed curve with two large loops below the real axis for positive frequency and its mirror image; "
        "the right half shows that the point minus one lies outside.",
        lambda evidence: nyquist_locus(evidence.numbers),
    ),
    Drawing(
        "fig-5.4",
        "Bode plot with very light damping",
        "Magnitude of the sum of all displacements with a thousandth of the damping, and with all of it "
        "(thesis, figure 5.4). Dotted: natural frequencies without damping, in rad/s.",
        "Magnitude against frequency; the lightly damped curve has four sharp peaks, the other has three "
        "rounded ones.",
        lambda evidence: bode_plot_light_damping(evidence.numbers),
    ),
    section_5_2.SECOND_IMPLEMENTATION,
    section_5_2_simulated.THREE_GAPS,
    Drawing(
        "fig-5.8",
        "Friction-controlled backlash with G",
        "$G$ and $-1/N$ of friction-controlled backlash, for any gap (thesis, figures 5.8 and 5.10a). "
        "Points: predicted limit cycles, amplitudes in gaps. Right: the stable one in the thesis's loop "
        "(solid) and with the pin's velocity as second input (dash-dotted).",
        "A large loop below the real axis is crossed twice by a curve that ends at minus one; an enlargement "
        "near minus one shows two nearly parallel loci that meet the curve at different places.",
        friction_intersections,
    ),
    section_5_2_simulated.SMALL_GAP,
    section_5_2.LARGER_GAP,
    section_5_2_simulated.RESPONSES,
    section_5_2_simulated.SPECTRA,
    Drawing(
        "fig-5.13",
        "Inertia-controlled backlash with G",
        "$G$ and $-1/N$ of inertia-controlled backlash over its whole domain, $0 < b/A < \\pi$ (thesis, "
        "figure 5.13). Points: predicted limit cycles, amplitudes in gaps.",
        "The curve of minus one over N starts at minus one and meets the locus twice.",
        inertia_intersections,
    ),
    section_5_2_simulated.INERTIA,
    *section_5_2.LATER,
    *appendix_e.DRAWINGS,
)
