"""Orbits that rest on an edge: their multipliers are those of one side, and this is said."""

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import expm

from tests.trimmer.response.mechanisms import twin
from trimmer import Mechanism, forced_orbit, respond
from trimmer.command_line.main import main

TOUCHING = """
frequency = {frequency}
[bodies]
block = {{ mass = 1.0 }}
[links]
spring = {{ between = ["ground", "block"], stiffness = 100.0, damping = {damping} }}
[stops]
wall = {{ between = ["ground", "block"], stiffness = 1000.0, damping = 1.0, gap = {gap}, law = "{law}" }}
"""
FREE, HELD = (100.0, 0.5), (1100.0, 1.5)
"""Stiffness, N/m, and damping, N s/m, on both sides of the place where the wall begins."""


def touching(
    frequency: float = 40.0, gap: float = 0.0, damping: float = 0.5, law: str = "relaxing"
) -> Mechanism:
    text = TOUCHING.format(frequency=frequency, gap=gap, damping=damping, law=law)
    return Mechanism.from_toml_text(text)


BENT = """
frequency = 40.0
[bodies]
block = { mass = 1.0 }
[links]
spring = { between = ["ground", "block"], curve = [[-1, -100], [0, 0], [1, 1100]], damping = 0.5 }
"""
LIMITED = """
frequency = 40.0
[bodies]
block = { mass = 1.0 }
[links]
spring = { between = ["ground", "block"], stiffness = 100.0, damping = 0.5 }
[outputs]
place = { block = 1 }
[controllers.axis]
kind = "pid"
measure = "place"
acts = ["ground", "block"]
reference = "path"
kp = 100.0
limit = 1.0
[references]
path = { step = 0.02 }
"""


def flow(side: tuple[float, float], duration: float) -> np.ndarray:
    """The closed form of the linear motion on a side."""
    return expm(duration * np.array([[0.0, 1.0], [-side[0], -side[1]]]))


def moving(multipliers: np.ndarray) -> np.ndarray:
    return np.sort_complex(multipliers[abs(multipliers) > 1e-6])


@pytest.mark.parametrize("guess", [None, {"block": (1e-3, 0.0)}])
@pytest.mark.parametrize("law", ["relaxing", "truncated", "pulling"])
def test_a_block_that_just_touches_has_the_multipliers_of_either_side(law: str, guess) -> None:
    orbit = forced_orbit(touching(law=law), guess=guess)
    sides = [np.sort_complex(np.linalg.eigvals(flow(side, 1 / 40))) for side in (HELD, FREE)]
    assert orbit.one_sided
    assert orbit.edge.other_multipliers is not None
    found = [moving(orbit.multipliers), moving(orbit.edge.other_multipliers)]
    assert (
        min(max(abs(found[0] - sides[a]).max(), abs(found[1] - sides[1 - a]).max()) for a in (0, 1)) < 1e-5
    )  # differences over 1e-9 of what is known to 1e-16
    assert "rests on an edge" in orbit.message


@pytest.mark.parametrize(("text", "rest", "stiffest"), [(BENT, 0.0, 1100.0), (LIMITED, 0.01, 200.0)])
@pytest.mark.parametrize("aside", [1e-4, -1e-4])
def test_so_has_one_at_a_knot_of_its_spring_or_with_its_control_at_the_limit(
    text: str, rest: float, stiffest: float, aside: float
) -> None:
    orbit = forced_orbit(Mechanism.from_toml_text(text), guess={"block": (rest + aside, 0.0)})
    sides = [np.sort_complex(np.linalg.eigvals(flow((k, 0.5), 1 / 40))) for k in (100.0, stiffest)]
    found = [np.sort_complex(each) for each in (orbit.multipliers, orbit.edge.other_multipliers)]
    assert min(abs(np.array(found) - each).max() for each in (sides, sides[::-1])) < 1e-5


