"""Where a period grows without bound, and where stick is torn out only just, beside laws in closed form."""

import re

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.optimize import brentq, root

from tests.trimmer.servos import STICTION
from trimmer import Mechanism, follow
from trimmer.branches import BranchEnd
from trimmer.branches.endless_period import endless_period
from trimmer.examples import example_text
from trimmer.mechanism import Body, Force, Friction, Link

CURVE = "curve = [[-3, 1.5], [-0.3, -0.3], [0, 0], [2, 2]]"


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


def test_a_block_that_slips_to_a_saddle_takes_ever_longer() -> None:
    """On the left the spring pushes outwards: m x" = 1/2 - F(x) - c x' has a saddle at -1.5 m.

    The last slip begins where friction gives way, at 1 - c v with the velocity v of the belt. It reaches the
    corner of the curve, 1.2 m before the saddle, with the velocity with which that is come to for ever.
    """
    damping = 0.005
    text = example_text("block-on-belt").replace("stiffness = 1.0", f"{CURVE}, damping = {damping}")
    branch = follow(Mechanism.from_toml_text(text), "pins.belt.velocity", 0.2, 3.0)
    half, slope = damping / 2, 2 / 3
    growing, dying = -half + np.sqrt(half**2 + slope), -half - np.sqrt(half**2 + slope)
    omega = np.sqrt(1 - half**2)

    def miss(unknown: np.ndarray) -> np.ndarray:
        speed, time = unknown
        oscillator = np.array([[0.0, 1.0], [-1.0, -damping]])
        place, velocity = expm(oscillator * time) @ (0.5 - damping * speed, speed)
        return np.array([place + 0.8, velocity - 1.2 * dying])

    speed = root(miss, [1.18, 3.5 / omega], tol=1e-14).x[0]
    assert branch.reason is BranchEnd.INFINITE_PERIOD and branch.endless is not None
    assert branch.endless.value == pytest.approx(speed, rel=1e-12)
    saddle = branch.endless.saddle
    assert saddle is not None and saddle.rate == pytest.approx(growing, rel=1e-12)
    assert saddle.positions == pytest.approx({"block": -1.5})
    assert "in which it cannot stay (a saddle: block -1.5)" in branch.message


def test_a_branch_ends_where_stick_is_torn_out_at_the_peak_of_the_force() -> None:
    """From -X, where the spring pulls too, a slip under a cos t, a = 2 - k X, ends at X for the mirror."""
    stiffness, own = 0.3, np.sqrt(0.3)

    def beyond(x: float) -> float:
        wave = (2.0 - stiffness * x) / (stiffness - 1.0)
        free = 1.0 / stiffness - x - wave
        stops = brentq(lambda t: wave * np.sin(t) + free * own * np.sin(own * t), 1.0, 3.0)
        return float(wave * np.cos(stops) - 1.0 / stiffness + free * np.cos(own * stops) - x)

    block = Mechanism(
        {"block": Body(1.0)},
        1.0 / (2.0 * np.pi),
        links={"spring": Link(("ground", "block"), stiffness)},
        frictions={"floor": Friction(("ground", "block"), 1.0, static=2.0)},
        forces={"push": Force("block", amplitude=2.4)},
    )
    branch = follow(block, "forces.push.amplitude", 2.4, 0.5)
    assert branch.reason is BranchEnd.TORN and branch.success
    assert branch.special[-1].parts == ("floor",)
    told, uncertain = map(float, re.findall(r"falls to zero at (\S+) \+- (\S+),", branch.message)[0])
    # Rounding says how near Newton's method comes to the end; nine digits are told.
    assert abs(told - 2.0 + stiffness * brentq(beyond, 0.0, 1.0)) <= uncertain + 5e-9 < 1e-5
