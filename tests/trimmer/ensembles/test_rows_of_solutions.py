"""What the search of many trimmers takes and hands on: rows, samples, and who is searched again."""

import pytest

from trimmer.ensembles import sampled_limit_cycles
from trimmer.thesis import ParameterError, TrimmerParameters


def test_numbers_and_rows_mix_and_keep_their_places() -> None:
    thesis = TrimmerParameters.thesis()
    varied = sampled_limit_cycles({"m2": [thesis.m2, 1.1 * thesis.m2], "k1": thesis.k1}, gap=[4e-5, 8e-5])
    plain = sampled_limit_cycles({}, gap=4e-5)
    assert varied.omega[0] == pytest.approx(plain.omega[0], rel=1e-9)
    assert varied.omega[1] != pytest.approx(plain.omega[0], rel=1e-4)
    with pytest.raises(ValueError, match="rows of one length"):
        sampled_limit_cycles({"m2": [[thesis.m2]]}, gap=4e-5)


def test_a_parameter_that_there_is_not_is_told_with_those_that_there_are() -> None:
    with pytest.raises(ParameterError, match=r"no parameter 'm22'; did you mean m2\?"):
        sampled_limit_cycles({"m22": 1.0}, gap=4e-5)
    with pytest.raises(ParameterError, match="no parameter 'weight'; there are m1, m2"):
        sampled_limit_cycles({"weight": 1.0}, gap=4e-5)
