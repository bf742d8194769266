"""Mechanisms other than the thesis's, against equations written down by hand."""

from dataclasses import replace

import pytest
import sympy

from derivations.algebra.identity import UnprovenError
from derivations.any_mechanism.derivation import derive_mechanism
from derivations.equations_of_motion import motion_matrices
from derivations.linear_motion import linear_motion
from derivations.mechanism import Mechanism, closed, trimmer
from derivations.parts import Damper, Spring
from derivations.power_balance import power_balance
from derivations.symbols import t
from tests.derivations.symbolic_parts import GROUND, body, force, friction, pin, play, positive, stop

k, c, k_2, c_2 = (positive(name) for name in ("k", "c", "k_2", "c_2"))
BODIES = (body(1), body(2), body(3))
(q1, q2, q3), (m1, m2, _) = ([each.coordinate for each in BODIES], [each.mass for each in BODIES])


def rate(expression):
    return expression.diff(t)


def equal(found, expected):
    return sympy.expand(found - expected) == 0


def test_block_on_a_belt():
    block, belt = BODIES[0], pin("w", GROUND)
    rubbing = friction("belt", belt, block)
    mechanism = Mechanism((block,), (Spring(k, GROUND, block),), (), (belt,), (), (rubbing,))
    derivation = derive_mechanism(mechanism)
    belt_speed = rate(belt.displacement)
    (found,) = derivation.motion.resultant_forces
    assert equal(found, -k * q1 - rubbing.force - rubbing.viscous * (rate(q1) - belt_speed))
    power = derivation.motion.power
    friction_force = rubbing.force + rubbing.viscous * (rate(q1) - belt_speed)
    assert equal(power.input_power, -friction_force * belt_speed), "the belt drives"
    (law,) = derivation.frictions
    held = m1 * rate(belt_speed) + k * q1 + rubbing.viscous * (rate(q1) - belt_speed)
    assert equal(law.held, -held), "the block moves as the belt does"


def test_two_mass_servo_with_backlash():
    """Nordin and Gutman, Automatica 38, 2002: a motor and a load joined by a damped spring behind a gap."""
    motor, load, command = BODIES[0], BODIES[1], pin("r", GROUND)
    gear = play("gear", motor, load)
    mechanism = Mechanism(
        (motor, load), (Spring(k, command, motor),), (Damper(c, command, motor),), (command,), (gear,)
    )
    derivation = derive_mechanism(mechanism)
    r = command.displacement
    control = k * (r - q1) + c * (rate(r) - rate(q1))
    first, second = derivation.motion.resultant_forces
    assert equal(first, control + gear.tension)
    assert equal(second, -gear.tension)
    stretch = q2 - q1 - gear.side * gear.gap / 2
    shaft = gear.stiffness * stretch + gear.damping * (rate(q2) - rate(q1))
    first, second = derivation.closed.resultant_forces
    assert equal(first, control + shaft)
    assert equal(second, -shaft)
    assert equal(derivation.closed.potential_energy, k * (q1 - r) ** 2 / 2 + gear.stiffness * stretch**2 / 2)


def test_stop_with_preload_pushes_its_ends_apart_in_contact():
    barrier = stop("wall", GROUND, BODIES[0], damping=False)
    derivation = derive_mechanism(Mechanism(BODIES[:1], (), (), (), (barrier,)))
    (force_on_body,) = derivation.closed.resultant_forces
    assert equal(force_on_body, -barrier.stiffness * (q1 - barrier.gap))


def test_friction_between_a_pin_and_a_body():
    """The reaction of friction on a pin acts on the body that carries it, and its power is the drive's."""
    wheel, shoe = BODIES[:2]
    rim = pin("u", wheel)
    rubbing = friction("brake", rim, shoe)
    mechanism = Mechanism(
        (wheel, shoe), (Spring(k, GROUND, wheel), Spring(k_2, GROUND, shoe)), (), (rim,), (), (rubbing,)
    )
    derivation = derive_mechanism(mechanism)
    slip = rate(q2) - rate(q1) - rate(rim.displacement)
    drag = rubbing.force + rubbing.viscous * slip
    first, second = derivation.motion.resultant_forces
    assert equal(first, -k * q1 + drag)
    assert equal(second, -k_2 * q2 - drag)
    assert equal(derivation.motion.power.input_power, -drag * rate(rim.displacement))
    assert equal(derivation.motion.power.contact_power, rubbing.force * slip)
    (law,) = derivation.frictions
    assert equal(law.rate, slip)
    stuck = {rubbing.force: law.held, rate(q2): rate(q1) + rate(rim.displacement)}
    change = second.subs(stuck) / m2 - first.subs(stuck) / m1 - rim.displacement.diff(t, 2)
    assert sympy.simplify(change.subs(stuck)) == 0, "the held force keeps the slip at zero"


