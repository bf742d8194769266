"""The 0-1 test where order and chaos are known."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.response.zero_one import growth_of_walk


def test_two_frequencies_are_order() -> None:
    steps = np.arange(2000)
    assert growth_of_walk(np.sin(steps * np.sqrt(2)) + 0.5 * np.cos(steps * np.sqrt(3))) < 0.1


def test_the_logistic_map_at_4_is_chaos() -> None:
    values = [0.3]
    for _ in range(1999):
        values.append(4 * values[-1] * (1 - values[-1]))
    assert growth_of_walk(np.array(values)) == pytest.approx(1.0, abs=0.05)


def test_rest_is_order() -> None:
    assert growth_of_walk(np.full(500, 0.1)) < 0.1
