"""Which motions are one, and what those are called that do not repeat: the same wherever it is asked."""

import json
from dataclasses import replace

import control
import numpy as np
import pytest

from tests.quick import quick
from tests.trimmer.maps.machines import impact_oscillator
from trimmer import ClosedLoop, Mechanism, Relay, SerialRunner, basin, motion_map, periodic_orbits, respond
from trimmer.command_line.main import main
from trimmer.design import DesignSettings, NumberRole, VariedNumber
from trimmer.design.motions import motions_from_starts, with_neighbours
from trimmer.mechanism import Body, Output, Pin, Play
from trimmer.one_orbit import COARSE, ClosedCurve, are_one, inaccuracy

OMEGA = 7.5  # Here a motion with contact coexists with one without
STARTS = {"mass.displacement": np.linspace(-20.0, 20.0, 3), "mass.velocity": np.linspace(-150.0, 150.0, 3)}


def test_all_that_count_motions_count_the_same() -> None:
    machine = impact_oscillator(OMEGA)
    settled = respond(machine, starts=12).motions
    reached = basin(machine, STARTS, most_periods=300, runner=SerialRunner(), quiet=True)
    cell = motion_map(machine, {"frequency": [machine.frequency]}, starts=12, runner=SerialRunner())
    assert len(settled) == len(reached.motions) == cell.motion_count[0, 0] == 2


@pytest.mark.parametrize("outputs", quick([{"x": Output({"mass": 1.0})}, {}], 1))
def test_a_design_finds_the_other_motion_whatever_is_measured(outputs: dict[str, Output]) -> None:
    """Without outputs all orbits of one period had the same measures, and were taken for one."""
    machine = replace(impact_oscillator(OMEGA), outputs=outputs)
    settings = DesignSettings(starts=1, neighbours=3, most_periods=300, cell_periods=300)
    found = motions_from_starts(machine, settings)
    varied = (
        VariedNumber(NumberRole.SPEED, "frequency", "", "Hz", machine.value("frequency"), 0.5, 3.0),
        VariedNumber(NumberRole.GAP, "stops.wall.gap", "wall", "m", 10.0, 1.0, 30.0),
    )
    assert len(found.found) == 1
    assert len(with_neighbours(machine, found, varied, settings, SerialRunner()).found) == 2


def test_guesses_that_lead_to_one_orbit_of_a_loop_give_one() -> None:
    loop = ClosedLoop(control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), Relay(1.0, hysteresis=0.05))
    (predicted,) = periodic_orbits(loop)
    near = [(a * predicted.amplitude, w * predicted.omega) for a in (0.8, 1.2) for w in (0.9, 1.1)]
    near += [(predicted.amplitude, predicted.omega / several) for several in (3, 15, 25)]  # of many periods
    (again,) = periodic_orbits(loop, near)
    assert again.period == pytest.approx(predicted.period, rel=1e-9)


@pytest.mark.parametrize(
    ("multipliers", "known"),
    [([0.99, -0.99], 1e-10), ([-1.0, -0.5], 1e-12), ([1.0, 0.9], 1e-11), ([], 1e-12)],
)
def test_a_state_is_known_as_well_as_the_slowest_return_tells(multipliers: list[float], known: float) -> None:
    assert inaccuracy(1e-12, np.array(multipliers)) == pytest.approx(known)


def rattling() -> Mechanism:
    """A free body in a slot around a pin: it meets the pin now here, now there."""
    return Mechanism(
        {"body": Body(1.0)},
        frequency=1.0,
        pins={"pin": Pin("ground", amplitude=1.0)},
        plays={"slot": Play(("pin", "body"), stiffness=4000.0, damping=0.5, gap=1.0)},
        outputs={"body": Output({"body": 1.0})},
        title="Rattling",
    )


WAITED = "over 60 drive periods"


def test_samples_say_how_long_chaos_was_waited_for(tmp_path, capsys) -> None:
    path = tmp_path / "rattling.toml"
    scatter = '[uncertainty]\n"bodies.body.mass" = { normal = "1e-6 kg" }\n'
    path.write_text(f"{rattling().to_toml()}\n{scatter}")
    words = ["sample", str(path), "--count", "3", "--periods", "60"]
    assert main([*words, "--json"]) == 0
    assert list(json.loads(capsys.readouterr().out)["kinds"]) == [f"chaotic {WAITED}"]
    assert main(words) == 0
    assert f"chaotic {WAITED}  100.0% of 3" in capsys.readouterr().out


def test_one_that_stands_for_its_kind_says_so() -> None:
    values = {"body.velocity": [0.0, 0.1, 0.2]}
    settings = {"most_periods": 60, "runner": SerialRunner(), "quiet": True}
    reached = basin(rattling(), values, **settings)
    assert reached.names == (f"1: chaotic {WAITED} (all such)",)
    several = motion_map(rattling(), {"frequency": [1.0]}, starts=3, **settings)
    assert several.motion_count[0, 0] == 1
    assert several.searched.endswith("where all of a cell that do not repeat count as one of each kind")


def test_an_orbit_that_begins_in_a_quick_pass_of_a_crossing_is_found_beside_the_slow_pass() -> None:
    """A figure of eight; its crossing is passed 19 times as fast the second time, between coarse points."""

    def path(times: np.ndarray, size: float = 1.0) -> np.ndarray:
        phase = 2.0 * np.pi * times - 0.9 * np.sin(2.0 * np.pi * times)
        return size * np.stack([np.sin(phase), np.sin(2.0 * phase)], axis=1)

    times = np.arange(64) / 64
    begun = (times + 0.5 + 0.47 / COARSE) % 1.0
    curve = ClosedCurve(1.0, path(times)[None], np.ones(2), path=path)
    assert are_one(ClosedCurve(1.0, path(begun)[None], np.ones(2)), curve)
    assert not are_one(ClosedCurve(1.0, path(begun, 1.0 + 1e-5)[None], np.ones(2)), curve)