def test_where_a_disturbance_changes_sides_within_the_period_no_multipliers_are_claimed() -> None:
    orbit = forced_orbit(touching(frequency=1.0))
    assert orbit.one_sided
    assert orbit.edge.other_multipliers is None
    assert "are not known" in orbit.message


@pytest.mark.parametrize("gap", [1e-5, -1e-5])
def test_beside_the_edge_there_is_none(gap: float) -> None:
    assert not forced_orbit(touching(gap=gap)).one_sided
    assert "edge" not in forced_orbit(touching(gap=gap)).message


def test_an_ordinary_orbit_with_impacts_and_friction_has_both_sides_alike() -> None:
    assert not forced_orbit(twin(1.0)).one_sided
    assert not respond(twin(1.0)).motion.orbit.one_sided


TWINS = """
frequency = 1.0
[structures.s]
mass = [[1.0, {shared}], [{shared}, 1.0]]
stiffness = [[25.0, -5.0], [-5.0, 25.0]]
damping = [[1.3, -0.3], [-0.3, 1.3]]
coordinates = ["p", "q"]
[frictions]
a = {{ between = ["ground", "s.p"], force = 6.0 }}
b = {{ between = ["ground", "s.q"], force = 6.0 }}
[forces]
c = {{ on = "s.p", amplitude = 30.0 }}
d = {{ on = "s.q", amplitude = 30.0 }}
"""


@pytest.mark.parametrize("shared", [0.0, 0.3])
def test_which_of_two_frictions_grips_first_matters_where_the_other_feels_it(shared: float) -> None:
    """Two like coordinates come to rest in the same instant; a force on one moves the other by their mass."""
    orbit = forced_orbit(Mechanism.from_toml_text(TWINS.format(shared=shared)))
    assert orbit.success and len(orbit.course.events) == 4
    assert orbit.one_sided == (shared != 0.0)


SHAKEN = """
[bodies.other]
mass = 1.0
[links.other]
between = ["ground", "other"]
stiffness = 5000.0
damping = 20.0
[forces]
push = { on = "other", amplitude = 3.0 }
"""


def test_it_is_said_in_words_and_in_the_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One block is shaken, and another rests where it just touches its wall."""
    file = tmp_path / "touching.toml"
    file.write_text(TOUCHING.format(frequency=40.0, gap=0.0, damping=20.0, law="relaxing") + SHAKEN)
    assert main(["respond", str(file), "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["kind"] == "periodic"
    assert content["one_sided"] is True
    assert "rests on an edge" in content["message"]
    both = [complex(*each) for key in ("multipliers", "other_multipliers") for each in content[key]]
    # Which side is the own one depends on where the motion came from.
    orbit = forced_orbit(Mechanism.from_toml(file))
    known = np.concatenate([orbit.multipliers, orbit.edge.other_multipliers])
    assert np.sort_complex(np.round(both, 5)) == pytest.approx(np.sort_complex(np.round(known, 5)), abs=1e-4)


AT_LIMIT = """
frequency = 40.0
[bodies]
block = { mass = 1.0 }
[links]
spring = { between = ["ground", "block"], stiffness = 100.0, damping = 50.0 }
[frictions]
rub = { between = ["ground", "block"], force = 1.0 }
[forces]
pull = { on = "block", constant = 1.0 }
beat = { on = "block", amplitude = 0.0 }
"""


def test_a_stick_force_at_its_limit_holds_to_one_side_and_slips_to_the_other() -> None:
    """To one side a displacement stays; to the other the block slips back, by spring and damper."""
    orbit = forced_orbit(Mechanism.from_toml_text(AT_LIMIT))
    slips = np.linalg.eigvals(flow((100.0, 50.0), 1 / 40))
    assert orbit.one_sided
    assert abs(orbit.multipliers).max() == pytest.approx(1.0, abs=1e-12)
    assert np.sort(orbit.edge.other_multipliers.real) == pytest.approx(np.sort(slips), abs=1e-5)
