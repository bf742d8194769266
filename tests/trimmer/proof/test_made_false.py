"""Files of proofs made false by somebody who adapts sentence and fingerprint too: none is proven again.

What a change leaves true may be proven: each change here makes the theorem another one that is false, or has
the file say what nothing verifies.
"""

import math
from collections.abc import Callable
from copy import deepcopy
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import control
import numpy as np
import pytest

from tests.trimmer.proof.test_limit_cycles import LOOPS, balanced
from tests.trimmer.proof.test_motions import falling
from tests.trimmer.proof.test_orbits import ORBITS
from tests.trimmer.proof.test_readings import read
from tests.trimmer.proof.test_special_points import proven
from trimmer import ClosedLoop, ViscousFriction

pytest.importorskip("flint")
from trimmer.proof import Proof, ProofFileError, check_proof, prove_limit_cycles, prove_orbit

Data = dict[str, Any]
Change = Callable[[Data], None]


@cache
def written(kind: str, name: str) -> Proof:
    if kind == "list":
        return prove_limit_cycles(*balanced(*LOOPS[name]))
    if kind == "orbit":
        orbit = ORBITS[name]()
        return prove_orbit(orbit.subject, orbit)
    return {"motion": falling, "read": lambda: read(name), "special": lambda: proven(name)}[kind]()


def require_refused(path: Path, original: Proof, change: Change, told: str) -> None:
    """Let the file say what its data give, if they give anything."""
    data = deepcopy(original.data)
    change(data)
    replace(original, data=data).write(path)
    try:
        checked = check_proof(path)
    except ProofFileError as error:
        assert told in str(error)
        return
    assert told in checked.reason
    assert (bool(checked), checked.theorem) == (False, "")


def at(*place: str | int, by: float = 1.0, plus: float = 0.0, to: object = None) -> Change:
    """Return a change of what stands at a place of a file: another value, or the number changed."""

    def change(data: Any) -> None:
        for step in place[:-1]:
            data = data[step]
        data[place[-1]] = by * data[place[-1]] + plus if to is None else to

    return change


def all_of(*changes: Change) -> Change:
    return lambda data: [change(data) for change in changes]


def lasts(factor: float) -> Change:
    """Of what meets no event: so many periods."""
    first = at("motion", "segments", 0, "duration", by=factor)
    return all_of(first, at("motion", "periods", to=factor))


def merged(data: Data, first: int, last: int) -> None:
    """Leave out the segments from first to before last."""
    del data["motion"]["segments"][first:last]


def half(data: Data) -> None:
    """Of a motion that is its own mirror image, as a special point has it: the state with the other sign."""
    segments = data["motion"]["segments"]
    whole = sum(each["duration"] for each in segments)
    merged(data, 2, len(segments))
    segments[1].update(fired=None, duration=whole / 2 - segments[0]["duration"])
    data["motion"]["signs"] = [-1] * len(data["motion"]["state"])


def twice(data: Data) -> None:
    motion = data["motion"]
    first, *rest = motion["segments"]
    joined = {**rest[-1], **{key: first[key] for key in ("fired", "together", "at", "strict")}}
    joined["duration"] += first["duration"]
    motion["segments"] = [first, *rest[:-1], joined, *deepcopy(rest)]
    motion["periods"] *= 2


def shorter_than_its_period(data: Data) -> None:
    """End it with the last instant of the clock."""
    segments = data["motion"]["segments"]
    last = max(place for place, each in enumerate(segments) if each["at"] is not None)
    del segments[last + 1 :]


def past_a_wall_in_no_time(data: Data) -> None:
    """Let events come at angles of the drive; between two, told as 0 s apart, a function is negative."""
    motion, equations = data["motion"], data["equations"]
    size, (whole,) = len(motion["state"]) + len(equations["forcing"]), motion["segments"]

    def falls(sign: float, angle: float) -> list[float]:
        return [0.0] * (size - 2) + [sign, -sign * math.cos(angle)]

    functions = [falls(1.0, 1.0)], [falls(1.0, 1.0 + 1e-6), [0.0] * (size - 1) + [-1.0]], [falls(-1.0, 0.5)]
    equations["modes"] = [{**equations["modes"][0], "functions": each} for each in functions]
    told = (0, 1.0, 0), (1, 0.0, 0), (2, math.tau - 1.5, 0), (0, 0.5, None)
    motion["segments"] = [
        {**whole, "mode": mode, "duration": angle * equations["period"] / math.tau, "fired": fired}
        for mode, angle, fired in told
    ]


