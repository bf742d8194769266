"""What meets no event any more is solved: forced response, undamped vibrations, rest."""

import math
import re

import numpy as np
import pytest

from tests.quick import quick
from tests.trimmer.response.mechanisms import body
from trimmer import Mechanism, MotionKind, respond, simulate
from trimmer.mechanism import Body, Force, Friction, Link, Output, Pin, Play, Stop
from trimmer.response.results.response_json import response_json

DRIVE = 0.3
OMEGA = 2 * math.pi * DRIVE


def oscillator(damping: float = 0.0, stiffness: float = 1.0, amplitude: float = 1.0, **parts) -> Mechanism:
    """A body of 1 kg on a spring, driven at 0.3 Hz; without a drive, if the amplitude is zero."""
    driven = {"frequency": DRIVE, "forces": {"push": Force("body", amplitude=amplitude)}} if amplitude else {}
    return body(links={"spring": Link(("ground", "body"), stiffness, damping)}, **{**driven, **parts})


@pytest.mark.parametrize("ratio", [1e-9, 8e-5, 2.4e-4, 1e-3, 0.02])
def test_slow_decay_is_not_waited_for(ratio: float) -> None:
    """Held against the complex amplitude 1/(k - m w² + i c w) and the multipliers exp(λ T)."""
    response = respond(oscillator(2 * ratio), state={"body": (1.0, 0.0)})
    expected = 1 / abs(1 - OMEGA**2 + 2j * ratio * OMEGA)
    orbit = response.motion.orbit
    assert (response.kind, response.period_count) == (MotionKind.PERIODIC, 1)
    assert (orbit.stable, orbit.neutral) == (True, False)
    assert response.motion.drive_periods <= 32
    assert response.motion.peak_to_peak["body"] == pytest.approx(2 * expected, rel=1e-11)
    growth = np.exp(-ratio / DRIVE)
    np.testing.assert_allclose(abs(orbit.multipliers), [growth, growth], rtol=1e-13)


def test_many_bodies_with_little_damping_go_as_an_independent_solve_says() -> None:
    numbers = np.random.default_rng(5)
    masses, links = numbers.uniform(0.5, 2.0, 4), {}
    stiffness, damping = np.zeros((4, 4)), np.zeros((4, 4))
    for place, (start, end) in enumerate([(-1, 0), (0, 1), (1, 2), (2, 3), (-1, 3), (0, 2)]):
        k, c = numbers.uniform(1.0, 9.0), 1e-5 * numbers.uniform()
        row = np.zeros(4)
        row[end] = 1.0
        row[start] -= start >= 0
        stiffness += k * np.outer(row, row)
        damping += c * np.outer(row, row)
        links[f"link {place}"] = Link((f"b{start}" if start >= 0 else "ground", f"b{end}"), k, c)
    mechanism = Mechanism(
        {f"b{i}": Body(float(mass)) for i, mass in enumerate(masses)},
        frequency=DRIVE,
        links=links,
        forces={"push": Force("b1", 0.7, 2.0, 0.4), "third": Force("b3", 1.0, order=3)},
        outputs={f"b{i}": Output({f"b{i}": 1.0}) for i in range(4)},
    )
    motion = respond(mechanism, starts=2).motion
    assert motion.starts == 2
    first = np.linalg.solve(stiffness - OMEGA**2 * np.diag(masses) + 1j * OMEGA * damping, [0, 2.0, 0, 0])
    for place in range(4):
        assert motion.harmonics[f"b{place}"][0] == pytest.approx(abs(first[place]), rel=1e-8)
    mean = np.linalg.solve(stiffness, [0, 0.7, 0, 1.0])
    found = [motion.orbit.measures.outputs[f"b{place}"].mean for place in range(4)]
    np.testing.assert_allclose(found, mean, rtol=1e-9)


@pytest.mark.parametrize("stiffness", [0.37, 1.0, 2.9, 17.3, 1e4])
def test_an_undamped_oscillator_comes_back_and_keeps_the_size_of_its_start(stiffness: float) -> None:
    response = respond(oscillator(stiffness=stiffness, amplitude=0.0), state={"body": (1.5, 0.0)}, starts=3)
    orbit = response.motion.orbit
    assert (response.kind, response.success) == (MotionKind.PERIODIC, True)
    assert (orbit.stable, orbit.neutral) == (False, True)
    assert orbit.period == pytest.approx(2 * math.pi / math.sqrt(stiffness), rel=1e-13)
    assert response.motion.peak_to_peak["body"] == pytest.approx(3.0, rel=1e-13)
    assert len(response.motions) == 3, "three starts have three sizes"


