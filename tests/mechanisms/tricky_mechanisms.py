"""Mechanisms that are easy to get wrong: coincidences, rings, preloads, parts that touch from the start."""

import math
from collections.abc import Callable

from tests.mechanisms import cases
from trimmer import Body, ContactLaw, Force, Friction, Link, Mechanism, Pin, Play, Stop

LAWS = tuple(ContactLaw)
Maker = Callable[[], Mechanism]


def one_body(**parts) -> Mechanism:
    """A body of 1 kg, driven at 1 Hz on a spring of 20 N/m; ``parts`` replace what is given here."""
    given = {
        "bodies": {"body": Body(1.0)},
        "frequency": 1.0,
        "links": {"spring": Link(("ground", "body"), 20.0, 0.3)},
        "forces": {"drive": Force("body", amplitude=5.0)},
    }
    return Mechanism(**(given | parts))


def two_bodies(**parts) -> Mechanism:
    given = {
        "bodies": {"a": Body(1.0), "b": Body(0.4)},
        "frequency": 1.0,
        "links": {"held": Link(("ground", "a"), 30.0, 0.4), "coupled": Link(("a", "b"), 15.0, 0.2)},
        "forces": {
            "on a": Force("a", amplitude=6.0, phase=0.4),
            "on b": Force("b", amplitude=3.0, phase=2.0, order=2),
        },
    }
    return Mechanism(**(given | parts))


def stops_on_both_sides(law: ContactLaw) -> Mechanism:
    """Two stops that face each other are a play."""
    return one_body(
        stops={
            "above": Stop(("ground", "body"), 400.0, 3.0, 0.1, law),
            "below": Stop(("body", "ground"), 400.0, 3.0, 0.1, law),
        }
    )


def two_stops_at_once(law: ContactLaw) -> Mechanism:
    """Two equal stops touch and leave at the same instants."""
    stop = Stop(("ground", "body"), 200.0, 1.5, 0.1, law)
    return one_body(stops={"first": stop, "second": stop})


def preloaded(law: ContactLaw) -> Mechanism:
    """From rest in contact; the contact opens later."""
    return one_body(stops={"wall": Stop(("ground", "body"), 150.0, 4.0, -0.02, law)})


def touching_at_rest(law: ContactLaw) -> Mechanism:
    """The force of the contact is zero at the start, and so is its rate."""
    return one_body(stops={"wall": Stop(("ground", "body"), 150.0, 4.0, 0.0, law)})


def play_without_gap(law: ContactLaw) -> Mechanism:
    return two_bodies(links={}, plays={"joint": Play(("a", "b"), 80.0, 2.0, 0.0, law)})


def overdamped_contact(law: ContactLaw) -> Mechanism:
    """A truncated contact lifts far beyond the gap and pushes again before it has come back."""
    return one_body(
        stops={"wall": Stop(("ground", "body"), 100.0, 60.0, 0.02, law)},
        forces={"drive": Force("body", amplitude=5.0), "ripple": Force("body", amplitude=14.0, order=3)},
    )


def contact_between_stuck_bodies(law: ContactLaw) -> Mechanism:
    """Contact is made while both bodies stick on the ground by turns."""
    return two_bodies(
        plays={"joint": Play(("a", "b"), 200.0, 2.0, 0.05, law)},
        frictions={"a rubs": Friction(("ground", "a"), 3.0), "b rubs": Friction(("b", "ground"), 1.5, 1.8)},
    )


def frictions_side_by_side() -> Mechanism:
    """Two frictions between the same ends: their split is never determined."""
    return one_body(
        frictions={"first": Friction(("ground", "body"), 1.0), "second": Friction(("body", "ground"), 0.6)}
    )


def frictions_side_by_side_with_static_force() -> Mechanism:
    return one_body(
        frictions={
            "first": Friction(("ground", "body"), 1.0, 1.5),
            "second": Friction(("body", "ground"), 0.6, 0.7),
        }
    )


