"""Motions that follow on paper, event by event, and where motions end."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from trimmer import ContactLaw, FrictionBacklash, Mechanism, MechanismMotion, forced_orbit, simulate
from trimmer.hybrid.stretch import Ending
from trimmer.mechanism import Body, Force, Friction, Output, Pin, Play

BETWEEN = ("ground", "body")


def times_of(motion: MechanismMotion, word: str) -> list[float]:
    return [event.time for event in motion.events if event.kind.value == word]


def bouncing(**changes: object) -> Mechanism:
    """A body of 1 kg that bounces on springs of 100 N/m at +-0.5 m; it is driven by nothing, at 2 Hz."""
    mechanism = Mechanism(
        {"body": Body(1.0)},
        frequency=2.0,
        plays={"slot": Play(BETWEEN, 100.0, 0.0, 1.0)},
        forces={"nothing": Force("body", amplitude=1e-300)},
        start={"body": (0.0, 1.0)},
    )
    return replace(mechanism, **changes)


@pytest.mark.parametrize("changes", [{}, {"frequency": 1e-3}, {"frequency": None, "forces": {}}])
def test_a_motion_keeps_all_its_events_however_many(changes: dict[str, object]) -> None:
    motion = simulate(bouncing(**changes), 400.0)
    # It meets a wall every second of flight and a contact of pi / 10 s.
    count = int((400.0 - 0.5) / (1.0 + math.pi / 10)) + 1
    made = 0.5 + np.arange(count) * (1.0 + math.pi / 10)
    assert times_of(motion, "contact made") == pytest.approx(made, rel=1e-11)
    assert {event.part for event in motion.events} == {"slot"}
    # Flight, turn, flight back: place and speed at any time.
    times = np.sort(np.random.default_rng(1).uniform(0.0, 400.0, 50))
    lap, since = np.divmod(times - 0.5, 1.0 + math.pi / 10)
    side, away = (-1.0) ** lap, since - math.pi / 10
    place = np.where(away > 0, 0.5 - away, 0.5 + 0.1 * np.sin(10 * since))
    place, side = np.where(lap < 0, times, place), np.where(lap < 0, 1.0, side)
    assert motion.displacement("body", times) == pytest.approx(side * place, abs=1e-10)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_what_was_let_go_is_pushed_again_before_it_has_left(side: float) -> None:
    """A damper that would pull is let go, and a push drives the body back into the spring."""
    slot = Play(BETWEEN, 10.0, 5.0, 1.0, law=ContactLaw.TRUNCATED)
    mechanism = Mechanism({"body": Body(1.0)}, plays={"slot": slot}, forces={"push": Force("body", side)})
    motion = simulate(mechanism, 3.0, state={"body": (1.05 * side, -side)})
    assert [event.kind.value for event in motion.events] == ["contact broken", "contact made"]

    def rates(_: float, y: np.ndarray) -> list[float]:
        return [y[1], 1.0 - max(10.0 * (y[0] - 0.5) + 5.0 * y[1], 0.0)]

    end = solve_ivp(rates, (0.0, 3.0), [1.05, -1.0], "DOP853", rtol=1e-11, atol=1e-12, max_step=0.01).y[:, -1]
    assert motion.final["body"] == pytest.approx(tuple(side * end), rel=1e-7)


def test_a_motion_that_takes_too_many_steps_ends_where_they_end() -> None:
    whole = simulate(bouncing(), 2.2)
    cut = simulate(bouncing(), 2.2, step_limit=1)
    assert (whole.outcome, cut.outcome) == (Ending.REACHED_END, Ending.STEP_LIMIT)
    assert (cut.success, cut.message) == (False, "it took more steps than allowed")
    assert 0.0 < cut.duration < 0.5
    assert cut.states(cut.duration) == pytest.approx(whole.states(cut.duration), rel=1e-12)
    few = simulate(bouncing(), 2.2, event_limit=3)
    assert (few.outcome, few.message) == (Ending.EVENT_LIMIT, "it has more events than allowed")
    assert few.events == whole.events[:2]  # The start of a drive period counts too.
    assert few.states(few.duration) == pytest.approx(whole.states(few.duration), rel=1e-12)
    beyond = simulate(bouncing(start={"body": (1e160, 0.0)}), 1.0)
    assert (beyond.success, beyond.outcome) == (False, Ending.DIVERGED)


@pytest.mark.parametrize(("phase", "slides"), [(0.0, False), (1e-13, True), (-1e-13, True)])
@pytest.mark.parametrize("turn", [math.pi / 2, -math.pi / 2])
def test_a_table_that_turns_back_is_at_rest(turn: float, phase: float, slides: bool) -> None:
    """Its velocity is 6e-17 of its greatest one there, not zero."""
    mechanism = Mechanism(
        {"body": Body(1.0)},
        frequency=2.0,
        pins={"table": Pin("ground", 3.0, turn + phase)},
        frictions={"rub": Friction(("body", "table"), 1e9)},
    )
    assert bool(simulate(mechanism, 0.01).events) is slides


@pytest.mark.parametrize(
    ("first", "second", "slides"),
    [
        (-0.3, -0.3, False),
        (-0.3, np.nextafter(-0.3, -1.0), False),
        (-0.3, np.nextafter(-0.3, 0.0), False),
        (-0.3, -0.3 + 1e-13, True),
        (-1e-3, -1e-3 - 1e-14, True),
        (0.0, 0.0, False),
        (0.0, -1e-100, True),
    ],
)
def test_bodies_whose_velocities_differ_by_rounding_are_at_rest(first, second, slides) -> None:
    frictions = {"rub": Friction(("one", "two"), 1.0)}
    start = {"one": (0.0, first), "two": (0.0, second)}
    motion = simulate(Mechanism({"one": Body(1.0), "two": Body(1.0)}, frictions=frictions, start=start), 1.0)
    assert times_of(motion, "stick begun") == ([pytest.approx(0.0, abs=1e-12)] if slides else [])


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(
    ("law", "place", "speed", "stretch", "force"),
    [
        (ContactLaw.RELAXING, 0.04, 0.1, 0.01, 0.4 + 0.3),
        (ContactLaw.RELAXING, 0.04, -1.0, 0.01, 0.0),  # the damper pulls more than 40 N/m 1 cm push
        (ContactLaw.RELAXING, 0.01, 0.0, 0.005, 0.0),  # the end of the spring is inside the slot
        (ContactLaw.RELAXING, 0.01, 1.0, -0.025, 3.0 - 0.8),  # its end is at the wall, and the damper pushes
        (ContactLaw.RELAXING, 0.01, 0.0, -0.025, 0.0),
        (ContactLaw.TRUNCATED, 0.04, -1.0, None, 0.0),
        (ContactLaw.TRUNCATED, 0.04, 0.1, None, 0.4 + 0.3),
        (ContactLaw.PULLING, 0.04, -1.0, None, 0.4 - 3.0),
        (ContactLaw.PULLING, 0.02, 9.0, None, 0.0),
    ],
)
def test_a_motion_begins_in_contact_if_its_state_says_so(law, place, speed, stretch, force, side) -> None:
    """A body of 1 kg between walls at +-3 cm."""
    mechanism = Mechanism({"body": Body(1.0)}, plays={"slot": Play(BETWEEN, 40.0, 3.0, 0.06, law)})
    state = side * np.array([place, speed, *([] if stretch is None else [stretch])])
    motion = simulate(mechanism, 1e-6, state=state)
    assert motion.contact_force("slot", 0.0) == pytest.approx(side * force, rel=1e-12, abs=1e-12)
    assert motion.states(0.0)[:2] == pytest.approx(state[:2])
    if stretch == 0.01 or stretch is None:  # as short as can be, if only the body is given
        named = simulate(mechanism, 1e-6, state={"body": side * np.array([place, speed])})
        assert named.states(0.0) == pytest.approx(state)


@pytest.mark.parametrize(("side", "there"), [(1.0, 1), (-1.0, -1)])
def test_what_a_static_force_moves_stays_once_that_is_gone(side: float, there: int) -> None:
    """One body of 1 kg is pushed, and rubs on another of 2 kg with 0.6 N, or 0.9 N from rest."""

    def pushed(force: float):
        mechanism = Mechanism(
            {"one": Body(1.0), "two": Body(2.0)},
            frictions={
                "between": Friction(("two", "one"), 0.6, 0.9),
                "one on ground": Friction(("ground", "one"), 1.0),
                "two on ground": Friction(("ground", "two"), 0.8),
            },
            forces={"push": Force("one", side * force)},
        )
        return simulate(mechanism, 0.5).states(0.5)

    # The static 0.9 N would move the second body against its 0.8 N, the kinetic 0.6 N do not.
    assert pushed(3.0) == pytest.approx([there * 1.4 / 8, 0.0, there * 1.4 / 2, 0.0], rel=1e-12)
    # 1.7 N hold the first body: 0.9 N of the second and 0.8 N, or 1 N and 0.7 N.
    assert pushed(1.7) == pytest.approx(np.zeros(4))


def test_a_light_bridge_in_a_stiff_slot_is_the_friction_controlled_play_of_the_thesis() -> None:
    amplitude, departures = 1.5e-3, []
    expected = complex(FrictionBacklash(2e-4).describing_function(amplitude))
    for scale in (1.0, 0.3, 0.1):
        mass, stiffness = 1e-5 * scale, 1e6 / scale
        bridge = Mechanism(
            bodies={"bridge": Body(mass)},
            frequency=110.0,
            pins={"pin": Pin("ground", amplitude)},
            plays={"slot": Play(("bridge", "pin"), stiffness, math.sqrt(stiffness * mass), 2e-4)},
            frictions={"holder": Friction(("ground", "bridge"), 1.0)},
            outputs={"bridge": Output({"bridge": 1.0})},
        )
        first = 1j * forced_orbit(bridge, 5).measures.outputs["bridge"].amplitudes[0]
        departures.append(abs(first / amplitude - expected) / scale)
    # The describing function is approached in proportion to scale: by 8.5e-4 at scale 1.
    np.testing.assert_allclose(departures, 8.488e-4, rtol=4e-3)
