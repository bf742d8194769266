"""Every number that commands tell of loops, as JSON and as text, of results that are made by hand."""

from __future__ import annotations

import json
from dataclasses import asdict
from types import SimpleNamespace as Made

import numpy as np
import pytest

from tests.trimmer.command_line.told import cells
from trimmer.command_line.json_values import document
from trimmer.command_line.loops import limit_cycles_text, linear_text, orbits_text
from trimmer.command_line.loops import motion_text as of_loop
from trimmer.linear.model import InputChannels
from trimmer.motion.motion import Outcome
from trimmer.motion.switched_component import EventKind
from trimmer.parameters import TrimmerParameters

TURN = 2 * np.pi
CERTIFICATE = Made(
    method="search",
    omegas=(10.0, 1e3),
    outside_excluded=True,
    complete=False,
    boxes=12,
    undecided=[Made(omegas=(1.0, np.inf), amplitudes=(3.0, 4.0))],
    smallest_gain=0.25,
    winding_number=2,
    winding_omegas=(5.0, 2e3),
    index_sum=3,
    zero_on_axis=False,
    doubts=("one",),
    other_doubts=(),
)
CERTIFIED = {
    **{name: each for name, each in vars(CERTIFICATE).items() if name not in ("undecided", "other_doubts")},
    "omegas": [10.0, 1e3],
    "winding_omegas": [5.0, 2e3],
    "doubts": ["one"],
    "undecided": [{"amplitudes": [3.0, 4.0], "omegas": [1.0, None]}],
}
CYCLE = {
    "amplitude": 2e-5,
    "omega": 691.0,
    "frequency": 109.975,
    "stable": True,
    "residual": 1e-9,
    "crossing_angle": 0.5,
    "near_tangency": False,
    "other_unstable_poles": 1,
}


def test_json_has_no_number_that_is_none() -> None:
    assert document({"a": [1.5]}) == '{\n  "a": [\n    1.5\n  ]\n}'
    with pytest.raises(ValueError, match="not JSON compliant"):
        document({"a": np.inf})


def test_limit_cycles_are_in_the_json_with_their_certificate(monkeypatch: pytest.MonkeyPatch) -> None:
    leakage = tuple(0.5**n for n in limit_cycles_text.HARMONICS)
    monkeypatch.setattr(limit_cycles_text, "harmonic_leakage", lambda loop, cycle: leakage)
    balance = Made(limit_cycles=[Made(**CYCLE)], certificate=CERTIFICATE)
    data = json.loads(limit_cycles_text.as_json(Made(element="E"), balance))
    leaked = {str(n): 0.5**n for n in limit_cycles_text.HARMONICS}
    assert data == {
        "element": "'E'",
        "limit_cycles": [CYCLE | {"harmonic_leakage": leaked}],
        "certificate": CERTIFIED,
    }


def test_what_was_identified_is_in_the_json() -> None:
    found = Made(time_constant=np.inf, limit_cycle=Made(**CYCLE))
    interval = Made(lowest=1e-3, highest=np.inf, frequencies=(738.0, 742.0))
    band = Made(frequencies=(700.0, np.inf), lower=Made(time_constant=0.5), upper=Made(time_constant=np.nan))
    made = {"frequency": 740.0, "frequency_uncertainty": 2.0, "bands": [band], "intervals": [interval]}
    data = json.loads(
        limit_cycles_text.identified_as_json(Made(**made, time_constants=[found], nearest=None))
    )
    assert data == {
        "frequency": 740.0,
        "frequency_uncertainty": 2.0,
        "time_constants": [{"time_constant": None, "limit_cycle": CYCLE}],
        "intervals": [{"lowest": 1e-3, "highest": None, "frequencies": [738.0, 742.0]}],
        "bands": [{"frequencies": [700.0, None], "time_constants": [0.5, None]}],
        "nearest": None,
    }
    found.time_constant = 0.25
    data = json.loads(limit_cycles_text.identified_as_json(Made(**made, time_constants=[], nearest=found)))
    assert data["nearest"] == {"time_constant": 0.25, "limit_cycle": CYCLE}