def ring(static: float | None) -> Mechanism:
    ends = {"a rubs": ("ground", "a"), "b rubs": ("b", "ground"), "both": ("a", "b")}
    return two_bodies(frictions={name: Friction(pair, 1.0, static) for name, pair in ends.items()})


def ring_with_a_free_body() -> Mechanism:
    """Nothing but friction holds the second body."""
    ends = {"a rubs": ("ground", "a"), "b rubs": ("b", "ground"), "both": ("a", "b")}
    return two_bodies(
        links={"held": Link(("ground", "a"), 30.0, 0.4)},
        frictions={name: Friction(pair, 1.0) for name, pair in ends.items()},
    )


def rubbing_on_a_shaking_table() -> Mechanism:
    """Stick to a pin that moves as prescribed, at twice the drive's frequency."""
    return one_body(
        pins={"table": Pin("ground", 0.05, 0.3, order=2)},
        frictions={"rub": Friction(("table", "body"), 3.0, 4.0, 0.2)},
    )


def between_ground_and_belt() -> Mechanism:
    return one_body(
        pins={"belt": Pin("ground", velocity=0.4)},
        frictions={
            "on belt": Friction(("belt", "body"), 1.0, 1.4),
            "on ground": Friction(("ground", "body"), 2.5),
        },
    )


def coming_to_rest() -> Mechanism:
    """Free vibration that friction ends, under a force that would not move it alone."""
    return one_body(
        forces={"weight": Force("body", 0.5)},
        frictions={"rub": Friction(("ground", "body"), 3.0)},
        start={"body": (1.0, 0.0)},
    )


def pin_on_its_own_body() -> Mechanism:
    """A moved point of one body drives another through a play."""
    return two_bodies(
        pins={"crank": Pin("a", 0.2, 0.7, offset=0.01)},
        plays={"joint": Play(("crank", "b"), 150.0, 1.0, 0.06)},
        frictions={"b rubs": Friction(("a", "b"), 0.5)},
    )


def weak_grazing(depth: float) -> Mechanism:
    """The steady motion of a linear oscillator passes a stop by ``depth``."""
    omega = 2 * math.pi
    amplitude = 5.0 / math.hypot(20.0 - omega**2, 0.3 * omega)
    phase = -math.atan2(0.3 * omega, 20.0 - omega**2)
    begun = (amplitude * math.sin(phase), amplitude * omega * math.cos(phase))
    return one_body(
        stops={"wall": Stop(("ground", "body"), 300.0, 2.0, amplitude - depth)}, start={"body": begun}
    )


def unbalanced() -> Mechanism:
    return two_bodies(
        forces={"rotor": Force("a", unbalance=0.15, phase=0.2), "second order": Force("b", 0.3, 2.0, 1.0, 3)},
        stops={"wall": Stop(("b", "a"), 500.0, 2.0, 0.05)},
        frictions={"rub": Friction(("a", "b"), 0.6)},
    )


TRICKY: dict[str, Maker] = {
    **{
        f"{maker.__name__}, {law.word}": lambda maker=maker, law=law: maker(law)
        for maker in (
            stops_on_both_sides,
            two_stops_at_once,
            preloaded,
            touching_at_rest,
            play_without_gap,
            overdamped_contact,
            contact_between_stuck_bodies,
            cases.trimmer,
        )
        for law in LAWS
    },
    **{
        maker.__name__: maker
        for maker in (
            frictions_side_by_side,
            frictions_side_by_side_with_static_force,
            ring_with_a_free_body,
            rubbing_on_a_shaking_table,
            between_ground_and_belt,
            coming_to_rest,
            pin_on_its_own_body,
            unbalanced,
        )
    },
    "ring": lambda: ring(None),
    "ring with static force": lambda: ring(1.3),
    "weak grazing, 1e-6": lambda: weak_grazing(1e-6),
    "weak grazing, 1e-9": lambda: weak_grazing(1e-9),
}
