"""Curves of links and frictions: laws, digits, brute force, and corners that are easy to get wrong."""

from dataclasses import replace

import numpy as np
import pytest

from tests.mechanisms.random_mechanisms import curved, random_mechanism
from tests.quick import quick
from tests.trimmer.contact.test_against_brute_force import compare
from tests.trimmer.problem_machines import machine_text
from trimmer import Body, Force, Link, Mechanism, Output, simulate

BELT = machine_text("falling-friction")


def oscillator(curve, *, start=(0.0, 0.0), damping=0.0, **parts) -> Mechanism:
    """A body of 1 kg on a curve."""
    return Mechanism(
        {"body": Body(1.0)},
        links={"spring": Link(("ground", "body"), 0.0, damping, curve=curve)},
        start={"body": start},
        outputs={"x": Output({"body": 1.0})},
        **parts,
    )


def last(motion) -> np.ndarray:
    """The state at the end."""
    return motion.states(np.array([motion.duration]))[:, 0]


def with_curves(seed: int) -> Mechanism:
    return curved(random_mechanism(seed), seed)


@pytest.mark.parametrize("seed", quick(range(3, 80, 4), 0))
def test_random_mechanisms_with_curves(seed):
    compare(with_curves(seed), 2)


def test_a_curve_that_is_straight_is_a_spring():
    """Corners without a bend change nothing, and add no event."""
    curve = tuple((d, 3.0 * d) for d in (-1.0, -0.2, 0.0, 0.4, 1.0))
    bent = oscillator(curve, frequency=0.2, forces={"f": Force("body", amplitude=2.0)}, damping=0.3)
    links = {"spring": Link(("ground", "body"), 3.0, 0.3)}
    plain = replace(bent, links=links)
    ours, theirs = (simulate(each, 30.0) for each in (bent, plain))
    assert last(ours) == pytest.approx(last(theirs), rel=1e-12)
    assert not ours.events


def test_the_energy_of_a_curve_is_kept():
    curve = ((-2.0, -7.0), (-0.5, -1.0), (0.5, 2.0), (1.0, 1.5), (3.0, 8.0))
    motion = simulate(oscillator(curve, start=(0.3, 4.0)), 50.0)
    assert motion.energy.residual < 1e-12
    first, last = (k + s for k, s in zip(motion.energy.kinetic, motion.energy.stored, strict=True))
    assert last == pytest.approx(first, rel=1e-12)


def test_the_work_of_a_falling_friction_closes_the_balance():
    motion = simulate(Mechanism.from_toml_text(BELT), 40.0)
    assert motion.energy.residual < 1e-12


@pytest.mark.parametrize("velocity", [0.0, 1e-9, -1e-9])
def test_a_start_on_a_corner(velocity):
    """At rest in balance on a corner nothing moves; a touch of velocity oscillates about it on both sides."""
    curve = ((-1.0, -1.0), (0.0, 0.0), (1.0, 4.0))
    motion = simulate(oscillator(curve, start=(0.0, velocity)), 3 * np.pi)
    times = np.linspace(0, 3 * np.pi, 400)
    x = motion.output("x", times)
    expected = {0.0: (0.0, 0.0)}.get(velocity, (-1e-9, 0.5e-9))
    assert (x.min(), x.max()) == pytest.approx(expected, abs=1e-13)


def test_a_motion_that_only_touches_a_corner_goes_on_as_if_it_were_not_there():
    """x = cos t comes to the corner at -1 with no velocity."""
    curve = ((-2.0, -9.0), (-1.0, -1.0), (2.0, 2.0))
    motion = simulate(oscillator(curve, start=(1.0, 0.0)), 40.0)
    assert last(motion)[0] == pytest.approx(np.cos(40.0), abs=1e-11)


def test_driven_along_a_corner():
    """A force that holds the body on a corner for all time makes no events."""
    curve = ((-1.0, 0.0), (0.0, 2.0), (1.0, 7.0))
    held = oscillator(curve, forces={"f": Force("body", 2.0)})
    motion = simulate(held, 20.0)
    assert motion.success
    assert last(motion) == pytest.approx([0.0, 0.0], abs=1e-14)


def test_numbers_of_curves_have_places():
    mechanism = Mechanism.from_toml_text(BELT)
    assert mechanism.places["frictions.rub.curve.2.speed"] == "m/s"
    assert mechanism.value("frictions.rub.curve.3.force") == 0.5
    assert "frictions.rub.force" not in mechanism.places
    changed = mechanism.with_value("frictions.rub.curve.2.speed", "700 mm/s")
    assert changed.frictions["rub"].curve == ((0.0, 1.0), (0.7, 0.6), (2.0, 0.5))
    assert Mechanism.from_toml_text(changed.to_toml()) == changed


def test_stick_begins_on_the_first_segment_and_holds_to_the_static_force():
    """The block on the belt leaves stick where the spring reaches the static force, given or not."""
    for static, reached in ((None, 1.0), (1.3, 1.3)):
        mechanism = Mechanism.from_toml_text(BELT)
        rub = replace(mechanism.frictions["rub"], static=static)
        motion = simulate(replace(mechanism, frictions={"rub": rub}), 12.0)
        ended = next(each.time for each in motion.events if each.kind.value == "stick ended")
        assert motion.output("x", [ended])[0] == pytest.approx(reached, rel=1e-12)
