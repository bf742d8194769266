"""Harmonics and waveforms of pins and forces: laws, digits, brute force, superposition."""

import json
from dataclasses import replace
from pathlib import Path

import control
import numpy as np
import pytest

from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from tests.trimmer.contact.test_against_brute_force import compare
from trimmer import Body, Force, Friction, Link, Mechanism, MechanismError, Output, Pin, respond, simulate
from trimmer.command_line.main import main
from trimmer.mechanism.waves import left_out, waves_of

SAMPLES = tuple((1e-3 * np.random.default_rng(27).normal(size=33)).tolist())


def rubbed(**pin: object) -> Mechanism:
    """A part that friction and a spring join to what a pin does."""
    return Mechanism(
        {"part": Body(0.1)},
        frequency=25.0,
        pins={"cam": Pin("ground", **pin)},  # type: ignore[arg-type]
        links={"spring": Link(("cam", "part"), 1000.0, 2.0)},
        frictions={"grip": Friction(("ground", "part"), 0.3)},
        outputs={"x": Output({"part": 1.0}), "a": Output({"part": 1.0, "cam": -1.0}, "acceleration")},
    )


def lines(mechanism: Mechanism) -> np.ndarray:
    orbit = respond(mechanism).motion.orbit
    assert orbit is not None
    return np.array([orbit.measures.outputs[name].amplitudes for name in ("x", "a")])


def test_a_waveform_of_a_cosine_is_an_amplitude() -> None:
    turns = 2 * np.pi * np.arange(24) / 24
    waveform = tuple((2e-4 + 1e-3 * np.cos(turns) + 3e-4 * np.sin(3 * turns)).tolist())
    own = {"offset": 2e-4, "amplitude": 1e-3, "phase": np.pi / 2}
    as_samples, as_waves = rubbed(waveform=waveform), rubbed(**own, harmonics=((3, 3e-4, 0.0),))
    expected = lines(as_waves)
    np.testing.assert_allclose(lines(as_samples), expected, rtol=0, atol=1e-10 * abs(expected).max())
    assert left_out(as_samples.pins["cam"]) == pytest.approx(0.0, abs=1e-12)
    assert [wave.order for wave in waves_of(as_samples.pins["cam"], 1.0)] == [1, 3]


def test_harmonics_are_further_parts() -> None:
    one = rubbed(amplitude=1e-3, harmonics=[[2, 0.4e-3, 0.9], [5, 1e-4, -1.0]])
    force = Force("part", amplitude=0.4, phase=0.2, order=3, harmonics=((2, 0.3, 1.0), (1, 0.2, 0.5)))
    apart = {
        f"f{order}": Force("part", amplitude=size, phase=phase, order=order)
        for order, size, phase in ((3, 0.4, 0.2), (2, 0.3, 1.0), (1, 0.2, 0.5))
    }
    together, expected = (lines(replace(one, forces=each)) for each in ({"f": force}, apart))
    np.testing.assert_allclose(together, expected, rtol=0, atol=1e-10 * abs(expected).max())


@pytest.mark.parametrize("orders", [None, 4])
def test_waves_superpose_in_a_linear_machine(orders: int | None) -> None:
    linear = replace(rubbed(waveform=SAMPLES, orders=orders), frictions={})
    omega = 2 * np.pi * 25.0 * np.arange(1, 17)
    passes = control.tf([2.0, 1000.0], [0.1, 2.0, 1000.0])(1j * omega)
    expected = 2 * np.fft.rfft(SAMPLES)[1:] / len(SAMPLES) * passes
    expected[16 if orders is None else orders :] = 0.0
    np.testing.assert_allclose(lines(linear)[0][:16], expected, atol=1e-12 * abs(expected).max())
    assert simulate(linear, 0.4).energy.residual < 1e-11


def test_what_a_waveform_leaves_out_is_measured() -> None:
    pin = Pin("ground", waveform=SAMPLES, orders=5)
    turns = 2 * np.pi * np.arange(33) / 33
    kept = sum(w.amplitude * np.sin(w.order * turns + w.phase) for w in waves_of(pin, 1.0))
    values = np.array(SAMPLES) - np.mean(SAMPLES)
    assert left_out(pin) == pytest.approx(float(np.std(values - kept) / np.std(values)), rel=1e-12)
    assert left_out(replace(pin, orders=None)) == pytest.approx(0.0, abs=1e-12)
    assert left_out(Pin("ground", waveform=(2.0,) * 8)) == 0.0


def with_waves(seed: int) -> Mechanism:
    """A random mechanism whose pins have a harmonic more, and whose forces a waveform."""
    made, random = random_mechanism(seed), np.random.default_rng(seed)
    pins = {
        name: replace(pin, harmonics=((2, 0.3 * pin.amplitude, float(random.uniform(0, 6))),))
        for name, pin in made.pins.items()
    }
    forces = {
        name: replace(force, waveform=tuple((force.amplitude * random.normal(size=9)).tolist()), orders=3)
        for name, force in made.forces.items()
    }
    return replace(made, pins=pins, forces=forces)