def test_an_undamped_oscillator_with_a_drive_runs_on_a_torus() -> None:
    """x = A sin w t + B cos(t + phase): the start at rest sets B."""
    response = respond(oscillator(), starts=3)
    forced = 1 / abs(1 - OMEGA**2)
    free = OMEGA * forced
    assert (response.kind, response.motion.lyapunov.value) == (MotionKind.TORUS, 0.0)
    assert response.motion.rms["body"].value == pytest.approx(math.hypot(forced, free) / 2**0.5, rel=1e-12)
    assert response.motion.peak_to_peak["body"] == pytest.approx(2 * (forced + free), rel=1e-12)
    assert response.motion.harmonics["body"][0] == pytest.approx(forced, rel=1e-12)
    assert len(response.motions) == 3
    assert "0.159155 Hz" in response.message
    late = simulate(oscillator(), 4000.0).output("body", np.linspace(3000, 4000, 20001))
    assert np.ptp(late) == pytest.approx(2 * (forced + free), rel=1e-3)


def test_free_vibrations_in_a_ratio_of_small_numbers_repeat_together() -> None:
    third = respond(oscillator(stiffness=(OMEGA / 3) ** 2))
    assert (third.kind, third.period_count) == (MotionKind.PERIODIC, 3)
    assert third.motion.orbit.neutral
    two = Mechanism(
        {"one": Body(1.0), "two": Body(1.0)},
        links={"a": Link(("ground", "one"), 1.0), "b": Link(("ground", "two"), 9.0)},
        start={"one": (1.0, 0.0), "two": (0.2, 0.0)},
    )
    assert respond(two).motion.orbit.period == pytest.approx(2 * math.pi, rel=1e-13)
    beating = respond(two.with_value("links.b.stiffness", 8.0))
    assert (beating.kind, beating.success) == (MotionKind.TORUS, True)


def test_a_damper_that_a_mode_does_not_move_leaves_it_undamped() -> None:
    """Two equal oscillators with a damper between them: in step they never lose anything."""
    pair = Mechanism(
        {"one": Body(1.0), "two": Body(1.0)},
        links={
            "a": Link(("ground", "one"), 1.0),
            "b": Link(("ground", "two"), 1.0),
            "damper": Link(("one", "two"), 0.0, 0.3),
        },
        outputs={"one": Output({"one": 1.0})},
        start={"one": (1.0, 0.0)},
    )
    motion = respond(pair).motion
    assert motion.orbit.neutral
    assert motion.orbit.period == pytest.approx(2 * math.pi, rel=1e-12)
    assert motion.peak_to_peak["one"] == pytest.approx(1.0, rel=1e-12), "half of the start is in step"


def test_what_is_damped_comes_to_rest_where_its_forces_balance() -> None:
    mechanism = Mechanism(
        {"one": Body(1.0), "two": Body(2.0)},
        links={"soft": Link(("ground", "one"), 3.0, 0.01), "strut": Link(("one", "two"), 5.0, 0.02)},
        plays={"slot": Play(("ground", "two"), 7.0, 0.03, 0.4)},
        stops={"far": Stop(("ground", "two"), 9.0, 0.1, 50.0)},
        frictions={"pad": Friction(("ground", "one"), 0.0, viscous=0.1)},
        forces={"weight": Force("two", constant=4.0)},
    )
    response = respond(mechanism, starts=2)
    stiffness = np.array([[8.0, -5.0], [-5.0, 12.0]])
    one, two = np.linalg.solve(stiffness, [0.0, 4.0 + 7.0 * 0.2])
    content = response_json(response)
    assert (content["kind"], content["success"], content["period_count"]) == ("rest", True, None)
    assert content["rest"]["positions"] == pytest.approx({"one": one, "two": two}, rel=1e-13)
    assert content["rest"]["forces"] == pytest.approx(
        {"soft": 3 * one, "strut": 5 * (two - one), "slot": 7 * (two - 0.2), "far": 0.0, "pad": 0.0},
        rel=1e-12,
    )
    assert not content["rest"]["family"]
    assert "All 2 starts come to rest there." in response.message


def test_dry_friction_holds_it_where_it_stopped_with_the_force_of_the_springs() -> None:
    mechanism = oscillator(amplitude=0.0, frictions={"floor": Friction(("ground", "body"), 0.3)})
    response = respond(mechanism, state={"body": (2.0, 0.0)})
    rest = response.motion.rest
    # Half swings about -F/k and +F/k in turn: 2.0, -1.4, 0.8, -0.2, where the spring is weaker than friction.
    assert rest.positions["body"] == pytest.approx(-0.2, rel=1e-12)
    assert rest.forces["spring"] == pytest.approx(-0.2, rel=1e-12)
    assert rest.forces["floor"] == pytest.approx(0.2, rel=1e-12)
    assert rest.family
    assert response.motion.lyapunov is None
    motion = simulate(mechanism, 40.0, state={"body": (2.0, 0.0)})
    assert motion.rest.positions == pytest.approx(rest.positions, rel=1e-12)
    assert simulate(mechanism, 5.0, state={"body": (2.0, 0.0)}).rest is None


