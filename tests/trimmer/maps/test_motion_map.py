"""Maps over one number or two: cells, runners, starts, what they settle to, and what is refused."""

import multiprocessing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from tests.quick import quick
from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer import Mechanism, MotionKind, Pin, Play, SerialRunner, Stop, TrimmerError, motion_map, respond
from trimmer.contact.flow import MechanismFlow
from trimmer.errors import MapError, MechanismError
from trimmer.examples import example_text
from trimmer.maps.cells import CellWork, start_scales
from trimmer.maps.inputs import Settings, checked_inputs
from trimmer.maps.motion_map import MapInterruptedError
from trimmer.maps.settle import settle
from trimmer.runners import ProcessRunner

TWIN = Mechanism.from_toml(Path(__file__).parents[3] / "examples" / "thesis-play.toml")
PLACES = {"plays.bridge.gap": [40e-6, 200e-6, 400e-6], "frictions.blade.force": [0.1, 1.0, 2.0, 4.0]}
SERIAL = SerialRunner()


@pytest.fixture(scope="module")
def twin():
    return motion_map(TWIN, PLACES, runner=SERIAL)


class Backwards:
    """A runner of another kind: it takes all cells and does the last one first."""

    def results(self, work, cells):
        return map(work, reversed(list(cells)))


def test_arrays_have_a_row_for_each_value_of_the_second_place(twin) -> None:
    assert twin.shape == twin.stroke.shape == twin.kind.shape == twin.period_count.shape == (4, 3)
    assert list(twin.rms_acceleration) == ["motor", "cutter", "housing", "guard"]
    assert twin.wear_power["blade"].shape == (4, 3)
    assert not twin.failures
    assert np.isfinite(twin.stroke).all()


def test_cells_are_what_their_values_settle_to(twin) -> None:
    assert twin.period_count[1, 0] == 1
    assert twin.period_count[2, 1] == 3  # in the words: 0.2 mm and 2 N repeat after three periods
    assert twin.stroke[1, 0] == pytest.approx(2.933334121400e-3, rel=5e-13)
    assert twin.rms_acceleration["motor"][1, 0] == pytest.approx(118.754895, abs=5e-7)
    assert twin.events[1, 0] == 14
    assert twin.kind[0, 2] is MotionKind.CHAOTIC
    assert twin.lyapunov[0, 2] > 0
    assert np.isnan(twin.lyapunov[1, 0])
    assert twin.largest_multiplier[1, 0] < 1


@pytest.mark.parametrize("cell", [(1, 0), (2, 1)])
def test_a_cell_is_what_respond_finds(twin, cell) -> None:
    row, column = cell
    mechanism = TWIN.with_value("plays.bridge.gap", PLACES["plays.bridge.gap"][column])
    (motion,) = respond(
        mechanism.with_value("frictions.blade.force", PLACES["frictions.blade.force"][row])
    ).motions
    assert (motion.kind, motion.period_count) == (twin.kind[cell], twin.period_count[cell])
    measures = motion.orbit.measures
    assert twin.stroke[cell] == pytest.approx(measures.peak_to_peak["stroke"], rel=1e-9)
    assert twin.events[cell] == measures.events_per_period
    assert twin.impacts[cell] == measures.contacts["bridge"].impacts
    assert twin.impact_speed[cell] == pytest.approx(measures.contacts["bridge"].impact_speed, rel=1e-8)
    assert twin.wear_power["blade"][cell] == pytest.approx(measures.frictions["blade"].power, rel=1e-9)
    for body, accelerations in twin.rms_acceleration.items():
        assert accelerations[cell] == pytest.approx(measures.rms_acceleration[body], rel=1e-9)


@pytest.mark.parametrize("runner", quick([ProcessRunner(1), ProcessRunner(2), Backwards()], 1, 2))
def test_who_does_the_cells_and_in_what_order_changes_no_bit(twin, runner) -> None:
    assert motion_map(TWIN, PLACES, runner=runner).cells == twin.cells


def test_other_cells_beside_it_change_no_bit_of_a_cell(twin) -> None:
    alone = motion_map(TWIN, {"plays.bridge.gap": [400e-6], "frictions.blade.force": [0.1]}, runner=SERIAL)
    assert alone.cells[0].motions == twin.cells[2].motions


