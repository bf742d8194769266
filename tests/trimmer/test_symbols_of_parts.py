"""What symbols the parts of a mechanism become: zeros are left out, weights are exact, laws are whole."""

from __future__ import annotations

from functools import cache
from math import pi, sin

import sympy

from derivations.symbols import omega, t
from trimmer.code_generation import SymbolsOfMechanism, symbolic_mechanism
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Link, Output, Pin, Stop

OMEGA, TIME = 2 * pi * 110.0, 1.3e-3


@cache
def made() -> SymbolsOfMechanism:
    mechanism = Mechanism(
        bodies={"a": Body(2.0), "b": Body(3.0)},
        pins={
            "still": Pin("ground", offset=1e-3),
            "moving": Pin("a", amplitude=2e-3, phase=0.25, offset=1e-3, velocity=0.5, order=3),
        },
        links={"spring": Link(("a", "b"), stiffness=7.0), "oil": Link(("b", "moving"), damping=5.0)},
        stops={
            "off": Stop(("a", "ground")),
            "firm": Stop(("ground", "b"), stiffness=4.0, gap=1e-4),
            "soft": Stop(("a", "still"), damping=6.0, law=ContactLaw.TRUNCATED),
        },
        frictions={
            "wet": Friction(("a", "ground"), 0.0, viscous=2.0),
            "none": Friction(("a", "ground"), 0.0),
            "dry": Friction(("b", "a"), 3.0),
            "sticky": Friction(("a", "still"), 3.0, static=4.0, viscous=0.5),
        },
        forces={
            "push": Force("b", constant=2.0, amplitude=3.0, phase=0.5, order=2, unbalance=1e-4),
            "weight": Force("a", constant=9.0),
        },
        outputs={"x": Output({"a": 1 / 3, "moving": -0.1})},
        frequency=110.0,
    )
    return symbolic_mechanism(mechanism)


def number(expression: sympy.Expr) -> float:
    """The value of an expression with the mechanism's numbers at a time."""
    values = {each.quantity.symbol: each.value for each in made().quantities if each.value is not None}
    return float(sympy.sympify(expression).doit().xreplace({**values, t: sympy.Float(TIME)}))


def test_motions_of_pins_have_all_their_terms() -> None:
    still, moving = made().mechanism.pins
    assert number(still.law) == 1e-3
    expected = 1e-3 + 0.5 * TIME + 2e-3 * sin(3 * OMEGA * TIME + 0.25)
    assert abs(number(moving.law) / expected - 1) < 1e-12
    assert t not in still.law.free_symbols
    assert moving.carrier is made().mechanism.bodies[0]


def test_forces_have_all_their_terms() -> None:
    push, weight = made().mechanism.forces
    expected = 2.0 + (3.0 + 1e-4 * (2 * OMEGA) ** 2) * sin(2 * OMEGA * TIME + 0.5)
    assert abs(number(push.law) / expected - 1) < 1e-12
    assert number(weight.law) == 9.0
    assert omega not in weight.law.free_symbols
    assert [each.body.name for each in (push, weight)] == ["b", "a"]


def test_what_is_zero_is_left_out() -> None:
    mechanism = made().mechanism
    (spring,) = mechanism.springs
    assert number(spring.stiffness) == 7.0
    assert [number(each.damping) for each in mechanism.dampers] == [5.0, 2.0]
    assert [each.name for each in mechanism.contacts] == ["firm", "soft"]
    assert [
        (number(each.stiffness), number(each.damping), number(each.gap)) for each in mechanism.contacts
    ] == [
        (4.0, 0.0, 1e-4),
        (0.0, 6.0, 0.0),
    ]
    assert [each.name for each in mechanism.frictions] == ["dry", "sticky"]


def test_static_friction_has_a_symbol_where_it_differs() -> None:
    dry, sticky = made().mechanism.frictions
    assert dry.static == dry.kinetic
    assert (number(sticky.kinetic), number(sticky.static), number(sticky.viscous)) == (3.0, 4.0, 0.5)
    assert number(dry.viscous) == 0.0


def test_ends_are_in_their_order() -> None:
    a, b = made().mechanism.bodies
    _, moving = made().mechanism.pins
    damper, wet = made().mechanism.dampers
    assert (damper.start, damper.end) == (b, moving)
    assert wet.start is a
    firm, _ = made().mechanism.contacts
    assert firm.end is b
    dry, _ = made().mechanism.frictions
    assert (dry.start, dry.end) == (b, a)


def test_weights_are_fractions() -> None:
    (output,) = made().mechanism.outputs
    assert [weight for _, weight in output.weights] == [sympy.Rational(1, 3), sympy.Rational(-1, 10)]


def test_the_table_of_symbols_ends_with_the_drive_and_time() -> None:
    *parts, drive, time = made().quantities
    assert (drive.quantity.symbol, drive.value) == (omega, OMEGA)
    assert (time.quantity.symbol, time.value) == (t, None)
    assert len({each.quantity.symbol for each in parts}) == len(parts)


def test_symbols_are_positive_or_real_as_their_kind() -> None:
    a, _ = made().mechanism.bodies
    (spring,) = made().mechanism.springs
    assert a.mass.is_positive
    assert (spring.stiffness.is_nonnegative, spring.stiffness.is_positive) == (True, None)
    firm, _ = made().mechanism.contacts
    assert (firm.gap.is_real, firm.gap.is_nonnegative) == (True, None)


def test_arguments_are_by_kind_and_each_has_its_name() -> None:
    names = list(made().arguments.values())
    assert len(set(names)) == len(names)
    symbols = list(made().arguments)
    a, b = made().mechanism.bodies
    assert symbols[:2] == [a.mass, b.mass]
    assert symbols[-2:] == [a.coordinate, b.coordinate]
