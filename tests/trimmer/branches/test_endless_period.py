"""Where a period grows without bound, beside laws in closed form."""

import numpy as np
import pytest

from tests.trimmer.servos import STICTION
from trimmer import Mechanism, follow
from trimmer.branches import BranchEnd
from trimmer.branches.endless_period import endless_period


def test_laws_whose_end_is_known() -> None:
    values = 0.05 + np.geomspace(3e-2, 6e-4, 100)
    inverse = endless_period(values, 0.0432 + 0.02007 / (values - 0.05))
    assert inverse is not None and not inverse.logarithmic
    assert inverse.value == pytest.approx(0.05, abs=1e-8)
    assert abs(inverse.value - 0.05) <= 2.0 * inverse.uncertainty + 1e-12
    periods = np.linspace(1.0, 6.0, 60)
    logarithm = endless_period(2.0 + 0.5 * np.exp(-3.0 * periods), periods)
    assert logarithm is not None and logarithm.logarithmic
    assert logarithm.value == pytest.approx(2.0, abs=1e-9)


@pytest.mark.parametrize(
    ("values", "periods"),
    [
        (np.linspace(3.0, 0.5, 60), 3.0 / np.linspace(3.0, 0.5, 60)),  # far from its end
        (np.geomspace(1.0, 0.02, 60), np.geomspace(1.0, 0.02, 60) ** -2.0),  # by another law
        (np.linspace(3.0, 1.0, 60), 1.0 + 0.2 * np.linspace(0.0, 2.0, 60) ** 4),  # no end
        (np.linspace(3.0, 1.0, 60), np.linspace(2.0, 1.0, 60)),  # falls
        (np.array([1.0, 2.0, 1.5, 1.2, 1.1]), np.geomspace(1.0, 9.0, 5)),  # turns back
        (np.array([1.0]), np.array([2.0])),
    ],
)
def test_periods_that_do_not_grow_without_bound(values: np.ndarray, periods: np.ndarray) -> None:
    assert endless_period(values, periods) is None


@pytest.mark.slow
def test_hunting_with_stiction_ends_where_static_friction_is_kinetic() -> None:
    """All of a slip is in proportion to the drop of friction, so is the rate of the integral in the wait."""
    branch = follow(Mechanism.from_toml_text(STICTION), "frictions.bearing.static", 0.08, 0.05)
    assert branch.reason is BranchEnd.INFINITE_PERIOD and branch.success
    assert branch.endless is not None and not branch.endless.logarithmic
    assert branch.endless.value == pytest.approx(0.05, abs=1e-8)
    assert abs(branch.endless.value - 0.05) <= 3.0 * branch.endless.uncertainty
    last = branch.points[-1]
    assert last.period * (last.value - 0.05) == pytest.approx(0.02, rel=0.01)