def test_random_starts_belong_to_their_cell() -> None:
    inputs = checked_inputs(impact_oscillator(), {"frequency": [1.1, 1.2]}, Settings(starts=6, seed=3))
    first = motion_map(impact_oscillator(), {"frequency": [1.1, 1.2]}, starts=6, seed=3, runner=SERIAL)
    again = motion_map(impact_oscillator(), {"frequency": [1.1, 1.2]}, starts=6, seed=3, runner=Backwards())
    other = motion_map(impact_oscillator(), {"frequency": [1.1, 1.2]}, starts=6, seed=4, runner=SERIAL)
    assert first.inputs == inputs
    assert first.cells == again.cells
    assert [sum(motion.starts for motion in cell.motions) for cell in first.cells] == [6, 6]
    assert [cell.motions for cell in first.cells] != [cell.motions for cell in other.cells]
    assert "5 random states (seed 3)" in first.searched


def test_one_place_gives_one_row() -> None:
    found = motion_map(linear_oscillator(), {"frequency": [1.0, 1.5]}, runner=SERIAL)
    assert found.shape == (1, 2)
    omega = 2 * np.pi * np.array([1.0, 1.5])
    amplitudes = 100 / abs(40 - omega**2 + 0.1j * np.sqrt(40) * omega)
    np.testing.assert_allclose(found.stroke[0], 2 * amplitudes, rtol=1e-9)
    assert "not looked for" in found.searched


def test_values_that_go_together_only_with_some_others_fail_in_their_cells_alone() -> None:
    mechanism = TWIN.with_value("frictions.blade.static", 1.0)
    places = {"frictions.blade.force": [0.5, 1.5], "frictions.blade.static": [1.0, 2.0]}
    found = motion_map(mechanism, places, most_periods=2, runner=SERIAL)
    assert list(found.failures) == [(0, 1)]
    assert "never less" in found.failures[0, 1]
    assert found.kind[0, 1] is MotionKind.UNDECIDED
    assert np.isnan(found.stroke[0, 1])
    assert np.isfinite(np.delete(found.stroke.ravel(), 1)).all()


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"plays.bridge.gap": [1e-5, -1e-5]}, "plays.bridge.gap = -1e-05: must be zero or greater"),
        ({"plays.bridg.gap": [1e-5]}, "did you mean plays.bridge.gap"),
        ({"plays.bridge.gap": []}, "no value of plays.bridge.gap"),
        ({"plays.bridge.gap": [1e-5, 1e-5]}, "is there twice"),
        ({"plays.bridge.gap": [float("nan")]}, r"plays.bridge.gap\[0\] must be finite"),
        ({"plays.bridge.gap": "40 um"}, "must be a sequence of numbers"),
        ({"plays.bridge.gap": [1e-5], 'plays."bridge".gap': [2e-5]}, "both places are plays.bridge.gap"),
        ({}, "one place or two, not 0"),
        ({"plays.bridge.gap": range(9999), "frictions.blade.force": range(9999)}, "at most 4000000"),
        ({3: [1.0]}, "place must be a dotted place"),
        ([], "values must be a mapping"),
    ],
)
def test_what_cannot_be_varied_is_told_before_the_run(values, message: str) -> None:
    with pytest.raises((TrimmerError, ValueError), match=message):
        motion_map(TWIN, values)


@pytest.mark.parametrize(("name", "least"), [("most_periods", 2), ("starts", 1), ("seed", 0)])
def test_settings_are_whole_numbers_from_the_least_on(name: str, least: int) -> None:
    with pytest.raises(ValueError, match=f"{name} must be a whole number"):
        motion_map(TWIN, PLACES, **{name: least - 1})
    found = motion_map(linear_oscillator(), {"frequency": [1.0]}, runner=SERIAL, **{name: least})
    assert vars(found.inputs.settings) == {**vars(Settings()), name: least}


def test_what_is_not_there_is_not_asked_for() -> None:
    for name in ("resume", "overwrite"):
        with pytest.raises(MapError, match=f"^{name} is of a file"):
            motion_map(TWIN, PLACES, **{name: True})
    found = motion_map(replace(linear_oscillator(), outputs={}), {"frequency": [1.0]}, runner=SERIAL)
    with pytest.raises(MapError, match="no output"):
        _ = found.stroke


def test_values_are_set_in_whatever_order_they_fit() -> None:
    """The force alone cannot rise above the static one, nor that fall below the force."""
    static = TWIN.with_value("frictions.blade.static", 1.0)
    for force, most in ((2.0, 3.0), (0.25, 0.5)):
        pairs = {"frictions.blade.force": [force], "frictions.blade.static": [most]}
        for values in (pairs, dict(reversed(pairs.items()))):
            assert not motion_map(static, values, most_periods=2, runner=SERIAL).failures
    with pytest.raises(MechanismError):
        motion_map(static, {"frictions.blade.force": [0.5, 1.5]})