def test_a_drive_that_moves_nothing_leaves_rest() -> None:
    still = respond(
        oscillator(0.2, amplitude=1e-9).with_value("forces.push.amplitude", 0.0), state={"body": (1, 0)}
    )
    assert still.kind is MotionKind.REST
    assert still.motion.rest.positions["body"] == pytest.approx(0.0, abs=1e-300)
    pin, rub = Pin("ground", amplitude=0.1), Friction(("ground", "body"), 1.0)
    gap = {"gap": Output({"body": 1.0, "pin": -1.0})}
    beside = body(frequency=DRIVE, pins={"pin": pin}, frictions={"rub": rub}, outputs=gap)
    seen = respond(beside).motion
    found = seen.peak_to_peak["gap"], seen.rms["gap"].value, seen.harmonics["gap"][0]
    assert seen.kind is MotionKind.REST
    assert found == pytest.approx((0.2, 0.1 / math.sqrt(2), 0.1), rel=1e-13)
    shaken = oscillator(pins={"table": Pin("ground", amplitude=0.1)})
    assert respond(shaken.with_value("links.spring.damping", 0.1)).kind is MotionKind.PERIODIC


@pytest.mark.parametrize("share", quick([0.9, 0.999999, 1.000001, 1.1], 0, 2))
def test_an_event_that_will_come_is_not_overlooked(share: float) -> None:
    """The free and the forced vibration together come as near as one likes to the sum of their sizes."""
    reach = (1 + OMEGA) / abs(1 - OMEGA**2)
    stop = Stop(("ground", "body"), 10.0, 0.0, share * reach)
    patience = {0.9: 400, 0.999999: 4000}.get(share, 100)
    response = respond(oscillator(stops={"stop": stop}), most_periods=patience)
    free = "No event comes any more" in response.message
    assert free is (share > 1)
    if share > 1:
        assert not simulate(oscillator(stops={"stop": stop}), 3000.0).events
    elif share == 0.9:
        assert simulate(oscillator(stops={"stop": stop}), 3000.0).events


def test_a_contact_that_is_lost_on_the_way_does_not_count() -> None:
    """A start beyond the stop bounces off it; what is left decays for thousands of periods."""
    stop = Stop(("ground", "body"), 50.0, 0.1, 2.0)
    mechanism = oscillator(1e-3, stops={"stop": stop})
    response = respond(mechanism, state={"body": (9.0, 0.0)})
    assert response.kind is MotionKind.PERIODIC
    assert response.motion.drive_periods < 600
    expected = 2 / abs(1 - OMEGA**2 + 1e-3j * OMEGA)
    assert response.motion.peak_to_peak["body"] == pytest.approx(expected, rel=1e-10)
    late = simulate(mechanism, 12000 / DRIVE, state={"body": (9.0, 0.0)})
    assert late.states(late.duration)[:2] == pytest.approx(response.motion.orbit.instant.state[:2], abs=1e-7)


def loosely_held(damping: float, in_contact: float) -> Mechanism:
    """A driven body in a slot, which it meets in each period, with little damping."""
    slot = Play(("ground", "body"), 0.3, in_contact, 0.2)
    return oscillator(damping, plays={"slot": slot})


def test_slow_approach_with_impacts_is_decided() -> None:
    mechanism = loosely_held(5e-4, 1e-3)
    response = respond(mechanism)
    assert (response.kind, response.period_count) == (MotionKind.PERIODIC, 1)
    orbit = response.motion.orbit
    assert orbit.stable
    assert orbit.events_per_period > 0
    assert (response.motion.drive_periods > 100, response.motion.neighbour_agrees) == (True, True)
    assert "A start a little beside this one settles to the same." in response.message
    late = orbit.flow.strobe(orbit.flow.rest(), 40_000).states[-1]
    np.testing.assert_allclose(late, orbit.instant.state, atol=1e-9)


@pytest.mark.slow
def test_an_approach_that_is_too_slow_to_wait_for_is_no_torus() -> None:
    """The distance to the orbit halves in as many drive periods as is told."""
    mechanism = loosely_held(2e-5, 1e-5)
    response = respond(mechanism, state={"body": (0.0, 0.0)})
    assert (response.kind, response.period_count) == (MotionKind.PERIODIC, 1)
    assert "so slowly that its end was not waited for" in response.message
    halved, orbit = int(re.findall(r"by half in (\d+)", response.message)[0]), response.motion.orbit
    states = orbit.flow.strobe(orbit.flow.rest(), 5 * halved).states[2 * halved :: 50]
    distances = np.linalg.norm((states - orbit.instant.state) / orbit.sizes, axis=1)
    rate = np.polyfit(50 / halved * np.arange(len(distances)), np.log2(distances), 1)[0]
    assert rate == pytest.approx(-1.0, abs=0.02)


def test_the_picture_of_a_torus_has_the_free_vibration_that_its_start_has() -> None:
    """From rest the free vibration is larger than the forced one by the ratio of frequencies."""
    line = respond(oscillator()).plot().get_lines()[0]
    times = np.asarray(line.get_xdata(), dtype=float)
    waves = [wave(omega * times) for omega in (OMEGA, 1.0) for wave in (np.sin, np.cos)]
    parts = np.linalg.lstsq(np.array(waves).T, np.asarray(line.get_ydata(), dtype=float), rcond=None)[0]
    assert math.hypot(*parts[2:]) / math.hypot(*parts[:2]) == pytest.approx(OMEGA, rel=1e-6)
