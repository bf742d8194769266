"""Names, units and prefixes in pictures."""

import io

import numpy as np
import pytest
from matplotlib.cbook import is_math_text
from matplotlib.image import imread

import trimmer
from tests.trimmer.drawing.pictures import legend, new_axes
from trimmer.drawing.content import content_of, figure_of
from trimmer.mechanism import Body, Force, Link, Mechanism, Output


@pytest.mark.parametrize(
    ("largest", "unit", "shown", "factor"),
    [
        (3.1, "m", "m", 1.0),
        (0.81, "m", "m", 1.0),
        (0.79, "m", "mm", 1e-3),
        (3.1e-3, "m/s²", "mm/s²", 1e-3),
        (8.1e-7, "m", "µm", 1e-6),
        (3e-9, "m", "nm", 1e-9),
        (1e-15, "m", "nm", 1e-9),
        (8.1e5, "m/s", "Mm/s", 1e6),
        (7.9e5, "m/s", "km/s", 1e3),
        (3e-3, "V", "V", 1.0),
        (-3e-3, "m", "mm", 1e-3),
    ],
)
def test_an_axis_has_the_prefix_of_the_larger_of_its_ends(
    largest: float, unit: str, shown: str, factor: float
) -> None:
    samples = np.array([0.0, 0.0, largest]) / 1.05  # without the margin of five per cent
    axes = trimmer.Signal(samples, 10.0, "a $rate", unit).plot(new_axes())
    assert axes.get_ylabel() == f"a $rate, {shown}"
    assert not axes.yaxis.label.get_parse_math()
    assert axes.yaxis.get_major_formatter()(-2.5 * factor) == "\N{MINUS SIGN}2.5"


@pytest.mark.filterwarnings("ignore::trimmer.errors.LetterWarning")
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", ["_hidden", "$x$", "$\\frac{$", "a$ $b", "中文", "m" * 300, "\\"])
def test_no_name_acts_in_a_label_or_is_lost(name: str) -> None:
    mechanism = Mechanism(
        {"mass": Body(1.0)},
        frequency=1.0,
        links={"spring": Link(("ground", "mass"), stiffness=40.0, damping=1.0)},
        forces={"push": Force("mass", amplitude=1.0)},
        outputs={name: Output({"mass": 1.0})},
        title=name,
    )
    figure = figure_of(trimmer.simulate(mechanism, 1.0).plot, name)
    assert content_of(figure, "svg").startswith(b"<?xml")
    (text,) = legend(figure.axes[0])
    assert not is_math_text(text)
    assert text.replace(r"\$", "$").strip() == (name if len(name) < 100 else f"{name[:59]}…")
    # A long title is broken into lines.
    assert figure.get_suptitle().replace("\n", "") == name


@pytest.mark.parametrize("size", [(2.0, 1.0), (3.0, 2.0)])
def test_a_bitmap_has_the_figure_s_proportions(size: tuple[float, float]) -> None:
    figure = figure_of(trimmer.Signal(np.zeros(3), 1.0).plot, size=size)
    height, width, _ = imread(io.BytesIO(content_of(figure, "png"))).shape
    assert (width, height) == (160 * size[0], 160 * size[1])
    assert figure.get_suptitle() == ""
