"""The laws of contact, friction and walls against their words, at points and along a motion."""

import itertools

import pytest
import sympy

from derivations.any_mechanism.contact_law import contact_statement
from derivations.any_mechanism.friction_law import friction_statement
from derivations.any_mechanism.wall_law import wall_statement
from derivations.mechanism import Mechanism
from derivations.parts import ContactLaw, Play, Spring, Wall
from derivations.symbols import t
from tests.derivations.symbolic_parts import GROUND, body, force, friction, function, play, positive, stop
from tests.quick import quick

FIRST, SECOND = body(1), body(2)
K, C, G = sympy.Integer(7), sympy.Integer(3), sympy.Integer(2)
PLACES = [sympy.Rational(number, 4) for number in (-11, -5, -4, -3, 0, 4, 8, 9)]
RATES = [sympy.Rational(number, 2) for number in (-9, 0, 1, 9)]


def value(expression, contact, distance=0, rate=0, stretch=0, stretch_rate=0):
    numbers = {
        contact.distance.diff(t): rate,
        contact.stretch.diff(t): stretch_rate,
        contact.distance: distance,
        contact.stretch: stretch,
        contact.stiffness: K,
        contact.damping: C,
        contact.gap: G,
    }
    occurring = {symbol: number for symbol, number in numbers.items() if symbol != 0}
    return expression.subs(occurring).doit()


def sides(contact):
    """Distances at which contact begins, each with the sign that its force has."""
    return [(G / 2, 1), (-G / 2, -1)] if isinstance(contact, Play) else [(G, 1)]


@pytest.mark.parametrize("kind", quick([play, stop], 1))
@pytest.mark.parametrize("law", [ContactLaw.TRUNCATED, ContactLaw.PULLING])
def test_force_of_a_contact_without_memory(kind, law):
    """T = k (s -+ gap/2) + c s' while the gap is closed, and for the truncated law while T does not pull."""
    contact = kind("b", FIRST, SECOND, law)
    tension = contact_statement(contact).tension
    for s, v in itertools.product(PLACES, RATES):
        expected = sympy.Integer(0)
        for side, sign in sides(contact):
            if sign * s > sign * side:
                force = K * (s - side) + C * v
                expected = force if law is ContactLaw.PULLING or sign * force > 0 else sympy.Integer(0)
        assert value(tension, contact, distance=s, rate=v) == expected


@pytest.mark.parametrize("kind", quick([play, stop], 0))
def test_relaxing_contact(kind):
    """In contact z = s - side while T >= 0 there (<= 0 at the other side); free, z' = -(k/c) z and T = 0."""
    contact = kind("b", FIRST, SECOND)
    statement = contact_statement(contact)
    for s, v in itertools.product(PLACES, RATES):
        for side, sign in sides(contact):
            z = s - side
            pressed = sign * (K * z + C * v) >= 0
            expected = v if pressed else -K / C * z
            rate = value(statement.stretch_rate, contact, s, v, z)
            assert rate == expected
            tension = value(statement.tension, contact, s, v, z, rate)
            assert tension == (K * z + C * v if pressed else 0)
            assert sign * tension >= 0, "a contact never pulls"
        z = s - G / 4  # on the way from one side to the other
        rate = value(statement.stretch_rate, contact, s, v, z)
        assert rate == -K / C * z
        assert value(statement.tension, contact, s, v, z, rate) == 0


@pytest.mark.parametrize("kind", [play, stop])
def test_without_damping_the_three_laws_are_the_dead_zone(kind):
    for law in ContactLaw:
        contact = kind("b", FIRST, SECOND, law, damping=False)
        statement = contact_statement(contact)
        assert statement.stretch_rate is None
        for s in PLACES:
            free = min(max(s, -G / 2), G / 2) if kind is play else min(s, G)
            z = value(statement.stretch, contact, distance=s)
            assert z == s - free
            assert value(statement.tension, contact, stretch=z) == K * (s - free)


def test_a_play_without_gap_is_a_link():
    """Relaxing or pulling it carries k s + c s'; a truncated one is cut off where that would pull."""
    relaxing = contact_statement(play("b", FIRST, SECOND, gap=False))
    pulling = contact_statement(play("b", FIRST, SECOND, ContactLaw.PULLING, gap=False))
    for s, v in itertools.product(PLACES, RATES):
        rate = value(relaxing.stretch_rate, relaxing.contact, s, v, s)
        assert rate == v
        assert value(relaxing.tension, relaxing.contact, s, v, s, rate) == K * s + C * v
        if s != 0:
            assert value(pulling.tension, pulling.contact, s, v) == K * s + C * v


def test_relaxing_law_along_a_motion():
    """Pressed in, then torn away: the spring relaxes by exp(-k t / c), and carries nothing (by dsolve)."""
    contact = play("b", FIRST, SECOND)
    free = contact_statement(contact).stretch_rate.args[-1][0]
    z = sympy.Function("z")
    solved = sympy.dsolve(z(t).diff(t) - free.subs(contact.stretch, z(t)), z(t), ics={z(0): 1}).rhs
    assert sympy.simplify(solved - sympy.exp(-contact.stiffness * t / contact.damping)) == 0


def test_friction_slides_against_the_motion_and_sticks_up_to_its_static_force():
    rubbing = friction("a", FIRST, SECOND)
    k = positive("k")
    mechanism = Mechanism((FIRST, SECOND), (Spring(k, GROUND, FIRST),), (), (), (), (rubbing,))
    law = friction_statement(mechanism, rubbing)
    assert sympy.expand(law.rate - SECOND.coordinate.diff(t) + FIRST.coordinate.diff(t)) == 0
    assert law.sliding.subs(rubbing.rate, 3) == rubbing.kinetic
    assert law.sliding.subs(rubbing.rate, -3) == -rubbing.kinetic
    numbers = {rubbing.static: 2, rubbing.kinetic: 1, rubbing.rate: 0}
    assert law.stick.subs({**numbers, rubbing.force: -2}) == sympy.true
    assert law.stick.subs({**numbers, rubbing.force: sympy.Rational(21, 10)}) == sympy.false
    assert law.stick.subs({**numbers, rubbing.rate: 1, rubbing.force: 0}) == sympy.false


def test_a_wall_keeps_momentum_turns_the_rate_and_holds():
    wall = Wall("w", FIRST, SECOND, positive("e"), G, function("s_w"), function("T_w"))
    pull = force("P", SECOND)
    law = wall_statement(Mechanism((FIRST, SECOND), (), (), contacts=(wall,), forces=(pull,)), wall)
    rate, (first, second) = wall.distance.diff(t), law.changes
    assert sympy.expand(law.distance - SECOND.coordinate + FIRST.coordinate) == 0
    assert sympy.simplify(FIRST.mass * first + SECOND.mass * second) == 0
    assert sympy.simplify(rate + second - first + wall.restitution * rate) == 0
    assert sympy.simplify(SECOND.mass * second + law.impulse) == 0
    # Both bodies then have the acceleration of their common centre of mass.
    assert sympy.simplify(law.held - FIRST.mass * pull.value / (FIRST.mass + SECOND.mass)) == 0