@pytest.mark.parametrize(
    ("settings", "begin", "told"),
    [
        ({}, None, "2 cells, each from rest, for at most 300 drive periods; other motions were not looked"),
        ({"starts": 2}, None, "each from rest and from 1 random state"),
        ({"starts": 3, "seed": 5}, None, "each from rest and from 2 random states (seed 5)"),
        ({"most_periods": 44}, 1.0, "each from the mechanism's own start, for at most 44"),
    ],
)
def test_it_is_said_what_was_searched(settings: dict[str, int], begin: float | None, told: str) -> None:
    mechanism = linear_oscillator()
    if begin is not None:
        mechanism = mechanism.with_value("start.mass.velocity", begin)
    found = motion_map(mechanism, {"frequency": [1.0, 1.5]}, runner=SERIAL, **settings)
    assert told in found.searched


def test_several_motions_of_cells_are_counted_by_their_starts() -> None:
    """Between grazing and fold random starts lead to both motions."""
    found = motion_map(impact_oscillator(), {"frequency": [1.19, 1.2]}, starts=8, seed=1, runner=SERIAL)
    assert found.motion_count.tolist() == [[2, 2]]
    assert [sum(each.starts for each in cell.motions) for cell in found.cells] == [8, 8]
    assert "; 2 of them have several motions" in found.searched
    first = [cell.motions[0].measures.peak_to_peak["x"] for cell in found.cells]
    assert found.stroke[0].tolist() == first


@pytest.mark.parametrize(
    ("parts", "length"),
    [
        ({}, 1e-3),
        ({"pins": {"pin": Pin("ground", amplitude=-0.2)}}, 0.2),
        ({"plays": {"play": Play(("ground", "mass"), 10.0, gap=0.3)}}, 0.3),
        ({"stops": {"stop": Stop(("ground", "mass"), 10.0, gap=-0.5)}}, 0.5),
    ],
)
def test_random_starts_go_as_far_as_the_largest_amplitude_or_gap(parts, length: float) -> None:
    flow = MechanismFlow(replace(linear_oscillator(), **parts))
    assert start_scales(flow)[:2] == pytest.approx([length, length * 7.5], rel=1e-12)


def test_an_interrupt_tells_how_far_it_came() -> None:
    class Interrupted:
        def results(self, work: CellWork, cells):
            yield work(next(iter(cells)))
            raise KeyboardInterrupt

    with pytest.raises(MapInterruptedError, match="after 1 of 12 cells, which are lost"):
        motion_map(TWIN, PLACES, runner=Interrupted(), most_periods=2)


def test_an_error_of_the_program_stops_no_process_behind() -> None:
    with pytest.raises(MechanismError):
        motion_map(TWIN, {"frequency": [0.0]}, runner=ProcessRunner(1))
    assert multiprocessing.active_children() == []


@pytest.mark.slow
def test_chaos_is_named_with_the_periods_that_were_waited() -> None:
    """It may be a transient: what is chaotic over 120 periods may repeat later."""
    wide = TWIN.with_value("plays.bridge.gap", 200e-6)
    result = motion_map(wide, {"frictions.blade.force": [0.4, 4.0]}, most_periods=120, quiet=True)
    assert [kind.word for kind in result.kind[0]] == ["chaotic", "periodic"]
    assert list(result.counts) == ["chaotic over 120 drive periods", "period 1"]
    assert result.passing.startswith("1 cell is chaotic over the 120 drive periods")
    names = [text.get_text() for text in result.plot(Figure().add_subplot()).get_legend().get_texts()]
    assert names == ["period 1", "chaotic over 120 drive periods"]
    chaotic = respond(wide.with_value("frictions.blade.force", 0.4), most_periods=120)
    assert "Chaos over 632 drive periods may still be a transient" in chaotic.message


@pytest.mark.slow
def test_small_distances_grow_as_respond_finds_over_more_periods() -> None:
    """Both follow a neighbour, a map over a hundred drive periods and respond over many more."""
    wide = TWIN.with_value("plays.bridge.gap", 400e-6)
    found = motion_map(wide, {"frictions.blade.force": [0.1]}, runner=SERIAL)
    longer = respond(wide.with_value("frictions.blade.force", 0.1)).motion.lyapunov
    assert found.lyapunov[0, 0] == pytest.approx(longer.value, rel=0.35)