def made_orbits(prediction: object, **changes: object) -> list[Made]:
    usual = {
        "amplitude": 3e-5,
        "period": 0.01,
        "frequency": 100.0,
        "stable": True,
        "neutral": False,
        "multipliers": np.array([1.0, 0.25j]),
        "harmonics": np.array([3j, -1.0]),
        "switching_times": np.array([0.001, 0.006]),
        "residual": 1e-12,
        "amplitude_error": np.nan,
        "frequency_error": -0.5,
        "largest_multiplier": 0.25,
    }

    class Found(list[Made]):
        success = True
        search = Made(sentence="searched all")
        families = (Made(member=Made(amplitude=3e-5), met=2, amplitudes=(1e-5, 3e-5), sentence="it is one"),)

    return Found([Made(**usual | changes, prediction=prediction)])


def test_orbits_are_told_with_what_was_not_found() -> None:
    orbits = made_orbits(None)
    missed = Made(**CYCLE)
    predictions = Made(limit_cycles=[missed], certificate=CERTIFICATE)
    data = json.loads(orbits_text.as_json("E", predictions, orbits))
    assert data["orbits"] == [
        {
            "amplitude": 3e-5,
            "period": 0.01,
            "frequency": 100.0,
            "stable": True,
            "neutral": False,
            "multipliers": [[1.0, 0.0], [0.0, 0.25]],
            "harmonics": [3.0, 1.0],
            "switching_times": [0.001, 0.006],
            "residual": 1e-12,
            "amplitude_error": None,
            "frequency_error": -0.5,
        }
    ]
    assert data["families"] == [{"amplitude": 3e-5, "met": 2, "amplitudes": [1e-5, 3e-5]}]
    assert data["not_found"] == [{"amplitude": 2e-5, "frequency": 109.975}]
    assert data["certificate"] == CERTIFIED
    assert (data["element"], data["search"], data["success"]) == ("'E'", "searched all", True)
    lines = orbits_text.as_text("E", predictions, orbits).splitlines()
    assert lines[0] == "Exact limit cycles of 'E'"
    assert cells(lines[2:3]) == [["3e-05", "100", "yes", "0.25", "none"]]
    assert lines[3] == "predicted, but not found: amplitude 2e-05 at 109.975 Hz"
    assert lines[4].startswith("predictions searched from 10 to 1000 rad/s")
    assert (lines[5][:9], lines[6], lines[7], lines[8][:10]) == (
        *("undecided", "searched all", "It is one."),
        "multiplier",
    )
    orbits.clear()
    orbits.families = ()
    assert orbits_text.as_text("E", predictions, orbits).splitlines()[-1] == "searched all"


def made_summary() -> Made:
    mode = Made(
        eigenvalue=-3 + 4j,
        omega_natural=5.0,
        omega_damped=4.0,
        frequency=4 / TURN,
        damping_ratio=0.6,
        shape=np.array([1.0, 0.5j, -0.25, 3 + 4j]),
    )
    return Made(
        parameters=TrimmerParameters.thesis(),
        output=Made(label="q2-q4"),
        channels=InputChannels.DISPLACEMENT_ONLY,
        modes=[mode],
        factored=Made(poles=np.array([-3 + 4j, -3 - 4j]), zeros=np.array([-2.0 + 0j]), static_gain=np.inf),
        gain_crossings=[3.0],
        real_axis_crossings=[Made(omega=2 * TURN, value=-0.5)],
        low_pass=None,
        peaks=(Made(omega=4 * TURN, magnitude=np.inf),),
        antiresonances=(Made(omega=8 * TURN, magnitude=0.1),),
        roll_off=-40.0,
        encirclements=2,
    )


def test_the_linear_trimmer_is_in_the_json() -> None:
    summary = made_summary()
    data = json.loads(linear_text.as_json(summary))
    assert data == {
        "parameters": asdict(summary.parameters),
        "output": "q2-q4",
        "channels": summary.channels.value,
        "stable": True,
        "modes": [
            {
                "eigenvalue": [-3.0, 4.0],
                "omega_natural": 5.0,
                "omega_damped": 4.0,
                "frequency": 4 / TURN,
                "damping_ratio": 0.6,
                "shape": [[1.0, 0.0], [0.0, 0.5], [-0.25, 0.0], [3.0, 4.0]],
            }
        ],
        "poles": [[-3.0, 4.0], [-3.0, -4.0]],
        "zeros": [[-2.0, 0.0]],
        "static_gain": None,
        "gain_crossings": [3.0],
        "real_axis_crossings": [{"omega": 2 * TURN, "value": -0.5}],
        "bandwidth": None,
        "bandwidth_crossings": None,
        "peaks": [{"omega": 4 * TURN, "magnitude": None}],
        "dips": [{"omega": 8 * TURN, "magnitude": 0.1}],
        "roll_off": -40.0,
        "encirclements": 2,
    }
    summary.low_pass = Made(bandwidth=5.0, crossings=[5.0, 7.0])
    summary.factored.static_gain = 2.0
    data = json.loads(linear_text.as_json(summary))
    assert (data["bandwidth"], data["bandwidth_crossings"], data["static_gain"]) == (5.0, [5.0, 7.0], 2.0)


