"""Figures of the sample report: two block diagrams, a locus that names omega along it, and a spectrum."""

import functools

import numpy as np
from matplotlib.figure import Figure as Drawing

from report.chapters.chapter_2.figures.block_diagrams import feedback_system, linear_system
from report.pages.drawing.read_out import Along, plot_along
from report.pages.drawing.style import LINES, new_figure, style
from report.pages.drawing.svg import to_svg
from report.pages.figure import Figure

PEAK = 550.0  # Frequency of the spectrum's peak, in Hz


@functools.cache
def figures() -> tuple[Figure, ...]:
    """Return all of them as figures of the report."""
    return (
        finished(
            "fig-2.3",
            "Linear system",
            r"The block $G(s)$ maps $u(t)$ to $y(t)$.",
            "A block G of s; u of t enters from the left and y of t leaves to the right.",
            linear_system.draw(None),
        ),
        finished(
            "eq-2.37",
            "Feedback system",
            r"The loop has $M = \frac{G}{1 + G N}$ from $U$ to $Y$.",
            "A summing junction takes u and subtracts what N of s feeds back from the output of G of s.",
            feedback_system.draw(None),
        ),
        finished(
            "fig-5.1",
            "Locus",
            r"$G = (1 + \mathrm{j} \omega)^{-3}$, with $\omega$ to be read along it.",
            "A curve from one on the real axis through the lower half plane to zero.",
            locus(),
        ),
        finished(
            "fig-5.2",
            "Spectrum",
            f"A spectrum with one peak, at {PEAK:.0f} Hz.",
            "A flat line with one narrow peak in its middle.",
            spectrum(),
        ),
    )


def finished(id: str, title: str, caption: str, alternative_text: str, drawing: Drawing) -> Figure:
    """Return a drawing with its words as a figure of the report."""
    return Figure(id, title, caption, alternative_text, to_svg(drawing, id, title, alternative_text))


def locus() -> Drawing:
    """Draw a locus in the complex plane."""
    omega = np.geomspace(0.01, 100.0, 300)
    with style():
        figure = new_figure(3.5)
        axes = figure.subplots()
        plot_along(axes, (1 + 1j * omega) ** -3, Along("ω", "rad/s", omega), label="$G$", **LINES[0])
        axes.set(xlabel="real part", ylabel="imaginary part", xlim=(-0.5, 1.2), ylim=(-1.0, 0.4))
    return figure


def spectrum() -> Drawing:
    """Draw a spectrum with one peak."""
    frequency = np.linspace(0.0, 1000.0, 201)
    magnitude = 1e-3 + 1.0 / (1 + ((frequency - PEAK) / 5.0) ** 2)
    with style():
        figure = new_figure(3.0)
        axes = figure.subplots()
        axes.plot(frequency, magnitude, **LINES[0])
        axes.set(
            xlabel="frequency [Hz]", ylabel="amplitude [mm]", xlim=(0, 1000), ylim=(1e-3, 10), yscale="log"
        )
    return figure
