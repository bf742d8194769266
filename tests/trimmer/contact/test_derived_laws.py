"""The exact motion obeys the laws of contact and friction that are derived as symbolic statements."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import sympy

from derivations.any_mechanism.derivation import derive_mechanism
from derivations.equations_of_motion import accelerations
from derivations.symbols import t
from tests.quick import quick
from trimmer import ContactLaw, Mechanism, Stop, simulate
from trimmer.in_symbols.mechanism import symbolic_mechanism

PLAY = Path(__file__).parents[3] / "examples" / "thesis-play.toml"
STEP = 1e-8
"""Time over which rates are taken from the motion, s; the fastest decay takes 13 us."""


@pytest.fixture(scope="module")
def driven():
    """The thesis's trimmer with play, which sticks and slips, and whose guard meets a stop."""
    mechanism = Mechanism.from_toml(PLAY).with_value("frictions.blade.force", 2.0)
    stop = Stop(("housing", "guard"), stiffness=200e3, damping=2.0, gap=1e-5)
    return replace(mechanism.with_value("frictions.blade.static", 2.5), stops={"latch": stop})


@pytest.mark.parametrize(
    ("law", "damping"),
    quick([*((law, 0.4) for law in ContactLaw), (ContactLaw.RELAXING, 0.0)], 0),
)
def test_accelerations_follow_from_the_derived_laws(driven, law, damping):
    mechanism = replace(
        driven,
        plays={name: replace(play, law=law, damping=damping) for name, play in driven.plays.items()},
        stops={name: replace(stop, law=law, damping=5 * damping) for name, stop in driven.stops.items()},
    )
    motion = simulate(mechanism, 7 / mechanism.frequency)
    check = LawCheck(mechanism, motion.flow.names)
    times = np.linspace(5 / 7 * motion.duration, motion.duration - STEP, 15)
    events = np.array([event.time for event in motion.events])
    away = np.abs(times[:, None] - events).min(axis=1) > 2 * STEP
    before, at, after = (motion.states(times[away] + shift).T for shift in (-STEP, 0.0, STEP))
    for time, state, rate in zip(times[away], at, (after - before) / (2 * STEP), strict=True):
        check.hold(time, state, rate)
    assert {"closed", "open", "stick", "slip"} <= check.met


class LawCheck:
    """Computes the forces of contacts and frictions from the statements, and from them the accelerations."""

    def __init__(self, mechanism, names):
        symbolic = symbolic_mechanism(mechanism)
        self.derivation = derive_mechanism(symbolic.mechanism)
        self.names = names
        self.values = {e.quantity.symbol: e.value for e in symbolic.quantities if e.value is not None}
        self.exact = {symbol: sympy.Rational(value) for symbol, value in self.values.items()}
        self.met = set()
        self.known = cache(lambda expression: expression.subs(self.values))
        self.exactly_known = cache(lambda expression: expression.subs(self.exact))

    def hold(self, time, state, rate):
        symbolic = self.derivation.mechanism
        values = dict(self.values)
        for pin in symbolic.pins:
            written = [self.known(pin.law.diff(t, order)).subs(t, time) for order in (2, 1, 0)]
            moved = pin.displacement.diff(t, 2), pin.displacement.diff(t), pin.displacement
            values |= dict(zip(moved, map(float, written), strict=True))
        bodies = len(symbolic.bodies)
        for index, body in enumerate(symbolic.bodies):
            values |= {body.coordinate.diff(t): state[bodies + index], body.coordinate: state[index]}
        forces = {}
        for statement in self.derivation.contacts:
            stretch = dict(zip(self.names, zip(state, rate, strict=True), strict=True))
            forces[statement.contact.tension] = self.tension(
                statement, values, stretch.get(statement.contact.name)
            )
        for statement in self.derivation.frictions:
            forces[statement.friction.force] = self.friction(statement, {**values, **forces})
        derived = [float(each.xreplace({**values, **forces})) for each in accelerations(symbolic)]
        np.testing.assert_allclose(rate[bodies : 2 * bodies], derived, rtol=1e-5, atol=0.02)

    def tension(self, statement, values, stretch):
        """Return T, and hold the rate of a relaxing spring (m/s) against the motion."""
        contact = statement.contact
        s, s_rate = (
            float(each.xreplace(values)) for each in (statement.distance, statement.distance.diff(t))
        )
        gap = self.values[contact.gap]
        if statement.stretch_rate is None:
            at = {contact.distance.diff(t): s_rate, contact.distance: s}
            z = statement.stretch
            at |= {} if z is None else {contact.stretch: self.known(z).subs(at).doit()}
            force = float(self.known(statement.tension).subs(at).doit())
        else:
            z, z_rate = stretch
            side = next((x for x in self.sides(contact, gap) if abs(s - z - x) < 1e-12), None)
            exact = sympy.Rational(z) + sympy.Rational(side if side is not None else s - z)
            at = {
                contact.distance.diff(t): s_rate,
                contact.stretch: sympy.Rational(z),
                contact.distance: exact,
            }
            derived = float(self.exactly_known(statement.stretch_rate).subs(at).doit())
            assert z_rate == pytest.approx(derived, rel=1e-4, abs=1e-6)
            rates = {contact.stretch.diff(t): derived, contact.stretch: z}
            force = float(self.known(statement.tension).subs(rates).doit())
        self.met.add("closed" if abs(force) > 1e-9 else "open")
        return force

    @staticmethod
    def sides(contact, gap):
        return (gap / 2, -gap / 2) if hasattr(contact, "side") else (gap,)

    def friction(self, statement, values):
        friction = statement.friction
        v = float(statement.rate.xreplace(values))
        if abs(v) > 1e-9:
            self.met.add("slip")
            return float(self.known(statement.sliding).subs(friction.rate, v))
        self.met.add("stick")
        held = float(statement.held.xreplace(values))
        assert abs(held) <= self.values[friction.static] * (1 + 1e-9)
        return held
