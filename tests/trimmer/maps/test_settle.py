from pathlib import Path

import pytest

from tests.trimmer.maps.machines import linear_oscillator
from trimmer import Mechanism, MotionKind, SerialRunner, motion_map
from trimmer.contact.flow import MechanismFlow
from trimmer.maps.settle import settle

TWIN = Mechanism.from_toml(Path(__file__).parents[3] / "examples" / "thesis-play.toml")


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


def test_a_block_that_friction_holds_repeats_with_the_drive() -> None:
    found = settled(Mechanism.from_toml_text(STUCK))
    assert found.kind is MotionKind.PERIODIC
    assert found.orbit is not None
    assert found.orbit.neutral
    assert found.orbit.period_count == 1
    assert found.orbit.measures.peak_to_peak["block"] == 0.0


def test_starts_from_which_friction_holds_a_block_lead_to_one_motion() -> None:
    result = motion_map(
        Mechanism.from_toml_text(STUCK),
        {"frequency": [20.0, 21.0]},
        starts=4,
        runner=SerialRunner(),
        quiet=True,
    )
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
