"""Orbits that the first harmonic alone does not lead to: brief contacts, and several loads that slow down."""

import control
import numpy as np
import pytest

from tests.quick import quick
from trimmer import InertiaBacklash, PeriodicOrbit, ViscousBacklash, periodic_orbits, simulate
from trimmer.elements import Element, FrictionBacklash
from trimmer.loops import ClosedLoop, EventKind

THIRD_ORDER = control.ss(control.tf([0.91, 1.8], [1, 1.14, 0.136]))
SECOND_ORDER = control.ss(control.tf([1, 2.2], [1, 0.516, 1]))
FOURTH_ORDER = control.ss(control.tf([1.2, 5.7, 0.74, 0.022], [1, 1.95, 1.18, 0.101, 0.00235]))
SERVO = control.ss(control.tf([3], [1, 1, 0]))


def final_amplitude(system: control.StateSpace, element: Element, period: float) -> float:
    """Half of peak to peak that a long motion from an impulse ends in."""
    motion = simulate(ClosedLoop(system, element), 100 * period, impulse=3.0)
    input_ = motion.element_input(np.linspace(98.5, 100.0, 20_001).clip(max=100.0 - 1e-9) * period)
    return float(np.ptp(input_)) / 2


def assert_returns(orbit: PeriodicOrbit) -> None:
    """Check the return after a whole period, where the search looks at half of one only."""
    start, end = orbit.motion.state([0.0, orbit.period]).T
    assert abs(end - start).max() <= 1e-9 * abs(start).max()
    assert min(abs(orbit.multipliers - 1.0)) < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize(
    ("system", "element"),
    quick(
        [
            (SECOND_ORDER, InertiaBacklash(1.0)),
            (THIRD_ORDER, InertiaBacklash(1.0)),
            (FOURTH_ORDER, ViscousBacklash(1.0, 6.3)),
        ],
        1,
    ),
)
def test_a_stable_orbit_with_brief_contacts_is_where_a_long_motion_ends(system, element) -> None:
    (orbit,) = periodic_orbits(system, element)
    assert orbit.stable
    assert orbit.amplitude == pytest.approx(final_amplitude(system, element, orbit.period), rel=1e-5)
    assert_returns(orbit)


def test_an_unstable_orbit_with_brief_contacts_is_found_too() -> None:
    outer, inner = periodic_orbits(control.tf([20], [1, 0.6, 1]), FrictionBacklash(1.0))
    assert (outer.stable, inner.stable) == (True, False)
    assert 0.5 < inner.amplitude < 0.515
    assert_returns(inner)


def test_loads_that_slow_down_return_after_a_whole_period() -> None:
    # Half a period later one load still flies, and what is left of its velocity has not changed its sign.
    element = ViscousBacklash(1.0, 0.3) + 0.8 * ViscousBacklash(2.0, 3.0)
    (orbit,) = (each for each in periodic_orbits(SERVO, element) if each.stable)
    assert_returns(orbit)
    assert orbit.amplitude == pytest.approx(final_amplitude(SERVO, element, orbit.period), rel=1e-5)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_the_multipliers_of_contacts_of_no_length_are_those_of_differences() -> None:
    """A load that only touches leaves with the pin's state, which tells all of the next touch but one.

    So the map from touch to touch a period later has the multipliers but that of the flow, and zeros.
    """
    system = control.ss([[-4.7, 0.0], [1.0, 0.0]], [[1.0], [0.0]], [[20.0, 8.5]], 0)
    (orbit,) = periodic_orbits(system, InertiaBacklash(1.0))
    motion, order = orbit.motion, 2
    touch, leaving = motion.events[0], motion.events[1]
    assert (touch.kind, leaving.kind, leaving.time) == (EventKind.IMPACT, EventKind.SEPARATION, touch.time)
    begin = motion.state(touch.time)[:order]
    side = np.sign(motion.element_input(touch.time) - motion.element_output(touch.time))

    def returned(state: np.ndarray) -> np.ndarray:
        again = simulate(motion.loop, 1.2 * orbit.period, initial_state=state, element_output=-1e9 * side)
        ends = [each.time for each in again.events if each.kind is EventKind.IMPACT]
        last = min(ends, key=lambda time: abs(time - orbit.period))
        return np.asarray(again.state(last)[:order])

    assert returned(begin) == pytest.approx(begin, rel=1e-9)
    shifts = 1e-6 * np.diag(abs(begin))
    columns = [(returned(begin + each) - returned(begin - each)) / (2 * each.sum()) for each in shifts]
    differences = np.sort(abs(np.linalg.eigvals(np.array(columns).T)))
    sizes = np.sort(abs(orbit.multipliers))
    assert sizes[-1] == pytest.approx(1.0, abs=1e-9)
    assert sizes[1:-1] == pytest.approx(differences, rel=1e-5)
    assert sizes[0] < 1e-12