def without_limits(data: Data) -> None:
    for each in data["motion"]["segments"]:
        each["strict"] = []


def clock_of_another_period(data: Data) -> None:
    sample = data["motion"]["clock"][0]
    sample[0] *= data["equations"]["period"] / (data["equations"]["period"] - 0.3 * sample[0])


def ended_twice(data: Data) -> None:
    next(each for each in data["motion"]["segments"] if each["fired"] is not None)["at"] = 0.0


def of_a_mode_from_behind(data: Data) -> None:
    for each in data["motion"]["segments"]:
        each["mode"] -= len(data["equations"]["modes"])


def in_a_mode_that_is_no_mirror_image(data: Data) -> None:
    last = data["motion"]["segments"][-1]["mode"]
    modes = [each["equations"]["modes"] for each in data["beside"]]
    data["motion"]["segments"][-1]["mode"] = len(modes[0])
    for each in modes:
        each.append(deepcopy(each[last]))
        each[-1]["functions"].append([0.0] * (len(each[-1]["flow"][0]) - 1) + [1.0])


def twice_and_otherwise(data: Data) -> None:
    twice(data)
    resets, last = data["equations"]["resets"], data["motion"]["segments"][-1]
    last["reset"] = len(resets)
    resets.append(deepcopy(resets[-1]))
    resets[-1][1][1] += 1e-13


def less_an_event(data: Data) -> None:
    segments = data["motion"]["segments"]
    segments[1]["duration"] += segments.pop(2)["duration"]


def stiffer(data: Data) -> None:
    row = max(data["equations"]["modes"][0]["flow"], key=lambda each: max(map(abs, each)))
    row[int(np.argmax(np.abs(row)))] *= 1 + 1e-6


def another_event(data: Data) -> None:
    functions = data["equations"]["modes"][0]["functions"]
    functions.append([-each for each in functions[0]])


def beyond_its_limit(data: Data) -> None:
    rows = next(each["strict"] for each in data["motion"]["segments"] if len(each["strict"]) == 1)
    rows[0] = [-each for each in rows[0]]


def sampled_later(data: Data) -> None:
    next(each for each in data["motion"]["segments"] if each["at"])["at"] += 1e-6


def weighted(data: Data) -> None:
    for row in data["functionals"][0]["rows"]:
        row[0] *= 1 + 1e-12


def told_in_no_digits(data: Data) -> None:
    for row in data["functionals"][0]["rows"]:
        row[:] = [1e-300 * (1e-23 * each) for each in row]


def zero_elsewhere(data: Data) -> None:
    data["motion"]["segments"][1]["zeros"].append([1, 1])


def less_a_mode(data: Data) -> None:
    data["functionals"][0]["rows"].append(data["functionals"][0]["rows"][0])


def element(**value: object) -> Change:
    return lambda data: data["element"][0].update(value)


def with_two_outputs(data: Data) -> None:
    data["plant"]["C"].append(data["plant"]["C"][0])


def grown(data: Data) -> None:
    """Let G be (a s^3 + b s^2)/(s + 1), a and b such that 1 + N G = 0 at 300 rad/s and 50 times the width."""
    gain = 4 / math.pi / 5.0 * (math.sqrt(1 - 0.02**2) - 0.02j)
    needed = -(1 + 300j) / gain
    numerator = [-needed.imag / 300**3, -needed.real / 300**2, 0.0, 0.0]
    data.update(plant={"numerator": numerator, "denominator": [1.0, 1.0]}, limit_cycles=[])


