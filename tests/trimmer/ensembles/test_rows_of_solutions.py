"""What the search of many trimmers takes and hands on: rows, samples, and who is searched again."""

from __future__ import annotations

import math
import warnings

import numpy as np
import pytest

from trimmer.displacement import Displacement
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.ensembles.limit_cycles import (
    SampledLimitCycles,
    _Columns,
    _found,
    _in_rows,
    _searched_again,
    sampled_limit_cycles,
)
from trimmer.ensembles.polishing import Solutions, polished
from trimmer.ensembles.responses import Responses
from trimmer.errors import UndecidedWarning
from trimmer.linear.model import InputChannels
from trimmer.parameters import ParameterError, TrimmerParameters


def test_rows_are_filled_in_order_of_frequency() -> None:
    one = _Columns(np.array([2, 0]), np.array([3.0, 1.0]), np.array([9.0, 8.0]), np.array([True, False]))
    two = _Columns(np.array([2, 2]), np.array([5.0, 4.0]), np.array([7.0, 9.0]), np.array([False, False]))
    again, undecided = np.array([False, True, False]), np.array([False, True, True])
    found = _in_rows([one, two], again, undecided)
    assert found.count.tolist() == [1, 0, 3]
    assert np.nan_to_num(found.omega).tolist() == [[8.0, 0.0, 0.0], [0.0, 0.0, 0.0], [7.0, 9.0, 9.0]]
    assert np.nan_to_num(found.amplitude).tolist() == [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [5.0, 3.0, 4.0]]
    assert found.stable.tolist() == [[False] * 3, [False] * 3, [False, True, False]]
    assert found.exists.tolist() == [False, False, True]
    assert found.frequency[0, 0] == pytest.approx(4.0 / math.pi)
    assert found.searched_again is again
    assert found.undecided is undecided
    assert "3 trimmers" in found.message
    assert "For 2 nothing is certain" in found.message
    assert "4 limit cycles of 3 trimmers" in repr(found)
    table = found._table()
    assert [list(row) for row in table.rows()] == [
        [0, 1.0, 8.0, pytest.approx(4.0 / math.pi), False],
        [2, 5.0, 7.0, pytest.approx(3.5 / math.pi), False],
        [2, 3.0, 9.0, pytest.approx(4.5 / math.pi), True],
        [2, 4.0, 9.0, pytest.approx(4.5 / math.pi), False],
    ]
    certain = SampledLimitCycles(*[*vars(found).values()][:5], undecided=np.zeros(3, bool))
    assert "certain" not in certain.message.replace("certificate", "")


def test_numbers_and_rows_mix_and_keep_their_places() -> None:
    thesis = TrimmerParameters.thesis()
    varied = sampled_limit_cycles({"m2": [thesis.m2, 1.1 * thesis.m2], "k1": thesis.k1}, gap=[4e-5, 8e-5])
    plain = sampled_limit_cycles({}, gap=4e-5)
    assert varied.omega[0] == pytest.approx(plain.omega[0], rel=1e-9)
    assert varied.omega[1] != pytest.approx(plain.omega[0], rel=1e-4)
    with pytest.raises(ValueError, match="rows of one length"):
        sampled_limit_cycles({"m2": [[thesis.m2]]}, gap=4e-5)


def test_a_search_again_hands_on_what_it_doubts(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[type[Warning]] = []

    def found(system: object, element: FrictionBacklash) -> tuple[str, ...]:
        for category in told:
            warnings.warn("by hand", category, stacklevel=1)
        return ("found", element.gap)

    monkeypatch.setattr("trimmer.ensembles.limit_cycles.limit_cycles", found)
    values = np.array(TrimmerParameters.thesis().values())
    given = values, 4e-5, Displacement.parse("q2-q4"), InputChannels.DISPLACEMENT_ONLY
    assert _searched_again(*given) == (("found", 4e-5), False)
    for category, doubt in ((UserWarning, False), (UndecidedWarning, True)):
        told.append(category)
        assert _searched_again(*given)[1] == doubt


def test_nothing_found_is_a_table_without_columns() -> None:
    nothing = _in_rows([], np.zeros(3, bool), np.zeros(3, bool))
    assert (nothing.amplitude.shape, nothing.stable.shape, nothing.count.tolist()) == (
        (3, 0),
        (3, 0),
        [0] * 3,
    )
    assert not nothing.exists.any()


def test_a_parameter_that_there_is_not_is_told_with_those_that_there_are() -> None:
    with pytest.raises(ParameterError, match=r"no parameter 'm22'; did you mean m2\?"):
        sampled_limit_cycles({"m22": 1.0}, gap=4e-5)
    with pytest.raises(ParameterError, match="no parameter 'weight'; there are m1, m2"):
        sampled_limit_cycles({"weight": 1.0}, gap=4e-5)


def test_a_trimmer_is_searched_again_where_the_curves_nearly_touch(monkeypatch: pytest.MonkeyPatch) -> None:
    # K/((s + 0.3)(s + 1)) for two K.
    loops = Responses(
        np.array([[0.0, 9.0], [0.0, 20.0]]), np.array([[1.0, 1.3, 0.3]] * 2), np.array([1.0, 3.0])
    )
    gaps, near = np.array([2.0, 3.0]), np.array([-0.31, -1.05], complex)
    angles = {"sine": np.sin(np.radians(90.0)), "found": True}

    def pretended(responses: Responses, enclosures: object) -> Solutions:
        solutions = polished(responses, enclosures)
        first = enclosures.rows == 0
        return solutions._replace(
            sine=np.where(first, angles["sine"], 1.0), found=np.where(first, angles["found"], True)
        )

    plain = _found(loops, gaps, near)
    assert plain.again.tolist() == [False, False]
    assert set(plain.rows.tolist()) == {0, 1}
    for row, amplitude, omega in zip(plain.rows, plain.amplitude, plain.omega, strict=True):
        s = 1j * omega / loops.reference[row]
        gain = complex(FrictionBacklash(gaps[row]).describing_function(amplitude))
        assert gain == pytest.approx(-(s + 0.3) * (s + 1.0) / (9.0, 20.0)[row], rel=1e-9)
    monkeypatch.setattr("trimmer.ensembles.limit_cycles.polished", pretended)
    for degrees, again in ((2.1, False), (1.9, True), (-1.9, True), (-2.1, False)):
        angles["sine"] = np.sin(np.radians(degrees))
        found = _found(loops, gaps, near)
        assert found.again.tolist() == [again, False]
        assert not found.stable[found.rows == 0].any() or degrees > 0
    angles.update(sine=1.0, found=False)
    assert _found(loops, gaps, near).again.tolist() == [True, False]
