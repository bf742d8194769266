"""Motions that do not repeat: what is said of them is what an own look at the same motion says."""

import json
import math

import numpy as np
import pytest

from tests.trimmer.response.mechanisms import example
from trimmer import Body, Force, Link, Mechanism, MotionKind, Output, Response, Stop, respond, simulate
from trimmer.response.results.response_json import response_json
from trimmer.response.statistics.window import joined, watch

SAMPLES = 400  # In each drive period


@pytest.fixture(scope="module")
def torus() -> Response:
    return respond(example("second-play"), most_periods=100)


@pytest.fixture(scope="module")
def exact(torus: Response):
    """The same motion, from rest to the end of the window."""
    return simulate(torus.mechanism, response_json(torus)["drive_periods"] / torus.mechanism.frequency)


def test_a_torus_has_the_numbers_of_samples_of_the_same_motion(torus: Response, exact) -> None:
    mechanism, motion = torus.mechanism, torus.motion
    content = response_json(torus)
    assert (content["kind"], content["period_count"], content["multipliers"]) == ("torus", None, [])
    periods, watched = content["drive_periods"], content["window_periods"]
    assert periods == 100 + watched
    assert motion.window.duration == pytest.approx(watched / mechanism.frequency)
    steps = np.arange(watched * SAMPLES) + 0.5
    times = (100 + steps / SAMPLES) / mechanism.frequency
    for name in mechanism.outputs:
        values, found = exact.output(name, times), content["outputs"][name]
        assert found["mean"] == pytest.approx(values.mean(), abs=1e-4 * values.std())
        assert found["rms"] == pytest.approx(values.std(), rel=1e-4)
        assert found["peak_to_peak"] == pytest.approx(np.ptp(values), rel=1e-4)
        wave = np.exp(-2j * np.pi * np.outer([1, 3], steps) / SAMPLES)
        lines = abs(2 * wave @ (values - values.mean())) / len(steps)
        assert [found["harmonics"][0], found["harmonics"][2]] == pytest.approx(lines, rel=1e-2)
        frequencies = np.array(content["spectrum"]["frequencies"])
        assert frequencies[-1] == pytest.approx(32 * mechanism.frequency)
        density = np.array(content["spectrum"]["densities"][name])
        assert density.sum() * frequencies[1] == pytest.approx(values.var(), rel=0.05)
        assert frequencies[np.argmax(density)] == pytest.approx(mechanism.frequency, rel=1e-9)
        low, high = found["rms_interval"]
        assert low < values.std() < high
    for body in mechanism.bodies:
        edges = (100 + np.arange(watched * SAMPLES + 1) / SAMPLES) / mechanism.frequency
        rates = np.diff(exact.velocity(body, edges)) * SAMPLES * mechanism.frequency
        found = content["bodies"][body]["rms_acceleration"]
        assert found == pytest.approx(math.sqrt(np.mean(rates**2)), rel=0.02)
    events = sum(event.time > 100 / mechanism.frequency for event in exact.events)
    assert motion.events_per_period == pytest.approx(events / watched, abs=2 / watched)
    assert "stays near it" in torus.message
    assert abs(content["lyapunov"]["value"]) < 3 * content["lyapunov"]["uncertainty"]
    json.dumps(content, allow_nan=False)


def test_contacts_and_frictions_of_a_torus_are_those_of_the_same_motion(torus: Response, exact) -> None:
    mechanism, content = torus.mechanism, response_json(torus)
    watched = content["window_periods"]
    times = (100 + (np.arange(watched * SAMPLES) + 0.5) / SAMPLES) / mechanism.frequency
    begin = simulate(mechanism, 100 / mechanism.frequency).energy
    assert content["contacts"], "what follows would hold of nothing"
    for name, found in content["contacts"].items():
        speeds = [
            event.speed
            for event in exact.events
            if event.kind.value == "contact made" and event.part == name and event.time > times[0]
        ]
        assert found["impacts_per_period"] == pytest.approx(len(speeds) / watched, abs=2 / watched)
        assert found["impact_speed"] == pytest.approx(max(speeds), rel=1e-6)
        force = exact.contact_force(name, times)
        assert found["largest_force"] == pytest.approx(max(abs(force)), rel=1e-2)
        assert found["share_of_time"] == pytest.approx(np.mean(force != 0), abs=1e-2)
    for name, found in content["frictions"].items():
        lost = exact.energy.frictions[name] - begin.frictions[name]
        assert found["work_per_period"] == pytest.approx(lost / watched, rel=1e-6)
        assert found["power"] == pytest.approx(lost / watched * mechanism.frequency, rel=1e-6)


def test_two_windows_after_one_another_are_one(torus: Response) -> None:
    whole = torus.motion.window
    first = watch(whole.flow, whole.begin, 200)
    second = watch(first.flow, first.end, whole.periods - 200)
    both = joined(first, second)
    assert (both.periods, both.ending, both.end.phase) == (whole.periods, whole.ending, whole.end.phase)
    states = whole.flow.strobe(whole.begin, whole.periods).states
    np.testing.assert_allclose(both.states, states[:-1], rtol=0, atol=1e-9 * abs(states).max())
    np.testing.assert_allclose(both.end.state, states[-1], rtol=0, atol=1e-9 * abs(states).max())
    for name, total in whole.rms.items():
        assert both.rms[name].value == pytest.approx(total.value, rel=1e-9)
        assert both.rms[name].uncertainty == pytest.approx(total.uncertainty, rel=1e-6)
        assert both.output_means[name].value == pytest.approx(whole.output_means[name].value, abs=1e-9)
        assert both.peak_to_peak[name] == pytest.approx(whole.peak_to_peak[name], rel=1e-9)
        assert both.harmonics[name] == pytest.approx(whole.harmonics[name], rel=1e-6)
        assert both.spectrum[1][name] == pytest.approx(whole.spectrum[1][name], rel=1e-6)
    assert both.exponents[0].value == pytest.approx(
        first.growth[:, 0].mean() * 200 / whole.periods
        + second.growth[:, 0].mean() * (1 - 200 / whole.periods)
    )


