"""The table [uncertainty] of a file: what scatters, and what cannot be used."""

import pytest

from trimmer.errors import MechanismError
from trimmer.uncertainty import Normal, Uniform
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
        ('"plays.bridge.gap" = { normal = "10 %", mean = "50 um" }', Normal(50e-6, 5e-6)),
        ('"plays.bridge.gap" = { normal = 2e-6, mean = 3e-5 }', Normal(3e-5, 2e-6)),
        ('"plays.bridge.gap" = { normal = " 10 % ", mean = "-60 um" }', Normal(-6e-5, 6e-6)),
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
    large = 10**21  # Of no integer of a processor
    assert read(f"covariance = {{ places = {places}, matrix = [[{large}, 0], [0, {large}]] }}").places
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
        ('"plays.bridge.gap" = { mean = "50 um" }', "in one way"),
        ('"plays.bridge.gap" = { mean = "50 um", uniform = "10 %" }', "in one way"),
        ('"plays.bridge.gap" = { normal = 1e-6, mean = true }', "give a number in m"),
        ('"plays.bridge.gap" = { normal = inf }', "give a number in m"),
        ('"plays.bridge.gap" = { uniform = [1e-6, true] }', "give a number in m"),
        ('"plays.bridge.gap" = { uniform = [true, 1e-6] }', "give a number in m"),
        ('"plays.bridge.gap" = { uniform = [1e-6, 1e-6] }', "the first end is the smaller one"),
        ('"plays.bridge.gap" = { uniform = "10 um" }', "give both ends"),
        ('"plays.bridge.gap" = { uniform = "much %" }', "uncertainty"),
        ('"plays bridge" = { uniform = "10 %" }', "uncertainty"),
        ('"plays..gap" = { normal = 1.0 }', "is no place: write"),
        ('"plays.bridge.gap" = { normal = "5 %", abc = 1 }', "unknown key; write"),
        ("covariance = { places = [], matrix = [] }", "write { places ="),
        ('covariance = { places = ["plays.bridge.gab"], matrix = [[1]] }', "did you mean plays.bridge.gap"),
        ('covariance = { places = ["plays.bridge.gap"], matrix = [[true]] }', "products of SI units"),
        ('covariance = { places = ["plays.bridge.gap"], matrix = [[inf]] }', "products of SI units"),
        ('covariance = { places = ["plays.bridge.gap"], matrix = [[0]] }', "variances"),
        ('covariance = { places = ["plays.bridge.gap"], matrix = 1 }', "give 1 rows of 1 numbers"),
        ('covariance = { places = ["plays.bridge.gap"], matrix = [[-1]] }', "variances"),
        ('covariance = { places = ["plays.bridge.gap"], matrix = [[1, 2]] }', "give 1 rows of 1 numbers"),
        ("covariance = 3", "write { places ="),
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


@pytest.mark.parametrize(
    ("matrix", "told"),
    [
        ("[[1.0, 0.5], [0.5, 1.0]]", ""),
        ("[[1.0, 1.0], [1.0, 1.0]]", ""),
        ("[[4.0, -6.0], [-6.0, 9.0]]", ""),
        ("[[4.0, 6.00001], [6.00001, 9.0]]", "a correlation would exceed 1"),
        ("[[1e-12, -2e-6], [-2e-6, 1.0]]", "a correlation would exceed 1"),
        ("[[1.0, 0.5], [0.500001, 1.0]]", "is symmetric"),
        ("[[1.0, 0.0], [0.0, 0.0]]", "variances"),
        ("[[1.0, 0.0], [0.0, nan]]", "products of SI units"),
        ('[[1.0, "a"], [0.0, 1.0]]', "products of SI units"),
        ("[[1.0, 0.5], [0.5]]", "give 2 rows of 2 numbers"),
        ("[[1.0, 0.5], 3.0]", "give 2 rows of 2 numbers"),
    ],
)
def test_what_is_no_covariance_of_two_numbers_is_told(matrix: str, told: str) -> None:
    places = '["bodies.motor.mass", "plays.bridge.gap"]'
    lines = f"covariance = {{ places = {places}, matrix = {matrix} }}"
    if told:
        with pytest.raises(MechanismError, match=told):
            read(lines)
    else:
        assert len(read(lines).joints) == 1


def test_each_of_several_problems_is_told_once() -> None:
    lines = '"plays.bridge.gap" = 5\n"bodies.motor.mass" = { normal = 0 }\n"plays.bridge.gab" = 1'
    with pytest.raises(MechanismError) as told:
        read(lines)
    for words in ("say how it scatters", "a standard deviation is positive", "did you mean plays.bridge.gap"):
        assert str(told.value).count(words) == 1


def test_shares_of_a_negative_number_are_of_its_size() -> None:
    mechanism = MECHANISM.replace("amplitude = 1.5e-3", "amplitude = 1.5e-3, offset = -2e-3")
    (normal,) = read('"pins.pin.offset" = { normal = "10 %" }', mechanism).scatters
    assert vars(normal.distribution) == pytest.approx({"mean": -2e-3, "deviation": 2e-4})
    (uniform,) = read('"pins.pin.offset" = { uniform = "10 %" }', mechanism).scatters
    assert vars(uniform.distribution) == pytest.approx({"lowest": -2.2e-3, "highest": -1.8e-3})


def test_several_covariances_stand_in_a_list() -> None:
    uncertainty = read("""
        covariance = [
            { places = ["bodies.motor.mass", "plays.bridge.gap"], matrix = [[4e-6, 1e-9], [1e-9, 9e-12]] },
            { places = ["plays.bridge.damping"], matrix = [[0.01]] },
        ]
        "plays.bridge.stiffness" = { normal = "1 %" }
    """)
    first, second = uncertainty.joints
    assert first.places == ("bodies.motor.mass", "plays.bridge.gap")
    assert first.covariance == ((4e-6, 1e-9), (1e-9, 9e-12))
    assert (second.places, second.covariance) == (("plays.bridge.damping",), ((0.01,),))
    found = {each.place: each for each in uncertainty.scatters}
    assert vars(found["plays.bridge.gap"].distribution) == pytest.approx({"mean": 40e-6, "deviation": 3e-6})
    assert found["plays.bridge.damping"].unit == "N s/m"
    assert list(found)[-1] == "plays.bridge.stiffness"


def test_what_scatters_by_name_is_not_assumed_beside_it() -> None:
    mechanism = MECHANISM.replace("gap = 40e-6", 'gap = "20 um..60 um"')
    (only,) = read('"plays.bridge.gap" = { normal = "1 um" }', mechanism).scatters
    assert not only.assumed
    assert vars(only.distribution) == pytest.approx({"mean": 40e-6, "deviation": 1e-6})


def test_what_is_no_section_is_told() -> None:
    with pytest.raises(MechanismError, match="is a section"):
        sample_file_of_text(f"uncertainty = 3\n{MECHANISM}", "mine.toml")