def settled(mechanism: Mechanism, periods: int = 300):
    flow = MechanismFlow(mechanism)
    return settle(flow, flow.rest(), periods)


def test_two_frequencies_without_damping_are_a_torus() -> None:
    # An undamped oscillator from rest moves with its own frequency beside that of the drive for ever.
    mechanism = linear_oscillator().with_value("links.spring.damping", 0.0)
    found = settled(mechanism)
    assert found.kind is MotionKind.TORUS
    assert found.lyapunov == pytest.approx(0.0, abs=0.02)


STUCK = """
frequency = 20.0
[bodies]
block = { mass = 0.5 }
[pins]
pin = { on = "ground", amplitude = 1e-3 }
[plays]
fork = { between = ["pin", "block"], stiffness = 2e3, damping = 1.0, gap = 1e-4 }
[frictions]
floor = { between = ["ground", "block"], force = 10.0 }
[outputs]
block = { block = 1 }
"""
"""The fork pushes with 2 N or so: too little for the friction, which holds the block wherever it is."""


def test_starts_from_which_friction_holds_a_block_lead_to_one_motion() -> None:
    stuck = Mechanism.from_toml_text(STUCK)
    result = motion_map(stuck, {"frequency": [20.0, 21.0]}, starts=4, runner=SerialRunner())
    assert [len(cell.motions) for cell in result.cells] == [1, 1]
    assert [cell.motions[0].starts for cell in result.cells] == [4, 4]


@pytest.mark.parametrize("periods", [2, 24, 25, 150])
def test_as_many_periods_are_waited_as_are_given(periods: int) -> None:
    """Two frequencies that damp so little that nothing settles within so short a time."""
    restless = TWIN.with_value("frictions.blade.force", 0.0)
    assert settled(restless, periods).periods == periods


def test_what_meets_no_event_needs_no_patience() -> None:
    found = settled(linear_oscillator().with_value("links.spring.damping", 0.01), periods=40)
    assert found.kind is MotionKind.PERIODIC
    assert found.periods <= 40


STAYING = """
frequency = 20.0
[bodies]
block = { mass = 1.0 }
[frictions]
rub = { between = ["ground", "block"], force = 1.0 }
[links]
wire = { between = ["ground", "block"], stiffness = 1.0 }
[stops]
wall = { between = ["ground", "block"], stiffness = 1e3, gap = 0.01 }
[forces]
none = { on = "block", amplitude = 0.0 }
"""


def test_rests_of_friction_are_one_unless_other_parts_bear() -> None:
    """A block stays wherever it stopped, free or pressed against its wall."""
    block = Mechanism.from_toml_text(STAYING)
    (cell,) = motion_map(block, {"frequency": [20.0]}, starts=12, runner=SerialRunner()).cells
    assert [motion.kind for motion in cell.motions] == [MotionKind.REST] * 2
    assert sorted(motion.states[0][0] > 0.01 for motion in cell.motions) == [False, True]
    assert sum(motion.starts for motion in cell.motions) == 12


def test_a_block_on_a_belt_needs_no_drive() -> None:
    """It sticks to a slow belt until the spring tears it off at 1 N; above 0.5 m/s it never sticks."""
    slow, fast = [0.1, 0.2, 0.4], [0.51, 1.0]
    cells = motion_map(
        Mechanism.from_toml_text(example_text("block-on-belt")),
        {"pins.belt.velocity": [*slow, *fast]},
        runner=SERIAL,
    ).cells
    swings = [cell.motions[0].measures.peak_to_peak["block"] for cell in cells]
    assert [cell.motions[0].kind for cell in cells] == [MotionKind.PERIODIC] * 5
    assert swings == pytest.approx([*(2 * np.hypot(0.5, slow)), 1.0, 1.0], rel=1e-12)
    assert [cell.motions[0].neutral for cell in cells] == [False] * 3 + [True] * 2
    damped = Mechanism.from_toml_text(example_text("block-on-belt")).with_value("links.spring.damping", 0.5)
    (cell,) = motion_map(damped, {"pins.belt.velocity": [1.0]}, runner=SERIAL).cells
    measures = cell.motions[0].measures
    assert (cell.motions[0].kind, measures.peak_to_peak["block"]) == (MotionKind.REST, 0.0)
    assert measures.wear_power["rubbing"] == pytest.approx(0.5, rel=1e-9)  # The belt slides on below it.
