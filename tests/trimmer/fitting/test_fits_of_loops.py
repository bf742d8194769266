"""Fits of loops to records made without this package, and to those of the same machine."""

from functools import cache

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import trimmer
from trimmer.fitting import FitSettings

DRIVE = trimmer.Drive(1.0, frequency=0.2)
RATE, ONCE = 16.0, FitSettings(starts=1)
THRESHOLD, SLOPE = "element.threshold", "element.slope"


def driven(threshold: float, slope: float) -> trimmer.OpenLoop:
    """A dead zone before an oscillator of 0.5 Hz, all of it plain numbers."""
    return trimmer.OpenLoop(control.tf([1.0], [1.0, 0.6, 9.87]), trimmer.DeadZone(threshold, slope), DRIVE)


@cache
def record(threshold: float, slope: float, unit: str = "") -> trimmer.Signal:
    """Its output after a minute, by a method of order eight, with a little noise."""

    def rates(time: float, state: np.ndarray) -> list[float]:
        moved = np.sin(DRIVE.omega * time)
        pushed = slope * np.sign(moved) * max(abs(moved) - threshold, 0.0)
        return [state[1], pushed - 0.6 * state[1] - 9.87 * state[0]]

    times = 60.0 + np.arange(2000) / RATE
    found = solve_ivp(
        rates, (0.0, times[-1]), [0.0, 0.0], "DOP853", times, rtol=1e-8, atol=1e-10, max_step=0.1
    )
    noise = 1e-5 * np.random.default_rng(3).normal(size=times.size)
    return trimmer.Signal(found.y[0] + noise, RATE, "output", unit)


def test_numbers_of_a_loop_are_found_again_in_a_record_of_another_integrator() -> None:
    fit = trimmer.fit(driven(0.4, 1.5), {"output": record(0.3, 2.0)}, settings=ONCE)
    found = {each.place: each for each in fit.numbers}
    assert set(found) == {THRESHOLD, SLOPE}
    for place, true in ((THRESHOLD, 0.3), (SLOPE, 2.0)):
        lower, upper = found[place].lower, found[place].upper
        assert found[place].unit == ""
        assert upper - lower < 1e-2 * true
        assert abs(found[place].value - true) < upper - lower  # Twice what holds it in 95 of 100 records.
        assert fit.subject.value(place) == found[place].value
    assert fit.judgement.sentences[0].startswith("the loop explains the measurement within its noise")


def relay(level: float, hysteresis: float, pace: float = 1.0) -> trimmer.ClosedLoop:
    """A relay round 1/(s (s + 1) (s + 2)), which vibrates by itself; s is over the pace."""
    plant = control.tf([1], [1 / pace**3, 3 / pace**2, 2 / pace, 0])
    return trimmer.ClosedLoop(plant, trimmer.Relay(level, hysteresis=hysteresis))


@cache
def cycle(level: float, hysteresis: float) -> trimmer.Signal:
    """Its output from the first minute on, from switch to switch by a method of order eight, with noise."""
    rate, time, state, sign = 20.0, 0.0, np.zeros(3), 1.0
    times, values = 60.0 + np.arange(3000) / rate, np.empty(3000)
    while time < times[-1]:

        def rates(_: float, x: np.ndarray, push: float = sign * level) -> list[float]:
            return [push - 3 * x[0] - 2 * x[1], x[0], x[1]]

        def switches(_: float, x: np.ndarray, side: float = sign) -> float:
            return float(x[2] - side * hysteresis)

        switches.terminal, switches.direction = True, sign  # type: ignore[attr-defined]
        found = solve_ivp(
            rates, (time, 300.0), state, "DOP853", events=switches, dense_output=True, rtol=1e-9, atol=1e-11
        )
        inside = (times >= time) & (times <= found.t[-1])
        if inside.any():
            values[inside] = found.sol(times[inside])[2]
        time, state, sign = found.t[-1], found.y[:, -1], -sign
    noise = 1e-4 * np.random.default_rng(5).normal(size=times.size)
    return trimmer.Signal(values + noise, rate, "output", "")


def test_a_limit_cycle_gives_back_the_numbers_of_its_loop_from_its_period_too() -> None:
    places = ["element.level", "element.hysteresis"]
    fit = trimmer.fit(relay(1.0, 0.15), {"output": cycle(1.3, 0.2)}, places, settings=ONCE)
    for number, true in zip(fit.numbers, (1.3, 0.2), strict=True):
        assert number.lower is not None and number.upper is not None
        assert number.upper - number.lower < 1e-3 * true
        assert abs(number.value - true) < number.upper - number.lower
    assert fit.judgement.explained
    assert fit.judgement.freedom == 2 * fit.measured.lines.size + 1 - 3
    own = 1.0 / trimmer.periodic_orbits(relay(1.3, 0.2))[0].period
    assert abs(fit.measured.frequency - own) < 4.0 * fit.measured.frequency_deviation < 1e-6
    assert fit.subject.frequency is None
    # The orbit with which it begins is 7 % faster.
    assert abs(own * trimmer.periodic_orbits(relay(1.0, 0.15))[0].period - 1.0) > 1e-3


@pytest.mark.parametrize("loop", [relay(1.3, 0.3), relay(1.3, 0.2, 1.001)])
def test_of_one_number_the_period_may_speak_against_the_loop(loop: trimmer.ClosedLoop) -> None:
    # Of the faster one nothing but the period does.
    fit = trimmer.fit(loop, {"output": cycle(1.3, 0.2)}, ["element.level"], settings=ONCE)
    assert not fit.judgement.explained


AUTONOMOUS = trimmer.ClosedLoop(control.tf([1], [1, 3, 2, 0]), trimmer.Relay(1.0))
MOVED = trimmer.TrimmerLoop(trimmer.TrimmerParameters.thesis(), trimmer.FrictionBacklash(4e-5), DRIVE)


@pytest.mark.parametrize(
    ("loop", "output", "free", "told"),
    [
        (AUTONOMOUS, "start", [], "the loop has no output 'start'"),
        (driven(0.4, 1.5), "output", ["drive.phase"], "is fitted anyway"),
        (driven(0.4, 1.5), "output", ["start.x[0]"], "does not depend on it"),
        (driven(0.4, 1.5), "output", ["element.gap"], "after element comes threshold or slope"),
        (MOVED, "output", [], "does not tell whether it is a displacement"),
        (MOVED, "stroke", [], "the loop has no output 'stroke'; there are output"),
    ],
)
def test_what_cannot_be_fitted_of_a_loop_is_told(loop, output: str, free: list[str], told: str) -> None:
    with pytest.raises(trimmer.TrimmerError, match=told):
        trimmer.fit(loop, {output: record(0.3, 2.0)}, free, settings=ONCE)
