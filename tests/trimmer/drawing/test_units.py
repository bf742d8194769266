"""Axes in units that are easy to read."""

from __future__ import annotations

import pytest
from matplotlib.figure import Figure

from trimmer.drawing.units import name_axis


@pytest.mark.parametrize(
    ("largest", "unit", "metres"),
    [(3.1, "m", 1.0), (3.1e-3, "mm", 1e-3), (2e-5, "µm", 1e-6), (3e-9, "nm", 1e-9), (0.0, "m", 1.0)],
)
def test_unit_of_lengths(largest: float, unit: str, metres: float) -> None:
    axis = Figure().add_subplot().yaxis
    axis.set_view_interval(0.0, largest, ignore=True)
    name_axis(axis, "stroke, peak to peak", "m")
    assert axis.get_label_text() == f"stroke, peak to peak, {unit}"
    assert axis.get_major_formatter()(2.5 * metres) == "2.5"


def test_a_number_has_no_unit() -> None:
    axis = Figure().add_subplot().xaxis
    axis.set_view_interval(-2e-3, 1e-3, ignore=True)
    name_axis(axis, "phase", "")
    assert axis.get_label_text() == "phase"
    assert axis.get_major_formatter()(-2e-3) == "\N{MINUS SIGN}0.002"
