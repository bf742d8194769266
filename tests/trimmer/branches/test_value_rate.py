"""The derivative of a motion by a number of its mechanism against differences of the exact motion."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import scipy.linalg

from trimmer.branches.period_maps.mechanism_map import MechanismMap
from trimmer.branches.period_maps.value_rate import ValueChange, _compiled_entry
from trimmer.contact.flow import ExactFlow
from trimmer.contact.statuses import FREE, MINUS, PLUS
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.taylor import DEGREE

PLACES = (
    *("frequency", "plays.bridge.gap", "plays.bridge.damping", "plays.bridge.stiffness"),
    *("frictions.blade.force", "bodies.cutter.mass", "pins.pin.amplitude", 'links."motor mount".damping'),
)


@pytest.fixture(scope="module")
def twin() -> Mechanism:
    file = Path(__file__).parents[3] / "examples" / "thesis-play.toml"
    return Mechanism.from_toml(file).with_value("frictions.blade.force", 1.0)


@pytest.fixture(scope="module")
def state(twin: Mechanism) -> np.ndarray:
    """A state a little beside the orbit, from which contact and stick come and go."""
    flow = ExactFlow(twin)
    settled = flow.strobe(flow.rest(), 200).states[-1]
    return settled * (1.0 + 1e-2 * np.random.default_rng(1).normal(size=len(settled)))


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize(("periods", "mirrored"), [(1, True), (2, False)])
def test_derivative(twin: Mechanism, state: np.ndarray, place: str, periods: int, mirrored: bool) -> None:
    value = twin.value(place)
    map = MechanismMap(twin, place, value, periods, mirrored)
    passage = map.passage(value, state)
    step = 1e-6 * value
    ends = []
    for sign in (1.0, -1.0):
        flow = map.flow(value + sign * step)
        ends.append(map.course(flow, flow.at(passage.begin.state, like=passage.begin)).end.state)
    numeric = (-1.0 if mirrored else 1.0) * (ends[0] - ends[1]) / (2.0 * step)
    scaled = (passage.rate() - numeric) * value / passage.sizes
    assert abs(scaled).max() < 5e-6


def test_one_sided_derivative_at_the_end_of_the_range(twin: Mechanism, state: np.ndarray) -> None:
    map = MechanismMap(twin, "plays.bridge.gap", 1e-4)
    assert np.isfinite(map.passage(0.0, state).rate()).all()


@pytest.mark.parametrize("duration", [0.0, 0.3, 0.5, 1.7])
def test_a_state_and_its_derivative_flow_as_the_exponential_of_both(duration: float) -> None:
    flow = np.array([[-0.4, 3.0, 0.0], [-2.0, 0.1, 0.5], [0.0, 0.7, -1.0]])
    change = np.array([[0.2, -1.0, 0.3], [0.0, 0.4, 2.0], [-0.6, 0.0, 0.1]])
    begin = np.array([1.0, -0.5, 0.25]), np.array([0.2, 0.1, -0.7])
    both = np.block([[flow, np.zeros((3, 3))], [change, flow]])
    wanted = scipy.linalg.expm(both * duration) @ np.concatenate(begin)
    state, tangent = (each.copy() for each in begin)
    # Steps of half a unit: a Taylor polynomial of degree 24 has an error of (4 * 0.5)^25 / 25!, 2e-18, there.
    _compiled_entry(flow, change, 0.5, duration, state, tangent, np.empty((4, 3)))
    assert np.concatenate([state, tangent]) == pytest.approx(wanted, rel=1e-13)


def test_a_long_step_is_a_polynomial_one_degree_above_that_of_the_flow() -> None:
    flow, change = np.array([[-0.5, 9.0], [-8.0, 0.25]]), np.array([[2.0, -1.0], [3.0, 4.0]])
    begin = np.array([1.0, -0.5, 0.25, 2.0])
    both = np.block([[flow, np.zeros((2, 2))], [change, flow]])
    term = wanted = begin
    for k in range(1, DEGREE + 2):
        term = both @ term / k
        wanted = wanted + term
    assert abs(term).max() > 1e-3
    state, tangent = begin[:2].copy(), begin[2:].copy()
    _compiled_entry(flow, change, 1.0, 1.0, state, tangent, np.empty((4, 2)))
    assert np.concatenate([state, tangent]) == pytest.approx(wanted, rel=1e-11)


HOLD = np.array([[1.0, 0.5, 0.0, 0.0], [0.0, 1.0, 0.25, 0.0], [2.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0]])
MORE = np.array([[0.0, 0.0, 1.0, 0.0], [0.5, 0.0, 0.0, 0.0], [0.0, 3.0, 0.0, 1.0], [1.0, 0.0, 0.0, 2.0]])
STEP = 1e-3


def relaxing(*statuses: int) -> Any:
    """A change of a mode in which contacts 1 and 3 may relax: states 3 and 2 are their stretches."""
    own = SimpleNamespace(statuses=statuses, hold=HOLD, flow=np.diag([0.1, -0.2, 0.3, -0.4]))
    other = SimpleNamespace(hold=HOLD + STEP * MORE, flow=own.flow + STEP * np.diag([5.0, 6.0, 7.0, 8.0]))
    machine = SimpleNamespace(
        relaxing_state=np.array([-1, 3, -1, 2]),
        stiffness=np.array([9.0, 6.0, 9.0, 10.0]),
        damping=np.array([9.0, 2.0, 9.0, 4.0]),
    )
    tables = SimpleNamespace(settled=np.array([0, 5]), step=np.full(6, 0.5))

    class Modes(dict[int, Any]):
        pass

    modes = Modes({5: own})
    modes.machine, modes.tables = machine, tables  # type: ignore[attr-defined]
    log = SimpleNamespace(state=np.array([[0.0] * 4, [1.0, -2.0, 3.0, 4.0]]), mode=np.array([0, 1]))
    course: Any = SimpleNamespace(modes=modes, log=log)
    slower = SimpleNamespace(
        stiffness=machine.stiffness * (1.0 + STEP * np.array([0.0, 0.5, 0.0, 0.25])), damping=machine.damping
    )
    found = ValueChange(course, slower, STEP, 0.0)  # type: ignore[arg-type]
    found._others[5] = other  # type: ignore[assignment]
    return found


def test_what_a_mode_holds_has_the_derivative_that_fits_and_a_relaxing_spring_its_own() -> None:
    state, tangent = np.array([1.0, -2.0, 3.0, 4.0]), np.array([0.1, 0.2, 0.3, 0.4])
    wanted = HOLD @ tangent + MORE @ state
    held = relaxing(FREE, PLUS, FREE, MINUS)._held(5, state, tangent)
    assert held == pytest.approx(wanted, rel=1e-9)
    held = relaxing(PLUS, FREE, PLUS, PLUS)._held(5, state, tangent)
    assert held == pytest.approx([*wanted[:3], 0.4], rel=1e-9)
    held = relaxing(FREE, FREE, FREE, FREE)._held(5, state, tangent)
    assert held == pytest.approx([*wanted[:2], 0.3, 0.4], rel=1e-9)


def test_a_spring_that_relaxes_flows_by_its_own_rate() -> None:
    begin, tangent, duration = np.array([1.0, -2.0, 3.0, 4.0]), np.array([0.1, 0.2, 0.3, 0.4]), 0.7
    rates, changes = np.array([0.1, -0.2, 0.3, -0.4]), np.array([5.0, 6.0, 7.0, 8.0])
    state, flown = relaxing(PLUS, FREE, PLUS, PLUS)._flown(1, duration, tangent)
    grown = np.exp(rates * duration)
    wanted, wanted_tangent = begin * grown, (tangent + changes * duration * begin) * grown
    # The rate of contact 1 is 6 / 2, and grows by half of that with the number.
    wanted[3] = 4.0 * np.exp(-3.0 * duration)
    wanted_tangent[3] = (0.4 - 1.5 * duration * 4.0) * np.exp(-3.0 * duration)
    assert state == pytest.approx(wanted, rel=1e-11)
    assert flown == pytest.approx(wanted_tangent, rel=1e-9)
    assert tangent.tolist() == [0.1, 0.2, 0.3, 0.4]
    both, _ = relaxing(PLUS, FREE, PLUS, FREE)._flown(1, duration, tangent)
    assert both[2:] == pytest.approx([3.0 * np.exp(-2.5 * duration), wanted[3]], rel=1e-11)


def logged(*functions: int) -> Any:
    """A change with events at one instant: rows 1, 2 ... of a log, each leads to the mode of its number."""
    rows = len(functions)
    flows = [np.array([[0.0, 1.0], [-4.0, 0.0]]) * (1.0 + number) for number in range(rows + 1)]
    gradients = [np.array([3.0, 5.0]), np.array([1.0, -1.0]), np.array([1.0, 0.0])]
    functional = tuple(SimpleNamespace(row=row) for row in gradients)
    modes = {
        number: SimpleNamespace(flow=flow, functions=functional, hold=np.eye(2), statuses=())
        for number, flow in enumerate(flows)
    }
    states = np.array([[9.0, 9.0], *([0.5 + 0.25 * row, 2.0] for row in range(rows))])
    log = SimpleNamespace(
        mode=np.arange(rows + 1), function=np.array([-1, *functions]), state=states, start=np.zeros(rows + 1)
    )

    class Modes(dict[int, Any]):
        pass

    kept = Modes(modes)
    kept.machine = SimpleNamespace(relaxing_state=np.array([], dtype=int))  # type: ignore[attr-defined]
    found = ValueChange(SimpleNamespace(modes=kept, log=log), None, STEP, 0.0)  # type: ignore[arg-type]
    moved = tuple(SimpleNamespace(row=row + STEP * np.array([0.1, 0.2])) for row in gradients)
    found._others.update(
        {number: SimpleNamespace(**{**vars(mode), "functions": moved}) for number, mode in modes.items()}  # type: ignore[misc]
    )
    return found


def test_an_event_is_later_by_what_the_derivative_misses() -> None:
    tangent = np.array([0.7, -0.2])
    change = logged(1)
    # State (0.5, 2), rates (2, -2) before and (4, -4) behind; the gradient (1, -1) rises by 4 a second.
    later = -(0.7 + 0.2 + 0.1 * 0.5 + 0.2 * 2.0) / 4.0
    assert change._jumped(1, 1, tangent) == pytest.approx(tangent + later * np.array([-2.0, 2.0]), rel=1e-9)
    # A row without an event changes nothing.
    assert logged(-1)._jumped(1, 1, tangent) is tangent
    # Of several at one instant the first tells when, and the last what comes after: here (12, -12) * 1.5.
    two = logged(-1, 1)
    behind = np.array([3.0 * 2.0, -12.0 * 0.75])
    expected = tangent + later * (np.array([2.0, -2.0]) - behind)
    assert two._jumped(1, 2, tangent) == pytest.approx(expected, rel=1e-9)
    # Where the function does not change, there is no time at which it is zero.
    still = logged(2)
    still.course.log.state[1] = [0.5, 0.0]
    assert still._jumped(1, 1, tangent) == pytest.approx(tangent, rel=1e-12)
