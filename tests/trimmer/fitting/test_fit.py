"""Fits to records whose numbers are known."""

import dataclasses
import math

import numpy as np
import pytest
from scipy.stats import binom

from tests.trimmer.fitting.made import exact, record, trimmer
from trimmer import Friction, Mechanism, Output, Signal, WrongTypeError
from trimmer import fit as fit_numbers
from trimmer.errors import FitError
from trimmer.fitting import Fit, FitSettings

GAP, DAMPING, FORCE = "plays.bridge.gap", "plays.bridge.damping", "frictions.blade.force"
TRUE = {GAP: 40e-6, "plays.bridge.stiffness": 30e3, DAMPING: 0.4, FORCE: 1.0}
ONCE = FitSettings(starts=1)


def holds(fit: Fit, place: str, value: float) -> bool:
    (number,) = (each for each in fit.numbers if each.place == place)
    return (number.lower is None or number.lower <= value) and (number.upper is None or value <= number.upper)


def begun(**factors: float) -> Mechanism:
    mechanism = trimmer()
    for place, factor in factors.items():
        mechanism = mechanism.with_value(place, factor * mechanism.value(place))
    return mechanism


@pytest.fixture(scope="module")
def usual() -> Fit:
    return fit_numbers(begun(**{GAP: 1.4, FORCE: 0.8}), {"stroke": record(trimmer(), 2e-6)}, settings=ONCE)


def test_the_numbers_come_back(usual: Fit) -> None:
    assert [each.place for each in usual.numbers] == list(TRUE)
    for number in usual.numbers:
        assert number.value == pytest.approx(TRUE[number.place], rel=0.02)
        assert number.lower is not None and number.upper is not None
        assert number.upper - number.lower < 0.06 * number.value
        assert usual.mechanism.value(number.place) == number.value
    assert sum(holds(usual, *each) for each in TRUE.items()) >= 3
    assert usual.judgement.explained and 0.4 < usual.judgement.reduced < 1.9
    assert usual.weak == ()
    assert usual.orbit.stable


def test_the_origin_of_time_comes_back(usual: Fit) -> None:
    # The record begins 1.23 ms after a drive period does, so that the next one begins that much less later.
    assert usual.shift % usual.period == pytest.approx(
        (usual.period - 1.23e-3) % (usual.period / 2), rel=2e-3
    ) or (usual.shift == pytest.approx(usual.period - 1.23e-3, rel=2e-3))


def start_of_two() -> Mechanism:
    return begun(**{GAP: 1.2, FORCE: 0.8})


@pytest.fixture(scope="module")
def two() -> Fit:
    return fit_numbers(start_of_two(), {"stroke": record(trimmer(), 2e-6)}, [GAP, FORCE], settings=ONCE)


@pytest.mark.slow
def test_a_machine_of_another_size_has_the_same_relative_intervals(two: Fit) -> None:
    """With all lengths and forces a thousandth the motion is a thousandth."""
    small, start = trimmer(), start_of_two()
    for place in ("pins.pin.amplitude", GAP, FORCE):
        small = small.with_value(place, 1e-3 * small.value(place))
        start = start.with_value(place, 1e-3 * start.value(place))
    fit = fit_numbers(start, {"stroke": record(small, 2e-9)}, [GAP, FORCE], settings=ONCE)
    for number, same in zip(fit.numbers, two.numbers, strict=True):
        assert number.value == pytest.approx(1e-3 * same.value, rel=1e-5)
        assert number.upper == pytest.approx(1e-3 * same.upper, rel=1e-4)  # type: ignore[operator]


@pytest.mark.slow
def test_two_outputs_in_two_quantities_tell_more(two: Fit) -> None:
    outputs = {**trimmer().outputs, "motor": Output({"motor": 1})}
    start, true = (dataclasses.replace(each, outputs=outputs) for each in (start_of_two(), trimmer()))
    motor = record(true, 1.0, seed=1, output="motor", derivatives=2)
    fit = fit_numbers(start, {**two.measured.signals, "motor": motor}, [GAP, FORCE], settings=ONCE)
    assert fit.judgement.explained
    for number, alone in zip(fit.numbers, two.numbers, strict=True):
        assert number.value == pytest.approx(TRUE[number.place], rel=0.02)
        assert number.upper - number.lower < 1.05 * (alone.upper - alone.lower)  # type: ignore[operator]


