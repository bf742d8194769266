"""A drive is given by its omega or by its frequency, and by one only."""

import math
import pickle
from dataclasses import replace

import pytest

from trimmer import Drive, WrongTypeError


def test_frequency_and_omega_give_the_same_drive() -> None:
    by_omega, by_frequency = Drive(1e-3, 2 * math.pi * 110, 0.5), Drive(1e-3, frequency=110, phase=0.5)
    assert by_omega == by_frequency == Drive(1e-3, omega=2 * math.pi * 110, phase=0.5)
    assert hash(by_omega) == hash(by_frequency)
    assert by_frequency.frequency == pytest.approx(110.0, rel=1e-15)
    assert repr(by_frequency) == repr(by_omega)
    assert pickle.loads(pickle.dumps(by_frequency)) == by_frequency
    assert replace(by_frequency, amplitude=2e-3) == Drive(2e-3, by_omega.omega, 0.5)
    assert Drive(1, 2) == Drive(1.0, 2.0)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, "a drive needs omega .* or frequency .*, and one only: neither is given"),
        ({"omega": 691.0, "frequency": 110.0}, "one only: omega=691.0 and frequency=110.0 is given"),
        ({"frequency": 0.0}, r"frequency of the drive must be positive \(Hz\), not 0.0"),
        ({"frequency": -1.0}, r"frequency of the drive must be positive \(Hz\), not -1.0"),
        ({"frequency": math.nan}, "frequency of the drive must be finite, not nan"),
        ({"frequency": 1e308}, "omega of the drive must be finite, not inf"),
        ({"omega": -1.0}, r"omega of the drive must be positive \(rad/s\), not -1.0"),
        ({"omega": 0.0}, r"omega of the drive must be positive \(rad/s\), not 0.0"),
        ({"omega": math.inf}, "omega of the drive must be finite, not inf"),
        ({"omega": 1.0, "amplitude": -1.0}, "amplitude of the drive must not be negative, not -1.0"),
        ({"omega": 1.0, "amplitude": math.nan}, "amplitude of the drive must be finite, not nan"),
        ({"omega": 1.0, "phase": math.nan}, "phase of the drive must be finite, not nan"),
    ],
)
def test_a_drive_that_has_no_frequency_is_an_error(options: dict[str, float], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Drive(**{"amplitude": 1e-3, **options})


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"frequency": "110"}, r"frequency of the drive must be a real number \(Hz\), not '110'"),
        ({"omega": 1j}, r"omega of the drive must be a real number \(rad/s\), not 1j"),
        ({"omega": 1.0, "phase": None}, r"phase of the drive must be a real number \(rad\), not None"),
        ({"omega": 1.0, "amplitude": [1.0]}, r"amplitude of the drive must be a real number .* not \[1\.0\]"),
    ],
)
def test_what_is_no_number_is_named(options: dict[str, object], message: str) -> None:
    with pytest.raises(WrongTypeError, match=message):
        Drive(**{"amplitude": 1e-3, **options})  # type: ignore[arg-type]