def bouncing(amplitude: float = 1.0) -> Mechanism:
    """A driven body with a damper, before a stop without one, so that all volumes shrink evenly."""
    return Mechanism(
        {"body": Body(1.0)},
        frequency=0.5 / (2 * math.pi),
        links={"spring": Link(("ground", "body"), 1.0, 0.1)},
        stops={"wall": Stop(("ground", "body"), 30.0, 0.0, 0.1)},
        forces={"push": Force("body", amplitude=amplitude)},
        outputs={"x": Output({"body": 1.0})},
    )


@pytest.fixture(scope="module")
def chaos() -> Response:
    return respond(bouncing(), most_periods=60)


def test_exponents_of_chaos_add_up_to_the_divergence_of_the_flow(chaos: Response) -> None:
    largest, smallest = chaos.motion.window.exponents
    assert chaos.kind is MotionKind.CHAOTIC
    assert largest.value + smallest.value == pytest.approx(-0.1 * 2 * math.pi / 0.5, rel=1e-7)
    assert chaos.motion.lyapunov == largest
    assert largest.value > 3 * largest.uncertainty > 0
    assert "a neighbouring motion leaves it" in chaos.message
    assert "Chaos over 572 drive periods may still be a transient" in chaos.message


def test_what_stands_still_beside_chaos_is_known_to_rounding() -> None:
    text = """
    frequency = 0.079577471545947673
    bodies = { body = { mass = 1.0 }, beside = { mass = 1.0 } }
    links.spring = { between = ["ground", "body"], stiffness = 1.0, damping = 0.1 }
    links.post = { between = ["ground", "beside"], stiffness = 3.0, damping = 1.0 }
    stops.wall = { between = ["ground", "body"], stiffness = 30.0, gap = 0.1 }
    forces.push = { on = "body", amplitude = 1.0 }
    forces.pull = { on = "beside", constant = 1.0 }
    outputs = { x = { body = 1.0 }, y = { beside = 1.0 } }
    """
    motion = respond(Mechanism.from_toml_text(text), most_periods=60).motion
    assert motion.kind is MotionKind.CHAOTIC
    assert motion.rms["y"].value + motion.rms["y"].uncertainty <= motion.peak_to_peak["y"] < 1e-14


@pytest.mark.slow
def test_chaos_is_scaled_with_forces_and_gaps(chaos: Response) -> None:
    """By powers of two, which round nothing."""
    scaled, first = bouncing(4.0).with_value("stops.wall.gap", 0.4), chaos.motion
    second = respond(scaled, most_periods=60).motion
    assert second.rms["x"].value == pytest.approx(4.0 * first.rms["x"].value, rel=1e-9)
    assert second.peak_to_peak["x"] == pytest.approx(4.0 * first.peak_to_peak["x"], rel=1e-9)
    assert second.lyapunov.value == pytest.approx(first.lyapunov.value, rel=1e-9)
    assert second.events_per_period == first.events_per_period


def test_what_swings_for_ever_without_a_drive_tells_what_leans_on_it() -> None:
    """Two free vibrations, one against a stop that is pressed: its force is that of paper."""
    swinging = Mechanism(
        {"a": Body(1.0), "b": Body(1.7)},
        links={"l": Link(("ground", "a"), 1234.0), "n": Link(("ground", "b"), 4000.0)},
        stops={"u": Stop(("ground", "b"), 500.0, gap=-0.2), "far": Stop(("ground", "a"), 100.0, gap=1.0)},
        outputs={"x": Output({"a": 1.0})},
    )
    response = respond(swinging, state={"a": (0.01, 0.0), "b": (0.001, 0.0)})
    assert response.kind is MotionKind.TORUS
    contacts = response_json(response)["contacts"]
    # From 1 mm, its turning point: it swings about the place where both springs balance, below that.
    assert contacts["u"]["largest_force"] == pytest.approx(500.0 * 0.201, rel=1e-12)
    assert [contacts["u"][key] for key in ("impacts_per_period", "share_of_time")] == [0.0, 1.0]
    assert contacts["far"]["largest_force"] == contacts["far"]["share_of_time"] == 0.0


@pytest.mark.slow
def test_what_drifts_through_a_gap_is_on_no_torus() -> None:
    """The axis is at rest, and the load flies at 0.5 mm/s through its gap; all else is rounding."""
    text = """
    [bodies]
    axis = { mass = 0.764922 }
    load = { mass = 1.366339 }
    [links]
    guide = { between = ["ground", "axis"], stiffness = 22.1, damping = 6.13 }
    [plays]
    joint = { between = ["axis", "load"], stiffness = 2500.0, damping = 42.75, gap = 0.056557 }
    [outputs]
    y = { axis = 1 }
    [controllers.k]
    kind = "cascade"
    measure = "y"
    acts = ["ground", "axis"]
    reference = "path"
    kp = 6.375
    kv = 10.44
    ti = 0.98
    sample = 0.003
    [references]
    path = { step = 1.0 }
    """
    motion = respond(Mechanism.from_toml_text(text)).motion
    assert motion.kind is MotionKind.UNDECIDED
    assert motion.rms["y"].value <= 0.5 * motion.peak_to_peak["y"]