@pytest.mark.slow
def test_a_motion_that_repeats_after_six_periods() -> None:
    true = Mechanism.from_toml("examples/oscillator-stop.toml").with_value("frequency", 0.9)
    signal = record(true, 1e-3, output="mass", samples=4000, sample_rate=40.0)
    fit = fit_numbers(true, {"mass": signal}, ["stops.stop.gap"], settings=ONCE)
    assert fit.measured.period_count == fit.orbit.period_count == 6
    assert fit.judgement.sentences[1] == "the measured motion repeats after 6 drive periods"
    assert fit.numbers[0].value == pytest.approx(10.0, rel=1e-4)
    assert fit.judgement.explained


def test_a_motion_of_another_period_is_no_start() -> None:
    true = Mechanism.from_toml("examples/oscillator-stop.toml").with_value("frequency", 0.9)
    signal = record(
        true.with_value("stops.stop.gap", 20.0), 1e-3, output="mass", samples=2000, sample_rate=40.0
    )
    with pytest.raises(
        FitError, match=r"repeats after one drive period.*the file it repeats after 6 drive per"
    ):
        fit_numbers(true, {"mass": signal}, ["stops.stop.gap"], settings=ONCE)


@pytest.mark.slow
def test_friction_that_holds_all_the_time_is_not_known() -> None:
    held = dataclasses.replace(
        trimmer(), frictions={**trimmer().frictions, "brake": Friction(("ground", "housing"), 80.0)}
    )
    fit = fit_numbers(held, {"stroke": record(held, 2e-6)}, [FORCE, "frictions.brake.force"], settings=ONCE)
    brake = fit.numbers[1]
    assert brake.upper is None and "upper end is open" in brake.upper_note
    assert any(each.places == ("frictions.brake.force",) for each in fit.weak)
    assert any("says little of the force of brake" in each.message for each in fit.weak)


STROKE = {"stroke": Signal(np.ones(100), 1e3, "stroke", "m")}
BELT = Mechanism.from_toml("examples/block-on-belt.toml")


@pytest.mark.parametrize(
    ("mechanism", "measured", "options", "told"),
    [
        *(
            (trimmer(), STROKE, {"free": free}, told)
            for free, told in (
                (["plays.bridge.gpa"], r"did you mean plays.bridge.gap\?"),
                (["frequency"], "is taken from the measurement"),
                (["pins.pin.order"], "is a whole number"),
                (["start.motor.velocity"], "does not depend on it"),
                (['links."coil spring".damping'], "is 0, which gives no size"),
                ([GAP, GAP], "named twice"),
            )
        ),
        ("thesis-play.toml", STROKE, {}, "mechanism"),
        (trimmer(), STROKE["stroke"], {}, "measured"),
        (trimmer(), {"stroke": np.ones(100)}, {}, "signal of stroke"),
        (trimmer(), STROKE, {"drive_frequency": "110"}, "drive_frequency"),
        *(
            (trimmer(), STROKE, {"drive_frequency": each}, "must be positive and finite")
            for each in (0.0, -1.0, math.inf)
        ),
        (trimmer(), {"strok": STROKE["stroke"]}, {}, "did you mean stroke"),
        (trimmer(), {}, {}, "nothing was measured"),
        (BELT, {"block": STROKE["stroke"]}, {}, r"no line of the measurement is .* of the vibration at"),
    ],
)
def test_what_cannot_be_fitted_is_told(mechanism, measured, options, told: str) -> None:
    with pytest.raises((ValueError, WrongTypeError), match=told):
        fit_numbers(mechanism, measured, **options)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("spread", 1.0),
        ("spread", 101.0),
        ("confidence", 0.0),
        ("confidence", 1.0),
        ("starts", 0),
        ("seed", -1),
    ],
)
def test_settings_are_checked(name: str, value: float) -> None:
    with pytest.raises(ValueError, match=name):
        FitSettings(**{name: value})  # type: ignore[arg-type]
    assert FitSettings(starts=1, spread=100.0, seed=0, confidence=0.5).spread == 100.0


@pytest.mark.slow
def test_intervals_hold_the_truth_as_often_as_they_say() -> None:
    count, free = 40, [GAP, DAMPING, FORCE]
    held = dict.fromkeys(free, 0)
    values = exact(trimmer(), "stroke", 4000)
    for seed in range(count):
        noise = 5e-6 * np.random.default_rng(1000 + seed).normal(size=values.size)
        fit = fit_numbers(
            trimmer(), {"stroke": Signal(values + noise, 1e4, "stroke", "m")}, free, settings=ONCE
        )
        for place in free:
            held[place] += holds(fit, place, TRUE[place])
    fewest = binom.ppf(0.001, count, 0.95)
    assert all(number >= fewest for number in held.values()), held
    assert sum(held.values()) >= binom.ppf(0.001, count, 0.95) * 3
    # All of them always would be intervals that are too wide.
    assert sum(held.values()) <= binom.ppf(0.999, 3 * count, 0.95)
