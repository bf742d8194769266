"""How few orbits it takes to find where a contact is born: halving would take 39; stand-ins count them."""

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.branches.narrowing import narrowed
from trimmer.motion.part import Phase

KEY = ("stop", Phase.STICK)
NARROWEST = 2e-12
SHAPES = [(np.sqrt, 6.0), (lambda x: np.sqrt(x * (1.0 + x)), 20.0), (lambda x: x + 0.3 * x**2, 12.5)]


@pytest.mark.parametrize(("shape", "most"), SHAPES)
@pytest.mark.parametrize("is_right", [False, True])
def test_a_border_is_found_in_a_few_orbits(shape, most: float, is_right: bool) -> None:
    random, counts = np.random.default_rng(1), []
    for border in random.uniform(0.02, 0.98, 20):

        def place(at: float, border: float = border):
            inside = (at - border) * (1.0 if is_right else -1.0)
            lasts = float(shape(max(inside, 0.0)))
            return SimpleNamespace(
                at=at,
                signature=((KEY, int(inside > 0.0)),),
                passage=SimpleNamespace(shortest=lambda *_: lasts),
            )

        tried = list[float]()
        arc = SimpleNamespace(
            narrowest=NARROWEST,
            distance=lambda each: each.at,
            between=lambda at, *_: tried.append(at) or place(at),  # noqa: B023
        )
        found = narrowed(arc, place(0.0), place(1.0))
        assert found is not None
        assert found[0].at <= border <= found[1].at <= found[0].at + NARROWEST
        counts.append(len(tried))
    assert np.mean(counts) < most
