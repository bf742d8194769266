"""Which numbers are varied and how far, on mechanisms and motions made by hand."""

import pytest

from tests.trimmer.design.made import contact, friction, motion, output
from trimmer.design import NumberRole, VariedNumber
from trimmer.design.varied_places import varied_places
from trimmer.mechanism import Body, ContactLaw, Friction, Link, Mechanism, Pin, Play, Stop

ENDS = ("ground", "block")


def mechanism(**parts: object) -> Mechanism:
    fields: dict[str, object] = {"bodies": {"block": Body(0.5)}, "frequency": 110.0, **parts}
    return Mechanism(**fields)  # type: ignore[arg-type]


def play(gap: float = 4e-5, stiffness: float = 3e4, damping: float = 0.0) -> Play:
    return Play(ENDS, stiffness, damping, gap)


def only(role: NumberRole, found: tuple[VariedNumber, ...]) -> VariedNumber:
    (each,) = (each for each in found if each.role is role)
    return each


def test_gap_speed_and_friction_in_this_order() -> None:
    made = mechanism(plays={"bridge": play()}, frictions={"blade": Friction(ENDS, 0.5)})
    gap, speed, force = varied_places(made, None)
    assert (gap.role, gap.place, gap.part, gap.unit) == (NumberRole.GAP, "plays.bridge.gap", "bridge", "m")
    assert (gap.value, gap.lowest, gap.highest, gap.bounded) == (4e-5, 0.0, pytest.approx(1.6e-4), False)
    assert (speed.role, speed.place, speed.part, speed.unit) == (NumberRole.SPEED, "frequency", "", "Hz")
    assert (speed.value, speed.lowest, speed.highest, speed.bounded) == (110.0, 55.0, 165.0, False)
    assert (force.role, force.place, force.part) == (NumberRole.FRICTION, "frictions.blade.force", "blade")
    assert (force.value, force.lowest, force.highest, force.bounded) == (0.5, 0.0, 2.0, False)
    assert force.unit == "N"


def test_a_mechanism_without_any_has_none() -> None:
    still = mechanism(
        frequency=None, links={"spring": Link(ENDS, 1.0)}, frictions={"no": Friction(ENDS, 0.0)}
    )
    assert varied_places(still, None) == ()
    assert varied_places(mechanism(plays={"air": play(stiffness=0.0)}), None)[0].role is NumberRole.SPEED


def test_a_stop_may_overlap_and_a_play_may_not() -> None:
    found = varied_places(mechanism(stops={"wall": Stop(ENDS, 1e3, 0.0, 0.4)}), None)[0]
    assert (found.place, found.lowest, found.highest) == ("stops.wall.gap", 0.0, pytest.approx(1.6))
    found = varied_places(mechanism(stops={"wall": Stop(ENDS, 1e3, 0.0, -0.4)}), None)[0]
    assert (found.lowest, found.highest) == pytest.approx((-0.8, 0.8))


def test_a_gap_of_zero_goes_up_to_a_share_of_the_largest_stroke() -> None:
    made = mechanism(plays={"bridge": play(0.0)})
    moving = motion(outputs={"a": output(-1e-3, 2e-3), "b": output(0.0, 1e-3)})
    found = varied_places(made, moving)[0]
    assert (found.value, found.lowest, found.highest) == (0.0, 0.0, pytest.approx(6e-4))
    assert varied_places(made, None)[0].role is NumberRole.SPEED
    assert varied_places(made, motion(outputs={}))[0].role is NumberRole.SPEED


def test_the_contact_that_is_met_fastest_is_taken() -> None:
    plays = {
        "air": play(stiffness=0.0),
        "one": play(),
        "two": Play(ENDS, 0.0, 1.0, 5e-5, ContactLaw.TRUNCATED),
    }
    made = mechanism(plays=plays, stops={"wall": Stop(ENDS, 1e3, 0.0, 0.4)})
    assert varied_places(made, None)[0].part == "one"
    speeds = {"air": 9.0, "one": 0.1, "two": 0.3, "wall": 0.2}
    moving = motion(contacts={name: contact(speed) for name, speed in speeds.items()})
    assert varied_places(made, moving)[0].place == "plays.two.gap"
    speeds["wall"] = 0.4
    moving = motion(contacts={name: contact(speed) for name, speed in speeds.items()})
    assert varied_places(made, moving)[0].place == "stops.wall.gap"
    twins = motion(contacts={name: contact(0.1 * (1 + 1e-9 * (name == "two"))) for name in speeds})
    assert varied_places(made, twins)[0].part == "one"


def test_the_friction_that_turns_most_into_heat_is_taken() -> None:
    frictions = {"none": Friction(ENDS, 0.0), "one": Friction(ENDS, 0.5), "two": Friction(ENDS, 0.25)}
    made = mechanism(frictions=frictions, pins={"pin": Pin("ground", 1e-3)})
    assert only(NumberRole.FRICTION, varied_places(made, None)).part == "one"
    powers = {"none": 9.0, "one": 0.1, "two": 0.3}
    moving = motion(frictions={name: friction(power) for name, power in powers.items()})
    found = only(NumberRole.FRICTION, varied_places(made, moving))
    assert (found.place, found.value, found.highest) == ("frictions.two.force", 0.25, 1.0)
    twins = motion(frictions={name: friction(0.1 * (1 + 1e-9 * (name == "two"))) for name in powers})
    assert only(NumberRole.FRICTION, varied_places(made, twins)).part == "one"


@pytest.mark.parametrize(
    ("static", "highest", "bounded"), [(None, 2.0, False), (0.8, 0.8, True), (0.5, 0.5, True)]
)
def test_a_static_force_bounds_the_kinetic_one(static: float | None, highest: float, bounded: bool) -> None:
    made = mechanism(frictions={"blade": Friction(ENDS, 0.5, static)})
    found = only(NumberRole.FRICTION, varied_places(made, None))
    assert (found.highest, found.bounded) == (highest, bounded)


def test_a_side_of_a_map_holds_the_number_of_the_file() -> None:
    gap = VariedNumber(NumberRole.GAP, "plays.bridge.gap", "bridge", "m", 4e-5, 0.0, 1.6e-4)
    assert gap.values(4) == pytest.approx([4e-5, 8e-5, 1.2e-4, 1.6e-4])
    assert gap.values(24)[5] == pytest.approx(4e-5)
    shifted = VariedNumber(NumberRole.FRICTION, "f", "f", "N", 1.0, 1.0, 3.0)
    assert shifted.values(4) == pytest.approx([1.5, 2.0, 2.5, 3.0])
    speed = VariedNumber(NumberRole.SPEED, "frequency", "", "Hz", 110.0, 55.0, 165.0)
    assert speed.values(4) == pytest.approx([55.0, 82.5, 110.0, 137.5])
    assert speed.values(24)[12] == pytest.approx(110.0)
