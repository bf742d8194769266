"""What is read of a proven orbit: held against SciPy on the equations of the file; made false, refused."""

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import simpson, solve_ivp

from tests.quick import quick
from tests.trimmer.proof.test_orbits import ORBITS, machine

pytest.importorskip("flint")
from trimmer.proof import Proof, check_proof, prove_orbit

READ = {
    "without events": ("outputs.mass", "bodies.mass"),
    "the thesis's trimmer": ("outputs.stroke", "bodies.motor", "frictions.blade", "contacts.bridge"),
    "ball on a wall": ("outputs.ball", "outputs.height", "contacts.plate"),
    "an advance that is found": ("velocities.part", "rates.part", "frictions.grip"),
    "an advance that is known": ("outputs.moment of the teeth", "outputs.speed of the gear"),
    "stable loop": ("outputs.output", "outputs.element_input"),
    "stick-slip": ("bodies.block", "frictions.rub"),
    "sampled, at its limit": ("outputs.angle", "frictions.rub"),
}
POINTS = 6001


def read(name: str) -> Proof:
    orbit = ORBITS[name]()
    return prove_orbit(orbit.subject, orbit, readings=READ[name])


def told(proof: Proof, about: str) -> dict[str, tuple[float, float]]:
    (words,) = re.findall(rf"calls '{re.escape(about)}', unchecked, is: (.*?)\. (?=[A-Z])", proof.theorem)
    found = re.findall(r"([a-z][a-z 0-9]*) between (\S+) and (\S+?)(?:, |$)", words)
    return {word: (float(lower), float(upper)) for word, lower, upper in found}


def followed(data: dict[str, Any]) -> Iterator[tuple[int, float, np.ndarray]]:
    """Integrate the equations of a file by Runge and Kutta; yield mode, duration and Z of each segment."""
    motion, equations = data["motion"], data["equations"]
    z, n = np.array([*motion["state"], *equations["forcing"]]), len(motion["state"])
    turns = np.zeros((len(z) - n, len(z) - n))
    for i, k, order in motion["turning"]:
        turns[i, k] = 2 * np.pi * order / equations["period"]
        turns[k, i] = -turns[i, k]
    for each in motion["segments"]:
        flow = np.vstack(
            [equations["modes"][each["mode"]]["flow"], np.hstack([np.zeros((len(turns), n)), turns])]
        )
        times = np.linspace(0.0, each["duration"], POINTS)
        z = z if each["reset"] is None else np.array(equations["resets"][each["reset"]]) @ z
        states = z[:, None] * np.ones(POINTS)
        if each["duration"]:
            states = solve_ivp(
                lambda _, y, flow=flow: flow @ y, (0.0, times[-1]), z, "DOP853", times, rtol=1e-12, atol=1e-14
            ).y
        yield each["mode"], each["duration"], states
        z = states[:, -1]


@pytest.mark.parametrize("name", quick(READ, 1, 2, 3, 5))
def test_what_is_read_is_what_runge_and_kutta_find(name: str) -> None:
    proof = read(name)
    assert (proof.verdict, proof.reason) == ("proven", "")
    segments = list(followed(proof.data))
    period = sum(duration for _, duration, _ in segments)
    for each in proof.data["functionals"]:
        rows = np.array(each["rows"])
        values = [rows[mode] @ states for mode, _, states in segments]
        lasting = [(v, t) for v, (_, t, _) in zip(values, segments, strict=True) if t]
        size = max(abs(v).max() for v in values)
        mean, square = (
            sum(simpson(v**power, x=np.linspace(0.0, t, POINTS)) for v, t in lasting) / period
            for power in (1, 2)
        )
        lowest, highest = min(v.min() for v, _ in lasting), max(v.max() for v, _ in lasting)
        expected = {
            "smallest": lowest,
            "largest": highest,
            "peak to peak": highest - lowest,
            "integral": mean * period,
            "mean": mean,
            "root mean square": np.sqrt(square),
            "about the mean": np.sqrt(max(0.0, square - mean**2)),
            **{f"before event {k + 1}": values[k][-1] for k in each["before"]},
        }
        found = told(proof, each["about"])
        assert found.keys() == expected.keys()
        for word, (lower, upper) in found.items():
            scale = size * (period if word == "integral" else 1.0)
            assert lower - 2e-6 * scale <= expected[word] <= upper + 2e-6 * scale, (each["about"], word)
            assert upper - lower <= 1e-13 * scale, (each["about"], word)


def test_a_linear_motion_has_the_peaks_and_means_of_its_response() -> None:
    """m x'' + d x' + k x = F sin(omega t): a sine about zero of the modulus of F over the stiffness."""
    still = machine("oscillator-stop.toml")
    proof = read("without events")
    found = told(proof, "outputs.mass")
    mass, link = still.bodies["mass"].mass, next(iter(still.links.values()))
    force, omega = next(iter(still.forces.values())).amplitude, 2 * np.pi * still.frequency
    amplitude = force / abs(link.stiffness - mass * omega**2 + 1j * omega * link.damping)
    expected = {
        "smallest": -amplitude,
        "largest": amplitude,
        "peak to peak": 2 * amplitude,
        "root mean square": amplitude / np.sqrt(2.0),
    }
    for word, value in expected.items():
        assert found[word] == pytest.approx((value, value), rel=1e-12)


@pytest.mark.parametrize("word", ["smallest", "peak to peak", "mean", "about the mean", "before event 1"])
def test_a_number_that_was_moved_off_is_refused(tmp_path: Path, word: str) -> None:
    proof = read("ball on a wall")
    at = proof.theorem.index("contacts.plate', unchecked, is: ")
    at = proof.theorem.index(f"{word} between", at)
    off = proof.theorem.index(" and ", at) - 1
    moved = f"{proof.theorem[:off]}{(int(proof.theorem[off]) + 1) % 10}{proof.theorem[off + 1 :]}"
    replace(proof, theorem=moved).write(tmp_path / "read.json")
    refused = check_proof(tmp_path / "read.json")
    assert (refused.verdict, refused.theorem) == ("refuted", "")
    assert "the file says another theorem" in refused.reason


@pytest.mark.parametrize(
    ("name", "of", "reason"),
    [
        ("ball on a wall", "outputs.y", "outputs.y is nothing that is read of this motion"),
        ("an advance that is found", "outputs.slip", "outputs.slip changes with a shift"),
    ],
)
def test_what_is_not_read_is_undecided_and_named(name: str, of: str, reason: str) -> None:
    orbit = ORBITS[name]()
    proof = prove_orbit(orbit.subject, orbit, readings=[of])
    assert (proof.verdict, proof.theorem) == ("undecided", "")
    assert reason in proof.reason
