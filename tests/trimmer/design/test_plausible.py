"""Which numbers are asked about, on both sides of each limit; and how large an unknown one may be."""

import math
from dataclasses import replace

import pytest

from tests.trimmer.design.made import contact, friction, motion, output
from trimmer import respond
from trimmer.design import Oddity, Question
from trimmer.design.analysis.found_motion import of_settled
from trimmer.design.analysis.plausible import questions
from trimmer.design.specification.assumed_range import assumed_range
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.examples import example_text
from trimmer.mechanism import Body, Friction, Link, Mechanism, Pin, Play, Stop

ENDS = ("ground", "b")


def mechanism(masses: tuple[float, ...] = (0.02, 0.03, 0.04), **parts: object) -> Mechanism:
    bodies = {name: Body(mass) for name, mass in zip("abcd", masses, strict=False)}
    held = {f"hold {name}": Link(("ground", name), 1.0) for name in bodies}
    links = {**held, **parts.pop("links", {})}  # type: ignore[dict-item]
    fields: dict[str, object] = {"bodies": bodies, "frequency": 110.0, "links": links, **parts}
    return Mechanism(**fields)  # type: ignore[arg-type]


def told(found: tuple[Question, ...]) -> list[tuple[Oddity, str, float, float]]:
    return [(each.oddity, each.place_text, each.value, each.beside) for each in found]


PINS = {"near": Pin("ground", 0.025), "far": Pin("ground", -0.026)}
STROKES = {"one": Pin("ground", 1e-3), "two": Pin("ground", -1.5e-3)}
PLAYS = {"wide": Play(ENDS, 1e4, 0.0, 3e-3), "fine": Play(ENDS, 1e4, 0.0, 2.9e-3)}
ODD = {
    # It is asked about once, though more than a kilogram is also much for a hand.
    "fifty times heavier": (mechanism((0.02, 0.03, 1.5)), [(Oddity.HEAVY_BODY, "bodies.c.mass", 1.5, 0.03)]),
    "less heavy": (mechanism((0.02, 0.03, math.sqrt(1.5 * 0.03))), []),
    "lighter": (mechanism((0.02, 0.03, 4e-4)), [(Oddity.HEAVY_BODY, "bodies.c.mass", 4e-4, 0.02)]),
    "less light": (mechanism((0.02, 0.03, math.sqrt(4e-4 * 0.02))), []),
    "the heavier of two in the middle": (
        mechanism((0.001, 0.002, 0.1, 0.1)),
        [
            (Oddity.HEAVY_BODY, f"bodies.{name}.mass", mass, 0.1)
            for name, mass in (("a", 0.001), ("b", 0.002))
        ],
    ),
    "two alone": (mechanism((0.001, 0.9)), []),
    "of a hand": (
        mechanism((0.2, 0.2, 1.2), pins=PINS, frequency=4.0),
        [
            (Oddity.HEAVY_FOR_HAND, "bodies.c.mass", 1.2, 1.0),
            (Oddity.LONG_STROKE, "pins.far.amplitude", -0.026, 0.025),
            (Oddity.SLOW_OR_FAST, "frequency", 4.0, 5.0),
        ],
    ),
    "of no hand": (mechanism((0.2, 1.0, 1.2), pins=PINS, frequency=4.0), []),
    "fast": (mechanism(frequency=2001.0), [(Oddity.SLOW_OR_FAST, "frequency", 2001.0, 2000.0)]),
    **{f"at {each} Hz": (mechanism(frequency=each), []) for each in (5.0, 2000.0, None)},
    "a gap like a stroke": (
        mechanism(pins=STROKES, plays=PLAYS),
        [(Oddity.GAP_ABOVE_STROKE, "plays.wide.gap", 3e-3, 3e-3)],
    ),
    "a gap without a stroke": (mechanism(plays=PLAYS), []),
}


@pytest.mark.parametrize("case", ODD)
def test_numbers_that_a_small_machine_hardly_has_are_asked_about(case: str) -> None:
    made, expected = ODD[case]
    assert told(questions(made, None)) == expected