FIRST = ("beside", 0, "equations")
OFF_THE_CLOCK = "the instants of the clock are not those"
OFF_IN_ITS_UNITS = all_of(at("motion", "sizes", 0, by=1e9), at("motion", "state", 0, by=1.1))
SIZES_OF_OTHERS = all_of(at("motion", "sizes", 1, by=1e-30), at("motion", "state", 0, by=1 + 1e-6))
OF_HALF_A_MOTION = all_of(at("motion", "signs", to=[]), at("kind", to="period-doubling"))
OF_ORBITS = [
    ("stable loop", half, "a part of a motion is no orbit"),
    ("stable loop", less_an_event, "an event is too far from where it was computed"),
    ("stable loop", at("motion", "state", 0, by=1 + 1e-6), "the motion begins elsewhere: state 0"),
    ("stable loop", stiffer, "the motion begins elsewhere: state 0"),
    ("stable loop", at("stable", to=False), "it is said to be unstable, and is stable"),
    ("stable loop", at("equations", "resets", 0, 0, 0, plus=1e-3), "the motion begins elsewhere: state 0"),
    ("stable loop", at("motion", "segments", -1, "duration", by=1 + 1e-6), "its period is longer by -2.65"),
    ("stable loop", another_event, "event function 1 of segment 0 is negative within it"),
    ("stable loop", zero_elsewhere, "event function 1 of segment 1 is not zero where it is said to be"),
    ("stable loop", at("motion", "segments", 1, "together", to=[0]), "two event functions come to zero at"),
    ("relay", twice, "2 times over"),
    ("ball on a wall", twice, "2 times over"),
    ("without events", lasts(3.0), "3 times over"),
    ("ball on a wall", twice_and_otherwise, "one event does different things to the states"),
    ("ball on a wall", at("equations", "resets", 0, -1, 0, to=1e-9), "what forces the states does not"),
    ("sampled, at its limit", beyond_its_limit, "a demand is beyond its limit or not, other than said"),
    ("sampled, at its limit", sampled_later, OFF_THE_CLOCK),
    ("sampled, at its limit", shorter_than_its_period, "the motion begins or ends at an event"),
    ("sampled, at its limit", at("motion", "clock", 0, 0, to=1e-300), OFF_THE_CLOCK),
    ("sampled, at its limit", clock_of_another_period, OFF_THE_CLOCK),
    ("without events", lasts(0.0), "a period is not positive"),
    # By 1e-11 it would let a motion without damping be stable.
    ("relay", at("motion", "segments", 0, "reset", to=0), "the states jump where the motion begins"),
    ("without events", past_a_wall_in_no_time, "event function 1 of segment 1 is negative within it"),
    ("without events", OFF_IN_ITS_UNITS, "of state 0 is none that the motion reaches"),
    ("without events", SIZES_OF_OTHERS, "the motion begins elsewhere: state 0"),
    ("relay", at("motion", "segments", 0, "zeros", to=[[0, 1]]), "the motion begins or ends at an event"),
    ("sampled, at its limit", ended_twice, "a segment ends without an event"),
    ("sampled, at its limit", without_limits, "the file says another theorem"),
    ("relay", at("motion", "segments", -1, "together", to=[0]), "an event function is named where none ends"),
    ("relay", at("motion", "remark", to="it is the only one"), "unknown key 'remark'"),
    ("relay", at("motion", "sizes", 0, to="1.0"), "not a number"),
    ("relay", of_a_mode_from_behind, "there is no mode -2"),
]
OF_SPECIAL_POINTS = [
    ("stops", in_a_mode_that_is_no_mirror_image, "does not end in the mode in which it begins"),
    ("stops", OF_HALF_A_MOTION, "half of a motion has signs, and no other has"),
    ("doubling", at("kind", to="fold"), "no place where a sign changes was found"),
    ("doubling", at(*FIRST, "modes", 0, "flow", 1, 0, by=1 + 1e-4), "an event is too far from where it was"),
    ("doubling", at(*FIRST, "resets", 0, -1, 0, to=1.0), "what forces the states does not return"),
]
OF_LISTS = [
    ("hysteresis before an integrator", element(hysteresis=-0.1), "hysteresis of a relay is -0.1"),
    ("relay", element(level=0.0), "level of a relay is 0.0"),
    ("relay", element(factors=[0.0]), "a factor of a relay is 0"),
    ("relay", element(deadzone=0.1), "and nothing else"),
    ("saturation", element(threshold=-0.3), "threshold of a saturation is -0.3"),
    ("the thesis's", element(gap="4e-5"), "gap of a backlash is '4e-5'"),
    ("the thesis's", element(frozen_omega=5000.0), "frozen"),
    ("the thesis's", at("limit_cycles", 0, "stable", to=True), "unknown key 'stable'"),
    ("the thesis's", with_two_outputs, "do not fit together"),
    ("hysteresis before an integrator", grown, "nothing excludes solutions towards infinite"),
]
OF_MOTIONS = [
    (at("motion", "state", 0, by=1.1), "an event is too far"),
    (all_of(at("equations", "period", to=1.0), at("motion", "periods", to=1.0)), "has neither period"),
    (at("motion", "segments", 1, "reset", to=7), "there is no such reset"),
    (at("functionals", 0, "before", to=[2]), "before an event that is none"),
    (at("motion", "segments", -1, "at", to=0.5), "too far"),
]
OF_READINGS = [
    (weighted, "the file says another theorem"),
    (at("functionals", 2, "before", to=[]), "the file says another theorem"),
    (told_in_no_digits, "a number is too large or too small for the digits"),
    (less_a_mode, "a functional does not fit the modes"),
]
CHANGES = [
    *(("orbit", *each) for each in OF_ORBITS),
    *(("special", *each) for each in OF_SPECIAL_POINTS),
    *(("list", *each) for each in OF_LISTS),
    *(("motion", "falling", *each) for each in OF_MOTIONS),
    *(("read", "ball on a wall", *each) for each in OF_READINGS),
]


