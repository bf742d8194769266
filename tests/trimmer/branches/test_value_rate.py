"""The derivative of a motion by a number of its mechanism against differences of the exact motion."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trimmer.branches.period_maps.mechanism_map import MechanismMap
from trimmer.contact.flow import ExactFlow
from trimmer.mechanism.mechanism import Mechanism

PLACES = (
    *("frequency", "plays.bridge.gap", "plays.bridge.damping", "plays.bridge.stiffness"),
    *("frictions.blade.force", "bodies.cutter.mass", "pins.pin.amplitude", 'links."motor mount".damping'),
)


@pytest.fixture(scope="module")
def twin() -> Mechanism:
    file = Path(__file__).parents[3] / "examples" / "thesis-play.toml"
    return Mechanism.from_toml(file).with_value("frictions.blade.force", 1.0)


@pytest.fixture(scope="module")
def state(twin: Mechanism) -> np.ndarray:
    """A state a little beside the orbit, from which contact and stick come and go."""
    flow = ExactFlow(twin)
    settled = flow.strobe(flow.rest(), 200).states[-1]
    return settled * (1.0 + 1e-2 * np.random.default_rng(1).normal(size=len(settled)))


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize(("periods", "mirrored"), [(1, True), (2, False)])
def test_derivative(twin: Mechanism, state: np.ndarray, place: str, periods: int, mirrored: bool) -> None:
    value = twin.value(place)
    map = MechanismMap(twin, place, value, periods, mirrored)
    passage = map.passage(value, state)
    step = 1e-6 * value
    ends = []
    for sign in (1.0, -1.0):
        flow = map.flow(value + sign * step)
        ends.append(map.course(flow, flow.at(passage.begin.state, like=passage.begin)).end.state)
    numeric = (-1.0 if mirrored else 1.0) * (ends[0] - ends[1]) / (2.0 * step)
    scaled = (passage.rate() - numeric) * value / passage.sizes
    assert abs(scaled).max() < 5e-6


def test_one_sided_derivative_at_the_end_of_the_range(twin: Mechanism, state: np.ndarray) -> None:
    map = MechanismMap(twin, "plays.bridge.gap", 1e-4)
    assert np.isfinite(map.passage(0.0, state).rate()).all()
