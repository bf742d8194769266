"""What a map is made from: values that fit together, and as many as there may be."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

from tests.trimmer.maps.machines import impact_oscillator
from trimmer import __version__
from trimmer.errors import MapError, MechanismError
from trimmer.maps import inputs as map_inputs
from trimmer.maps.basin import _start_place
from trimmer.maps.inputs import MOST_CELLS, Settings, checked_inputs, varied
from trimmer.maps.motion_map import _how_to_go_on
from trimmer.mechanism import Mechanism


def test_places_of_a_basin_are_initial_values() -> None:
    assert _start_place("mass.velocity") == "start.mass.velocity"
    assert _start_place("start.mass.displacement") == "start.mass.displacement"
    for place in ("mass.gap", "a.mass.velocity", "velocity"):
        with pytest.raises(MapError):
            _start_place(place)


def test_values_are_set_in_whatever_order_they_fit() -> None:
    twin = Mechanism.from_toml(Path(__file__).parents[3] / "examples" / "thesis-play.toml")
    static = twin.with_value("frictions.blade.static", 1.0)
    places = ("frictions.blade.force", "frictions.blade.static")
    # The force alone cannot rise above the static one, nor that fall below the force.
    raised = varied(static, places, (2.0, 3.0))
    assert [raised.value(place) for place in places] == [2.0, 3.0]
    lowered = varied(raised, places[::-1], (0.5, 0.25))
    assert [lowered.value(place) for place in places] == [0.25, 0.5]
    with pytest.raises(MechanismError):
        varied(static, places, (3.0, 2.0))


def test_a_value_must_fit_to_one_of_the_other_place() -> None:
    twin = Mechanism.from_toml(Path(__file__).parents[3] / "examples" / "thesis-play.toml")
    static = twin.with_value("frictions.blade.static", 1.0)
    force, other = "frictions.blade.force", "frictions.blade.static"
    for places in ({force: [0.5, 1.5], other: [1.0, 2.0]}, {other: [1.0, 2.0], force: [0.5, 1.5]}):
        assert checked_inputs(static, places, Settings()).count == 4
    for places in ({force: [0.5, 2.5], other: [1.0, 2.0]}, {other: [1.0, 2.0], force: [0.5, 2.5]}):
        with pytest.raises(MechanismError):
            checked_inputs(static, places, Settings())
    with pytest.raises(MechanismError):
        checked_inputs(static, {force: [0.5, 1.5]}, Settings())


def test_as_many_cells_as_fit_are_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    assert MOST_CELLS == 4_000_000
    monkeypatch.setattr(map_inputs, "MOST_CELLS", 6)
    values = {"frequency": [1.0, 1.1, 1.2], "stops.wall.gap": [8.0, 10.0]}
    assert checked_inputs(impact_oscillator(), values, Settings()).count == 6
    with pytest.raises(MapError, match="at most 6"):
        checked_inputs(impact_oscillator(), {**values, "stops.wall.gap": [8.0, 9.0, 10.0]}, Settings())


def test_an_interrupt_says_what_is_kept() -> None:
    assert "3 of 8 cells, which are lost" in _how_to_go_on(3, 8, None)
    assert "3 of 8 cells, which map.jsonl holds" in _how_to_go_on(3, 8, Path("map.jsonl"))


def test_the_header_of_a_file_holds_all_that_cells_depend_on_and_a_digest_of_it() -> None:
    values = {"frequency": [1.0, 1.1], "stops.wall.gap": [8.0]}
    inputs = checked_inputs(impact_oscillator(), values, Settings(12, 3, 5))
    header = inputs.header
    content = {
        "mechanism": impact_oscillator().to_toml(),
        "places": ["frequency", "stops.wall.gap"],
        "settings": {"most_periods": 12, "seed": 5, "starts": 3},
        "values": [[1.0, 1.1], [8.0]],
    }
    digest = hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
    assert header == {**content, "trimmer map": 1, "program": __version__, "inputs": digest}
    assert (Settings().most_periods, Settings().starts, Settings().seed) == (300, 1, 0)