@pytest.mark.parametrize(("kind", "name", "change", "told"), CHANGES)
def test_what_was_made_false_is_refused(tmp_path, kind: str, name: str, change: Change, told: str) -> None:
    require_refused(tmp_path / "proof.json", written(kind, name), change, told)


def test_a_larger_range_is_another_theorem_that_is_false(tmp_path: Path) -> None:
    loop, cycles = balanced(*LOOPS["the thesis's"])
    lower = prove_limit_cycles(loop, cycles[:1], (100.0, 4000.0))
    wider, none = (at("omega_range", to=each) for each in ([100.0, 5000.0], [100.0]))
    require_refused(tmp_path / "list.json", lower, wider, "the list lacks the solution at A = 0.000332")
    require_refused(tmp_path / "list.json", lower, none, "omega_range has 1 entries, not 2")


def test_a_loop_that_is_linear_and_vibrates_at_any_amplitude_has_no_list() -> None:
    """1 + N G = (s^2 + 1)(s + 1)/(...) with N = 0.5 s, at any amplitude."""
    plant = control.tf([1.0], [1.0, 1.0, 0.5, 1.0])
    proof = prove_limit_cycles(ClosedLoop(plant, ViscousFriction(0.5)), ())
    assert (proof.verdict, proof.theorem) == ("undecided", "")


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (lambda text: text.replace('"reason": ""', '"reason": "", "author": "nobody"'), "no 'author'"),
        (lambda text: text.replace('"reason": ""', '"reason": "by hand"'), "another theorem"),
        (lambda text: text.replace('"periods": ', '"periods": 7.0, "periods": '), "'periods' is there twice"),
        # Still true, of a relay that sees more of the same output.
        (lambda text: text.replace("8.0", "9.0"), "others than those with which it was written"),
    ],
)
def test_a_file_that_was_touched_is_refused(tmp_path: Path, content: Any, told: str) -> None:
    path = tmp_path / "orbit.json"
    written("orbit", "relay").write(path)
    touched = content(path.read_text())
    assert touched != path.read_text()
    path.write_text(touched)
    try:
        checked = check_proof(path)
    except ProofFileError as error:
        assert told in str(error)
        return
    assert not checked
    assert told in checked.reason


def test_what_a_file_calls_its_equations_is_told_as_unchecked() -> None:
    about = "Vibratory conveyor, but for shifts along which no force changes, in a frame that moves evenly"
    assert f"(of {about!r}, as it says unchecked)" in written("orbit", "an advance that is found").theorem
    assert "('frequency', as this file says unchecked)" in written("special", "doubling").theorem
