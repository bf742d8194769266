"""What the search of many trimmers cannot be sure of goes through the search of one, and is said."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer import TrimmerParameters
from trimmer.displacement import Displacement
from trimmer.ensembles.crossings import Crossings, _open_ends, _urgency, crossings
from trimmer.ensembles.frequencies import frequencies_near
from trimmer.ensembles.grid import Grid, grid_at
from trimmer.ensembles.limit_cycles import sampled_limit_cycles
from trimmer.ensembles.other_poles import unstable_others
from trimmer.ensembles.polishing import polished
from trimmer.ensembles.responses import Responses, responses_of
from trimmer.linear.model import InputChannels

THESIS = np.array([TrimmerParameters.thesis().values()])


def response(output: str = "q2-q4") -> tuple[Responses, np.ndarray]:
    made = responses_of(THESIS, Displacement.parse(output), InputChannels.DISPLACEMENT_AND_VELOCITY)
    return made, np.roots(made.denominator[0])[None]


def grid(h: list[float], lag: list[float]) -> Grid:
    points = len(h)
    return Grid(
        np.linspace(1.0, 2.0, points)[None], np.full((1, points), True), np.array([lag]), np.array([h])
    )


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_both_steps_beside_a_near_touch_are_looked_at(sign: float) -> None:
    near = _urgency(grid([0.9 * sign, 0.2 * sign, 0.01 * sign, 0.2 * sign, 0.9 * sign], [0.4] * 5))
    assert (near[0] > 0).tolist() == [False, True, True, False]
    far = _urgency(grid([0.9 * sign, 0.8 * sign, 0.7 * sign, 0.8 * sign, 0.9 * sign], [0.4] * 5))
    assert not far.any()


def test_a_step_in_which_the_phase_turns_far_is_looked_at() -> None:
    assert (_urgency(grid([0.9, 0.9, 0.9], [0.2, 0.3, 1.2]))[0] > 0).tolist() == [False, True]
    # Half a turn and back is no turn.
    assert not _urgency(grid([0.9, 0.9, 0.9], [3.1, 3.1, -3.1])).any()


def test_a_response_that_stays_large_to_the_end_is_doubtful() -> None:
    # G(0) is -0.96, and nearly -1: there the largest amplitudes would have the lowest frequencies.
    open_ended = []
    for k5 in (1e3, 1.0):
        values = THESIS.copy()
        values[0, 8] = k5
        made = responses_of(values, Displacement.parse("q4-q2"), InputChannels.DISPLACEMENT_AND_VELOCITY)
        omegas = frequencies_near(np.roots(made.denominator[0])[None])
        open_ended.append(bool(_open_ends(grid_at(made, omegas))[0]))
    assert open_ended == [False, True]
    assert crossings(made, omegas).doubtful.all()


def test_a_crossing_near_the_end_of_the_lags_is_doubtful(monkeypatch: pytest.MonkeyPatch) -> None:
    made, poles = response()
    omegas = frequencies_near(poles)
    assert not crossings(made, omegas).doubtful.any()
    monkeypatch.setattr("trimmer.ensembles.crossings.MARGIN", 2.0)
    assert crossings(made, omegas).doubtful.all()


def test_a_solution_outside_of_its_enclosure_is_not_found() -> None:
    made, poles = response()
    enclosed = crossings(made, frequencies_near(poles))
    here = made.part(enclosed.rows)
    assert polished(here, enclosed).found.all()
    beside = Crossings(
        enclosed.rows, 1.01 * enclosed.lower, 1.01 * enclosed.upper, enclosed.u, enclosed.doubtful
    )
    assert not polished(here, beside).found.any()


def test_what_is_not_found_is_searched_again(monkeypatch: pytest.MonkeyPatch) -> None:
    expected = sampled_limit_cycles({}, gap=4e-5)

    def none_found(responses, enclosures):
        solutions = polished(responses, enclosures)
        return solutions._replace(found=np.zeros_like(solutions.found))

    monkeypatch.setattr("trimmer.ensembles.limit_cycles.polished", none_found)
    again = sampled_limit_cycles({}, gap=4e-5)
    assert again.searched_again.all()
    np.testing.assert_allclose(again.omega, expected.omega, rtol=1e-9)


def test_a_mean_that_may_run_away_is_unknown() -> None:
    made, poles = response()
    enclosed = crossings(made, frequencies_near(poles))
    here = made.part(enclosed.rows)
    solutions, near = polished(here, enclosed), poles[enclosed.rows]
    assert not unstable_others(here, near, solutions)[1].any()
    # With twice the gain and the other sign the loop of the mean has positive feedback at rest.
    turned = Responses(-2.0 * here.numerator, here.denominator, here.reference)
    assert unstable_others(turned, near, solutions)[1].all()