def test_a_contact_that_yields_half_of_the_largest_stroke() -> None:
    plays = {"soft": Play(ENDS, 1e3, 0.0, 0.0), "hard": Play(ENDS, 1e4, 0.0, 0.0)}
    stops = {"wall": Stop(ENDS, 500.0, 0.0, 0.4), "air": Stop(ENDS, 0.0, 0.0, 0.4)}
    made = mechanism(plays=plays, stops=stops)
    contacts = {name: contact(0.1, 2.0) for name in ("soft", "hard", "wall", "air")}
    outputs = {"x": output(0.0, 3e-3), "y": output(0.0, 1e-3)}
    moving = motion(contacts=contacts, outputs=outputs, frictions={})
    assert told(questions(made, moving)) == [
        (Oddity.SOFT_CONTACT, "plays.soft.stiffness", 2e-3, 3e-3),
        (Oddity.SOFT_CONTACT, "stops.wall.stiffness", 4e-3, 3e-3),
    ]
    larger = replace(moving, outputs={**outputs, "z": output(0.0, 4e-3)})
    assert [each[1] for each in told(questions(made, larger))] == ["stops.wall.stiffness"]
    assert questions(made, replace(moving, contacts={})) == ()
    assert questions(made, replace(moving, outputs={})) == ()


def test_friction_that_holds_all_the_time() -> None:
    made = mechanism(frictions={"one": Friction(ENDS, 0.5), "two": Friction(ENDS, 0.7)})
    moving = motion(contacts={}, frictions={"one": friction(0.1, 0.999), "two": friction(0.0, 1.0)})
    assert told(questions(made, moving)) == [(Oddity.FRICTION_HOLDS, "frictions.two.force", 0.7, 0.7)]


def test_unknown_numbers_are_assumed_from_what_is_known() -> None:
    pins = {"near": Pin("a", 1e-3), "far": Pin("b", -1.5e-3)}
    made = mechanism(
        pins=pins,
        plays={"bridge": Play(("far", "c"), 3e4, 0.0, 0.0)},
        links={"mount": Link(ENDS, 2e5, 0.0), "loose": Link(ENDS, 0.0, 1.0)},
        frictions={"blade": Friction(("c", "a"), 0.5)},
    )
    assert assumed_range(made, ("plays", "bridge", "gap")) == (0.0, pytest.approx(3e-4))
    damping = assumed_range(made, ("plays", "bridge", "damping"))
    assert damping == (0.0, pytest.approx(0.2 * math.sqrt(3e4 * 0.03 * 0.04 / 0.07)))
    assert assumed_range(made, ("links", "mount", "damping")) == (
        0.0,
        pytest.approx(0.2 * math.sqrt(2e5 * 0.03)),
    )
    force = assumed_range(made, ("frictions", "blade", "force"))
    assert force == (0.0, pytest.approx(0.02 * (2 * math.pi * 110) ** 2 * 1.5e-3))


def test_what_nothing_tells_of_is_not_assumed() -> None:
    made = mechanism(
        plays={"bridge": Play(ENDS, 3e4, 0.0, 0.0)},
        links={"loose": Link(ENDS, 0.0, 1.0)},
        frictions={"blade": Friction(ENDS, 0.5)},
    )
    for place in (
        ("frequency",),
        ("bodies", "a", "mass"),
        ("links", "loose", "damping"),
        ("plays", "bridge", "gap"),
        ("frictions", "blade", "force"),
        ("frictions", "blade", "static"),
    ):
        assert assumed_range(made, place) is None
    still = replace(made, frequency=None)
    assert assumed_range(still, ("frictions", "blade", "force")) is None
    driven = replace(made, pins={"pin": Pin("a", 1e-3)})
    assert assumed_range(driven, ("frictions", "blade", "viscous")) is None


def test_nothing_is_asked_about_the_examples() -> None:
    for name in ("thesis-play", "den-hartog", "gear-pair", "two-mass-stop", "held", "foil-shaver", "servo"):
        mechanism = design_file_of_text(example_text(name), name).mechanism
        moving = of_settled(respond(mechanism).motion) if name == "thesis-play" else None
        assert questions(mechanism, moving) == ()
