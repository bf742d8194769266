from __future__ import annotations

import pytest

from trimmer.errors import MechanismError
from trimmer.uncertainty.distributions import Normal, Uniform
from trimmer.uncertainty.sample_file import sample_file_of_text

MECHANISM = """
frequency = 110.0
[bodies]
motor = { mass = 0.035 }
[pins]
pin = { on = "ground", amplitude = 1.5e-3 }
[links]
"motor mount" = { between = ["ground", "motor"], stiffness = 200e3, damping = 3.5 }
[plays]
bridge = { between = ["motor", "pin"], stiffness = 30e3, damping = 0.4, gap = 40e-6 }
"""


def read(lines: str, mechanism: str = MECHANISM):
    return sample_file_of_text(f"{mechanism}\n[uncertainty]\n{lines}\n", "mine.toml").uncertainty


@pytest.mark.parametrize(
    ("line", "distribution"),
    [
        ('"plays.bridge.gap" = { normal = "5 um" }', Normal(40e-6, 5e-6)),
        ('"plays.bridge.gap" = { normal = "25 %" }', Normal(40e-6, 10e-6)),
        ('"plays.bridge.gap" = { normal = 1e-6, mean = "50 um" }', Normal(50e-6, 1e-6)),
        ('"plays.bridge.gap" = { uniform = ["20 um", 60e-6] }', Uniform(20e-6, 60e-6)),
        ('"plays.bridge.gap" = { uniform = "10 %" }', Uniform(36e-6, 44e-6)),
    ],
)
def test_forms(line: str, distribution) -> None:
    (scatter,) = read(line).scatters
    assert scatter.place == "plays.bridge.gap"
    assert scatter.unit == "m"
    assert type(scatter.distribution) is type(distribution)
    assert vars(scatter.distribution) == pytest.approx(vars(distribution), rel=1e-12)


def test_a_covariance_takes_its_means_from_the_file() -> None:
    places = '["bodies.motor.mass", "plays.bridge.gap"]'
    uncertainty = read(f"covariance = {{ places = {places}, matrix = [[1e-6, 0], [0, 1e-12]] }}")
    assert uncertainty.places == ("bodies.motor.mass", "plays.bridge.gap")
    assert uncertainty.scatters[0].distribution == Normal(0.035, pytest.approx(1e-3))


def test_what_nobody_knows_scatters_evenly_and_is_called_assumed() -> None:
    mechanism = MECHANISM.replace("gap = 40e-6", 'gap = "20 um..60 um"')
    uncertainty = read('"bodies.motor.mass" = { normal = "1 %" }', mechanism)
    first, second = uncertainty.scatters
    assert (first.place, first.assumed) == ("bodies.motor.mass", False)
    assert (second.place, second.assumed) == ("plays.bridge.gap", True)
    assert vars(second.distribution) == pytest.approx({"lowest": 20e-6, "highest": 60e-6})


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("", "nothing scatters"),
        ('"plays.bridge.gab" = { normal = "5 um" }', "line 13: .*did you mean plays.bridge.gap"),
        ('"plays.bridge.gap" = { normal = "5 kg" }', "line 13: uncertainty"),
        ('"plays.bridge.gap" = { normal = 0 }', "a standard deviation is positive"),
        ('"plays.bridge.gap" = { normal = true }', "give a number in m"),
        ('"plays.bridge.gap" = { norml = 1e-6 }', "did you mean normal"),
        ('"plays.bridge.gap" = { normal = 1e-6, uniform = "10 %" }', "in one way"),
        ('"plays.bridge.gap" = { uniform = ["60 um", "20 um"] }', "the first end is the smaller one"),
        ('"plays.bridge.gap" = { uniform = [1e-6] }', "give both ends"),
        ('"plays.bridge.gap" = 5', "say how it scatters"),
        ('covariance = { places = ["plays.bridge.gap"], matrix = [[-1]] }', "variances"),
        ('covariance = { places = ["plays.bridge.gap"], matrix = [[1, 2]] }', "give 1 rows of 1 numbers"),
        ("covariance = 3", "write { places ="),
        (
            'covariance = { places = ["plays.bridge.gap", "bodies.motor.mass"], matrix = [[1, 3], [3, 1]] }',
            "a correlation would exceed 1",
        ),
        (
            'covariance = { places = ["plays.bridge.gap", "bodies.motor.mass"], matrix = [[1, 3], [2, 9]] }',
            "is symmetric",
        ),
        (
            '"plays.bridge.gap" = { normal = "5 um" }\n'
            'covariance = { places = ["plays.bridge.gap"], matrix = [[1e-12]] }',
            "scatters twice",
        ),
    ],
)
def test_what_cannot_be_used_is_named(lines: str, told: str) -> None:
    with pytest.raises(MechanismError, match=told):
        read(lines)
