import dataclasses
import tomllib

import numpy as np
import pytest
from hypothesis import given

from derivations.symbols import PARAMETERS
from tests.trimmer.trimmers import DAMPINGS, MASSES, STIFFNESSES, trimmers
from trimmer import TrimmerParameters
from trimmer.thesis import ParameterError, parameter_table

THESIS = TrimmerParameters.thesis()


def test_thesis_values_are_those_of_listing_a1() -> None:
    assert THESIS.values() == (
        *(0.035, 0.003, 0.005, 0.030),
        *(200e3, 30e3, 150e3, 100e3, 1e3),
        *(3.5, 0.4, 1.0, 4.0),
    )


def test_meanings_and_units_are_those_of_the_derivation() -> None:
    derived = [(str(q.symbol).replace("_", ""), q.meaning, q.unit.text) for q in PARAMETERS]
    assert [(p.symbol, p.meaning, p.unit) for p in parameter_table()] == derived


def test_integers_and_numpy_numbers_become_floats() -> None:
    parameters = dataclasses.replace(THESIS, k1=200_000, c1=np.float32(3.5), m1=np.int64(1))
    assert [type(value) for value in parameters.values()] == [float] * 13
    assert (parameters.k1, parameters.c1, parameters.m1) == (200e3, 3.5, 1.0)


@pytest.mark.parametrize("symbol", MASSES)
@pytest.mark.parametrize("value", [0, 0.0, -0.001])
def test_masses_must_be_positive(symbol: str, value: float) -> None:
    with pytest.raises(ParameterError, match=rf"^{symbol} = {value!r}: a mass must be greater than zero$"):
        dataclasses.replace(THESIS, **{symbol: value})


@pytest.mark.parametrize("symbol", STIFFNESSES + DAMPINGS)
def test_stiffness_and_damping_may_be_zero_but_not_negative(symbol: str) -> None:
    assert getattr(dataclasses.replace(THESIS, **{symbol: 0.0}), symbol) == 0.0
    with pytest.raises(
        ParameterError, match=rf"^{symbol} = -1e-09: (stiffness|damping) must not be negative$"
    ):
        dataclasses.replace(THESIS, **{symbol: -1e-9})


def test_parameters_cannot_be_changed() -> None:
    with pytest.raises(dataclasses.FrozenInstanceError):
        THESIS.m1 = 1.0  # type: ignore[misc]


@given(trimmers())
def test_toml_text_reads_back_equal(parameters: TrimmerParameters) -> None:
    assert TrimmerParameters(**tomllib.loads(parameters.to_toml())) == parameters
