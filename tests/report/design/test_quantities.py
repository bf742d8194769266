"""Numbers as a reader wants them."""

from types import SimpleNamespace
from typing import Any

import pytest

from report.design.quantities import percent, place_words, shown, written
from report.design.words.sentences import exposure_sentences


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (40e-6, "m", "40 µm"),
        (2.917796e-3, "m", "2.92 mm"),
        (999.96e-6, "m", "1 mm"),
        (0.5, "N", "0.5 N"),
        (0.05, "N", "50 mN"),
        (200e3, "N/m", "200 kN/m"),
        (0.035, "kg", "35 g"),
        (1.5, "kg", "1.5 kg"),
        (-3.5, "N s/m", "−3.5 N s/m"),
        (0.0, "m", "0 m"),
        (2000.0, "m", "2000 m"),
        (1142.7, "Hz", "1.14 kHz"),
        (0.1123, "Hz", "0.112 Hz"),
        (0.0999999, "W", "0.1 W"),
        (1.5e5, "N", "150 kN"),
        (float("nan"), "m", "unknown"),
    ],
)
def test_units_take_the_prefix_that_fits(value: float, unit: str, text: str) -> None:
    assert shown(value, unit) == text


def test_digits_are_kept_and_no_more() -> None:
    assert written(0.000123456, 3) == "0.000123"
    assert written(1.23e-7) == "1.23 · 10^-7".replace("-", "−")
    assert written(1e9) == "1 · 10^9"
    assert percent(0.12345) == "12 %"
    assert [written(each) for each in (float("inf"), -float("inf"), float("nan"))] == ["∞", "−∞", "unknown"]


def test_places_have_words() -> None:
    assert place_words("frequency") == "frequency of the drive"
    assert place_words('links."motor mount".stiffness') == "stiffness of motor mount"
    assert place_words("plays.bridge.gap") == "gap of bridge"


@pytest.mark.parametrize("counted", ["drive period", "sample"])
def test_who_holds_it_is_told_of_what_does_not_repeat_too(counted: str) -> None:
    motion = SimpleNamespace(
        hand_arm={"motor": None}, repeats=False, measured_periods=96, period_word=counted
    )
    design: Any = SimpleNamespace(motion=motion, file=SimpleNamespace(held="motor"))
    told = str(exposure_sentences(design))
    assert told.startswith("The hand holds the motor. The motion does not repeat")
    assert f"96 {counted}s" in told