def test_friction_that_no_body_feels_has_no_holding_force():
    moved = pin("u", GROUND)
    rubbing = friction("idle", GROUND, moved)
    derivation = derive_mechanism(
        Mechanism((BODIES[0],), (Spring(k, GROUND, BODIES[0]),), (), (moved,), (), (rubbing,))
    )
    assert derivation.frictions[0].held is None
    assert derivation.motion.matrices.friction_force == sympy.zeros(1, 1)


@pytest.fixture(scope="module")
def everything():
    first, second, third = BODIES
    base, wheel = pin("u", GROUND), pin("w", second)
    return Mechanism(
        bodies=BODIES,
        springs=(Spring(k, base, first), Spring(k_2, first, third)),
        dampers=(Damper(c, GROUND, second), Damper(c_2, wheel, third)),
        pins=(base, wheel),
        contacts=(play("a", first, wheel), stop("b", third, second), play("d", base, third, damping=False)),
        frictions=(friction("a", second, third), friction("b", wheel, first)),
        forces=(force("P", third), force("N", first)),
    )


@pytest.mark.slow
def test_another_order_of_bodies_and_parts_permutes_the_matrices(everything):
    order = [2, 0, 1]
    turned = replace(
        everything,
        bodies=tuple(BODIES[index] for index in order),
        springs=everything.springs[::-1],
        dampers=everything.dampers[::-1],
        pins=everything.pins[::-1],
        contacts=everything.contacts[::-1],
        frictions=everything.frictions[::-1],
        forces=everything.forces[::-1],
    )
    before, after = motion_matrices(closed(everything)), motion_matrices(closed(turned))
    for square in ("mass", "damping", "stiffness"):
        assert getattr(after, square) == getattr(before, square).extract(order, order)
    for columns in ("displacement_force", "velocity_force", "given_force", "friction_force"):
        assert getattr(after, columns) == getattr(before, columns).extract(order, [1, 0])
    assert after.constant_force == before.constant_force.extract(order, [0])
    contacts = motion_matrices(everything).contact_force.extract(order, [2, 1, 0])
    assert motion_matrices(turned).contact_force == contacts


def test_swapping_the_ends_mirrors_contacts_and_frictions_and_nothing_else(everything):
    def swapped(joints):
        return tuple(replace(joint, start=joint.end, end=joint.start) for joint in joints)

    mirrored = replace(
        everything,
        springs=swapped(everything.springs),
        dampers=swapped(everything.dampers),
        contacts=swapped(everything.contacts),
        frictions=swapped(everything.frictions),
    )
    before, after = motion_matrices(everything), motion_matrices(mirrored)
    assert after.contact_force == -before.contact_force
    assert after.friction_force == -before.friction_force
    opposite = {"contact_force", "friction_force"}
    for name in set(vars(before)) - opposite:
        assert getattr(after, name) == getattr(before, name)


def test_a_closed_bridge_without_gap_is_the_thesis():
    thesis = trimmer()
    bridge = play("bridge", thesis.pins[0], thesis.bodies[1], gap=False)
    bridge = replace(bridge, stiffness=thesis.springs[1].stiffness, damping=thesis.dampers[1].damping)
    played = replace(
        thesis,
        springs=thesis.springs[:1] + thesis.springs[2:],
        dampers=thesis.dampers[:1] + thesis.dampers[2:],
        contacts=(bridge,),
    )
    assert motion_matrices(closed(played)) == motion_matrices(thesis)


def test_power_balance_notices_a_damper_that_gives_energy(everything):
    wrong = replace(everything, dampers=(Damper(-c, GROUND, BODIES[0]),))
    assert power_balance(everything).holds
    assert not power_balance(wrong).holds
    with pytest.raises(UnprovenError, match="power balance"):
        linear_motion(wrong)
