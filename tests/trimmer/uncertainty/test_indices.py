"""Sobol indices against functions whose indices are known."""

import sys

import numpy as np
import pytest

from trimmer.errors import UncertaintyError
from trimmer.uncertainty import JointScatter, Normal, Scatter, Uncertainty
from trimmer.uncertainty.indices import indices_of, require_independent, saltelli_points

pytest.importorskip("SALib")


def test_those_of_the_ishigami_function() -> None:
    # Ishigami and Homma (1990), a = 7, b = 0.1: S = 0.3139, 0.4424, 0; S_T = 0.5576, 0.4424, 0.2437.
    x = np.pi * (2.0 * saltelli_points(3, 4096, 1) - 1.0)
    values = np.sin(x[:, 0]) + 7.0 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])
    found = {each.place: each for each in indices_of(values, ("a", "b", "c"), 0).indices}
    assert [found[name].first for name in "abc"] == pytest.approx([0.3139, 0.4424, 0.0], abs=0.02)
    assert [found[name].total for name in "abc"] == pytest.approx([0.5576, 0.4424, 0.2437], abs=0.02)


def test_a_sum_has_the_shares_of_its_variances() -> None:
    x = saltelli_points(2, 1024, 2)
    found = indices_of(3.0 * x[:, 0] + x[:, 1], ("a", "b"), 0)
    assert [each.place for each in found.indices] == ["a", "b"]
    assert [each.first for each in found.indices] == pytest.approx([0.9, 0.1], abs=0.01)
    assert found.message == "From 1024 blocks of samples."


def test_what_does_not_exist_everywhere_is_only_a_hint() -> None:
    values = saltelli_points(2, 64, 2).sum(axis=1)
    values[5] = np.nan
    found = indices_of(values, ("a", "b"), 0)
    assert (found.used, found.blocks) == (63, 64)
    assert "only a hint" in found.message
    assert "exists in no whole block" in indices_of(np.full(values.size, np.nan), ("a", "b"), 0).message


def test_what_is_the_same_everywhere_has_none() -> None:
    found = indices_of(np.ones(4 * 16), ("a", "b"), 0)
    assert found.indices == ()
    assert "nothing has an influence" in found.message


@pytest.mark.parametrize(("size", "spread", "count"), [(-1.0, 1e-13, 0), (1e-3, 5e-15, 2), (1e-3, 5e-16, 0)])
def test_what_hardly_differs_has_none(size: float, spread: float, count: int) -> None:
    x = saltelli_points(2, 2, 5)
    found = indices_of(size + spread * x.sum(axis=1), ("a", "b"), 0)
    assert (len(found.indices), found.used, found.blocks) == (count, 2, 2)


@pytest.mark.parametrize("blocks", [3, 6, 12])
def test_blocks_are_a_power_of_two(blocks: int) -> None:
    with pytest.raises(UncertaintyError, match=f"{blocks} blocks of samples"):
        saltelli_points(2, blocks, 5)
    assert saltelli_points(2, 1, 5).shape == (4, 2)


def test_without_salib_it_is_told_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "SALib.sample.sobol", None)
    with pytest.raises(UncertaintyError, match=r"pip install 'trimmer\[sensitivity\]'"):
        saltelli_points(2, 8, 0)


def test_dependent_numbers_are_refused() -> None:
    scatters = (Scatter("a", "m", Normal(0.0, 1.0)), Scatter("b", "m", Normal(5.0, 2.0)))
    with pytest.raises(UncertaintyError, match="has a covariance"):
        require_independent(Uncertainty(scatters, (JointScatter(("a", "b"), ((1.0, 0.1), (0.1, 4.0))),)))
