"""The derivative of a motion by a number of its mechanism against differences of the exact motion.

Tangents of branches rest on it; it goes through contacts, stick and springs that relax.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from trimmer import ContactLaw, Mechanism
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.contact.flow import MechanismFlow
from trimmer.motion.part import Phase

PLACES = (
    *("frequency", "plays.bridge.gap", "plays.bridge.damping", "plays.bridge.stiffness"),
    *("frictions.blade.force", "bodies.cutter.mass", "pins.pin.amplitude"),
)


@pytest.fixture(scope="module", params=[ContactLaw.PULLING, ContactLaw.RELAXING])
def twin(request: pytest.FixtureRequest) -> Mechanism:
    file = Path(__file__).parents[3] / "examples" / "thesis-play.toml"
    found = Mechanism.from_toml(file).with_value("frictions.blade.force", 1.0)
    plays = {name: replace(play, law=request.param) for name, play in found.plays.items()}
    return replace(found, plays=plays)


@pytest.fixture(scope="module")
def state(twin: Mechanism) -> np.ndarray:
    """A state a little beside the orbit, from which contact and stick come and go."""
    flow = MechanismFlow(twin)
    settled = flow.strobe(flow.rest(), 200).states[-1]
    return settled * (1.0 + 1e-2 * np.random.default_rng(1).normal(size=len(settled)))


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize(("periods", "mirrored"), [(3, True), (2, False)])
def test_the_derivative_is_that_of_the_end(
    twin: Mechanism, state: np.ndarray, place: str, periods: int, mirrored: bool
) -> None:
    value = twin.value(place)
    map = DrivenMap(twin, place, value, periods, mirrored)
    passage = map.passage(value, state)
    step, ends = 1e-6 * value, []
    for sign in (1.0, -1.0):
        flow = map.flow(value + sign * step)
        begin, duration = flow.at(passage.begin.state, like=passage.begin), periods * flow.period
        ends.append(flow.timed(begin, duration / 2 if mirrored else duration).end.state)
    numeric = (-1.0 if mirrored else 1.0) * (ends[0] - ends[1]) / (2.0 * step)
    scaled = (passage.rate - numeric) * value / passage.sizes
    assert abs(scaled).max() < 5e-6


def test_what_is_never_touched_has_no_shortest_contact(twin: Mechanism, state: np.ndarray) -> None:
    wide = DrivenMap(twin.with_value("plays.bridge.gap", 1.0), "frequency", twin.frequency)
    passage = wide.passage(twin.frequency, state)
    assert passage.shortest("bridge", Phase.UPPER) == np.inf and not passage.opens("bridge", Phase.UPPER)


def test_where_a_number_can_be_no_larger_the_difference_is_taken_below(
    twin: Mechanism, state: np.ndarray
) -> None:
    """Kinetic friction does not exceed the static one."""
    map = DrivenMap(twin.with_value("frictions.blade.static", 1.0), "frictions.blade.force", 1.0)
    found, beside = (map.passage(force, state) for force in (1.0, 1.0 - 1e-6))
    scaled = (found.rate - (found.end - beside.end) / 1e-6) / found.sizes
    assert abs(scaled).max() < 1e-4


def test_motions_that_are_held_stay_while_others_are_followed(twin: Mechanism, state: np.ndarray) -> None:
    """The tables of a value are written where those of another one were, but never where they are held."""
    place = "plays.bridge.gap"
    values = (twin.value(place) * np.linspace(0.8, 1.2, 12)).tolist()
    map = DrivenMap(twin, place, values[0])
    for value, held in [(value, map.passage(value, state)) for value in values]:
        alone = DrivenMap(twin, place, value).passage(value, state)
        assert held.sizes == pytest.approx(alone.sizes, rel=1e-9)