@pytest.mark.parametrize("seed", quick(range(20), 5))
def test_random_mechanisms_with_waves(seed: int) -> None:
    compare(with_waves(seed), 2)


CAM = """frequency = 25.0
[bodies]
part = { mass = 0.1 }
[pins]
cam = { on = "ground", waveform = "cam.csv" }
[links]
spring = { between = ["cam", "part"], stiffness = 1000.0, damping = 2.0 }
"""


def table(phases: np.ndarray) -> str:
    rows = zip(phases.tolist(), np.sin(2 * np.pi * phases).round(6).tolist(), strict=True)
    return "".join(["phase,value\n", *(f"{phase!r},{value!r}\n" for phase, value in rows)])


def test_a_waveform_is_a_table_beside_the_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "cam.csv").write_text(table((np.arange(50) / 50).round(4)))
    (tmp_path / "cam.toml").write_text(CAM)
    mechanism = Mechanism.from_toml(tmp_path / "cam.toml")
    assert Mechanism.from_toml_text(mechanism.to_toml()) == mechanism
    for command, *options in (["simulate", "--duration", "0.1"], ["respond"]):
        call = [command, str(tmp_path / "cam.toml"), *options]
        assert main([*call, "--json"]) == 0
        share = json.loads(capsys.readouterr().out)["waveforms_left_out"]["pins.cam"]
        assert share == pytest.approx(left_out(mechanism.pins["cam"]), rel=1e-12)
        assert main(call) == 0
        assert "The waveform of pins.cam is cut off at its highest order" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (None, "no such file"),
        (table(np.arange(9) / 8), "the phase 1 is the phase 0 again; leave its line out"),
        (table(np.arange(1, 9) / 9), "the phases must be evenly spaced from 0 on"),
        (table(np.array([0.0, 0.2, 0.5])), "the phases must be evenly spaced from 0 on"),
        ("phase,lift\n0,1\n0.5,2\n", "the columns phase, lift; it needs phase and value"),
        (table(np.arange(2) / 2), "has 2 samples; give 3 to"),
    ],
)
def test_tables_that_are_no_waveform(tmp_path: Path, text: str | None, reason: str) -> None:
    if text is not None:
        (tmp_path / "cam.csv").write_text(text)
    (tmp_path / "cam.toml").write_text(CAM)
    with pytest.raises(MechanismError, match=r"line 5: pins\.cam\.waveform") as caught:
        Mechanism.from_toml(tmp_path / "cam.toml")
    assert reason in str(caught.value)


@pytest.mark.parametrize(
    ("pin", "place", "reason"),
    [
        ({"harmonics": ()}, "harmonics", "give at least one row"),
        ({"harmonics": ((2, 1.0),)}, "harmonics", "[order, amplitude in m, phase in rad]"),
        ({"harmonics": ((1.5, 1.0, 0.0),)}, "harmonics.1.order", "a whole number from 1 on"),
        ({"harmonics": ((2, 1.0, 0.0), (3, float("inf"), 0.0))}, "harmonics.2.amplitude", "must be finite"),
        ({"orders": 3}, "orders", "only a waveform has orders"),
        ({"waveform": SAMPLES, "orders": 17}, "orders", "33 samples have the orders 1 to 16"),
        ({"waveform": (1.0, float("nan"), 2.0)}, "waveform", "all samples must be finite"),
        ({"waveform": SAMPLES, "orders": 2.0}, "orders", "33 samples have the orders 1 to 16"),
        ({"waveform": SAMPLES, "orders": True}, "orders", "33 samples have the orders 1 to 16"),
        ({"waveform": ("a",) * 5}, "waveform", "name a table of phase and value"),
        ({"waveform": 5}, "waveform", "name a table of phase and value"),
    ],
)
def test_waves_that_are_none(pin: dict[str, object], place: str, reason: str) -> None:
    with pytest.raises(MechanismError) as caught:
        rubbed(**pin)
    assert f"pins.cam.{place}" in str(caught.value)
    assert reason in str(caught.value)


def test_each_number_of_a_harmonic_has_a_place() -> None:
    made = rubbed(amplitude=1e-3, harmonics=((2, 4e-4, 0.9),))
    assert made.places["pins.cam.harmonics.1.amplitude"] == "m"
    other = made.with_value("pins.cam.harmonics.1.amplitude", "0.5 mm")
    assert other.value("pins.cam.harmonics.1.amplitude") == 5e-4
    assert other.pins["cam"].harmonics == ((2, 5e-4, 0.9),)
    with pytest.raises(MechanismError, match="no frequency"):
        replace(made, frequency=None, pins={"cam": Pin("ground", harmonics=((2, 4e-4, 0.9),))})
