"""What is seen of a motion over a window, where the motion is known on paper."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.contact.flow import ExactFlow
from trimmer.mechanism import Body, Force, Link, Mechanism, Output, Stop
from trimmer.response.window import joined, watch

STIFFNESS, DAMPING, OMEGA = 40.0, 0.6, 7.5
PERIOD = 2 * np.pi / OMEGA


def oscillator(damping: float = DAMPING, **changes) -> Mechanism:
    """A body of 1 kg on a spring, seen at 7.5 rad/s."""
    return Mechanism(
        {"body": Body(1.0)},
        frequency=OMEGA / (2 * np.pi),
        links={"spring": Link(("ground", "body"), STIFFNESS, damping)},
        outputs={"x": Output({"body": 1.0})},
        **changes,
    )


@pytest.fixture(scope="module")
def steady():
    """The steady motion under 50 N + 100 N sin, over 24 periods."""
    flow = ExactFlow(oscillator(forces={"push": Force("body", constant=50.0, amplitude=100.0)}))
    return watch(flow, flow.strobe(flow.rest(), 200).end, 24)


AMPLITUDE = 100 / abs(STIFFNESS - OMEGA**2 + 1j * DAMPING * OMEGA)


def test_sums_of_a_steady_motion_about_its_mean(steady) -> None:
    assert steady.periods == 24
    assert steady.means[:, 0] == pytest.approx([50 / STIFFNESS] * 3, rel=1e-11)
    assert steady.rms["x"].value == pytest.approx(AMPLITUDE / np.sqrt(2), rel=1e-10)
    assert steady.rms["x"].uncertainty < 1e-9
    assert steady.harmonics["x"][0] == pytest.approx(AMPLITUDE, rel=1e-10)
    assert steady.harmonics["x"][1:].max() < 1e-10
    assert steady.peak_to_peak["x"] == pytest.approx(2 * AMPLITUDE, rel=1e-10)
    assert steady.rms_acceleration["body"].value == pytest.approx(
        OMEGA**2 * AMPLITUDE / np.sqrt(2), rel=1e-10
    )
    assert steady.events.sum() == 0


def test_the_states_are_those_at_the_starts_of_periods(steady) -> None:
    response = 100 / (STIFFNESS - OMEGA**2 + 1j * DAMPING * OMEGA)
    expected = 50 / STIFFNESS + response.imag, OMEGA * response.real
    np.testing.assert_allclose(steady.states, np.tile(expected, (24, 1)), rtol=1e-10)


def test_the_exponents_add_up_to_the_divergence_of_the_flow(steady) -> None:
    """Both are half of it, up to what the turning of the distances makes over 160 periods."""
    values = [each.value for each in watch(steady.flow, steady.end, 160).exponents]
    assert sum(values) == pytest.approx(-DAMPING * PERIOD, rel=1e-10)
    assert values == pytest.approx([-DAMPING * PERIOD / 2] * 2, abs=0.03)


def test_the_power_density_of_a_sine_adds_up_to_its_mean_square(steady) -> None:
    frequencies, density = steady.spectrum
    assert frequencies[np.argmax(density["x"])] == pytest.approx(OMEGA / (2 * np.pi), rel=1e-12)
    assert density["x"].sum() * frequencies[1] == pytest.approx(AMPLITUDE**2 / 2, rel=1e-6)


def test_events_are_counted_per_period() -> None:
    """A body that a stop at 0 meets and leaves once in each of its own oscillations."""
    mechanism = oscillator(0.0, stops={"wall": Stop(("ground", "body"), STIFFNESS * 3, 0.0, 0.0)},
                           start={"body": (-1.0, 0.0)})  # fmt: skip
    flow = ExactFlow(mechanism)
    window = watch(flow, flow.rest(), 16)
    # Half a period on the spring alone, then half of one on both, with twice the frequency.
    own = np.pi / np.sqrt(STIFFNESS) * 1.5
    assert window.events.mean() == pytest.approx(2 * PERIOD / own, abs=2 / 16)


def test_extremes_are_those_of_all_rows() -> None:
    flow = ExactFlow(oscillator(start={"body": (1.0, 0.0)}))
    window = watch(flow, flow.rest(), 16)
    ratio = DAMPING / (2 * np.sqrt(STIFFNESS))
    lowest = -np.exp(-np.pi * ratio / np.sqrt(1 - ratio**2))
    assert window.peak_to_peak["x"] == pytest.approx(1 - lowest, rel=1e-10)


def test_a_line_beside_a_harmonic_is_none_of_it() -> None:
    """A free oscillation at 17/16 of the drive's frequency turns once against it in 16 periods."""
    stiffness = (17 / 16 * OMEGA) ** 2
    mechanism = Mechanism(
        {"body": Body(1.0)}, OMEGA / (2 * np.pi), links={"spring": Link(("ground", "body"), stiffness)},
        start={"body": (1.0, 0.0)}, outputs={"x": Output({"body": 1.0})},
    )  # fmt: skip
    flow = ExactFlow(mechanism)
    first = watch(flow, flow.rest(), 8)
    window = joined(first, watch(flow, first.end, 8))
    assert window.periods == 16
    assert first.harmonics["x"][0] > 0.5
    assert window.harmonics["x"][0] < 1e-10
    np.testing.assert_allclose(window.states[8], first.end.state, rtol=1e-10, atol=1e-12)
