"""What the search of many trimmers cannot be sure of goes through the search of one, and is said."""

import numpy as np

from trimmer.ensembles.crossings import Crossings, crossings
from trimmer.ensembles.grid import frequencies_near
from trimmer.ensembles.other_poles import unstable_others
from trimmer.ensembles.polishing import polished
from trimmer.ensembles.responses import Responses, responses_of
from trimmer.thesis import Displacement, InputChannels, TrimmerParameters

THESIS = np.array([TrimmerParameters.thesis().values()])


def response(output: str = "q2-q4") -> tuple[Responses, np.ndarray]:
    made = responses_of(THESIS, Displacement.parse(output), InputChannels.DISPLACEMENT_AND_VELOCITY)
    return made, np.roots(made.denominator[0])[None]


def test_a_solution_outside_of_its_enclosure_is_not_found() -> None:
    made, poles = response()
    enclosed = crossings(made, frequencies_near(poles))
    here = made[enclosed.rows]
    assert polished(here, enclosed).found.all()
    beside = Crossings(
        enclosed.rows, 1.01 * enclosed.lower, 1.01 * enclosed.upper, enclosed.u, enclosed.doubtful
    )
    assert not polished(here, beside).found.any()


def test_a_mean_that_may_run_away_is_unknown() -> None:
    made, poles = response()
    enclosed = crossings(made, frequencies_near(poles))
    here = made[enclosed.rows]
    solutions, near = polished(here, enclosed), poles[enclosed.rows]
    assert not unstable_others(here, near, solutions)[1].any()
    # With twice the gain and the other sign the loop of the mean has positive feedback at rest.
    turned = Responses(-2.0 * here.numerator, here.denominator, here.reference)
    assert unstable_others(turned, near, solutions)[1].all()