def test_the_linear_trimmer_is_told() -> None:
    summary = made_summary()
    head, modes, roots, gain, extrema, crossings = linear_text.as_text(summary).split("\n\n")
    assert head == "Linear trimmer: output q2-q4, pin acts by displacement only, stable"
    assert cells(modes)[1] == [
        "Hz",
        "rad/s",
        "damping ratio",
        "eigenvalue, 1/s",
        "|q1|",
        "|q2|",
        "|q3|",
        "|q4|",
    ]
    assert cells(modes)[2] == ["0.63662", "5", "0.6", "-3 ± 4j", "1", "0.5", "0.25", "5"]
    assert cells(roots)[2:] == [["-3 ± 4j", "-2"]]
    assert gain.splitlines()[0] == "Gain" and len(gain.splitlines()) == 7
    assert cells(extrema)[2:] == [
        ["peak", "25.1327", "4", "inf", "inf"],
        ["dip", "50.2655", "8", "0.1", "-20"],
    ]
    assert cells(crossings)[2:] == [["12.5664", "2", "-0.5"]]
    summary.channels = InputChannels.DISPLACEMENT_AND_VELOCITY
    summary.modes[0].eigenvalue = 4j
    head = linear_text.as_text(summary).split("\n\n")[0]
    assert head.endswith("pin acts by displacement and velocity, not asymptotically stable")


def made_motion() -> Made:
    events = [
        Made(time=time, kind=EventKind.IMPACT, component="play", mode=mode)
        for time, mode in ((0.475, "upper contact"), (0.48, "lower contact"), (0.485, "upper contact"))
    ]
    return Made(
        duration=0.5,
        outcome=Outcome.COMPLETED,
        success=True,
        message="done",
        touches=3,
        events=events,
        loop=Made(modes=Made(system=Made(drive=None)), model=Made(output_labels=["q2-q4", "other"])),
        output=lambda times: 2.0 * times,
        element_input=lambda times: 4.0 * times,
        element_output=lambda times: -8.0 * times,
    )


def test_the_motion_of_a_loop_is_told_in_full() -> None:
    motion = made_motion()
    data = json.loads(of_loop.as_json(motion))
    # The last tenth lasts 0.05 s: half of what each signal goes through then.
    assert data.pop("last_amplitudes") == pytest.approx({"q2-q4": 0.05, "pin": 0.1, "bridge": 0.2})
    assert data.pop("last_frequency") == pytest.approx(100.0)
    kind = EventKind.IMPACT.value
    assert data == {
        "duration": 0.5,
        "outcome": "completed",
        "success": True,
        "message": "done",
        "touches": 3,
        "events": [
            {"time": 0.475, "kind": kind, "component": "play", "mode": "upper contact"},
            {"time": 0.48, "kind": kind, "component": "play", "mode": "lower contact"},
            {"time": 0.485, "kind": kind, "component": "play", "mode": "upper contact"},
        ],
    }
    lines = of_loop.as_text(motion).splitlines()
    assert lines[0] == f"Motion of 0.5 s: {Outcome.COMPLETED.value}"
    assert lines[1] == f"  play: 3 x {kind}"
    assert [line.split() for line in lines[3:6]] == [
        ["q2-q4", "0.05", "m"],
        ["pin", "0.1", "m"],
        ["bridge", "0.2", "m"],
    ]
    assert lines[6].endswith(": 100 per second")
    motion.events[1].time, motion.events[1].mode = 0.475, "upper contact"
    assert of_loop._frequency(motion) == pytest.approx(200.0)
    motion.loop.modes.system.drive = "driven"
    assert len(of_loop.as_text(motion).splitlines()) == 6
