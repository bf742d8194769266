"""The derivative of a motion by its start, against differences of the motion itself."""

import numpy as np
import pytest

from tests.mechanisms.cases import trimmer
from trimmer.contact.flow import ExactFlow
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Friction, Link, Pin, Stop


def differences(flow, instant, steps):
    """Return the derivative of the state after a period by central differences."""
    columns = []
    for place, step in enumerate(steps):
        ends = []
        for sign in (1, -1):
            state = instant.state.copy()
            state[place] += sign * step
            ends.append(flow.course(flow.at(state), 1).end.state)
        columns.append((ends[0] - ends[1]) / (2 * step))
    return np.array(columns).T


@pytest.mark.parametrize("law", [ContactLaw.TRUNCATED, ContactLaw.PULLING])
def test_play_and_sliding_friction(law):
    flow = ExactFlow(trimmer(law))
    instant = flow.strobe(flow.rest(), 20).end
    found = flow.course(instant, 1).monodromy
    steps = [1e-9] * 4 + [1e-6] * 4
    expected = differences(flow, instant, steps)
    scales = np.array([1e-3] * 4 + [1.0] * 4)
    scaled = (found - expected) * scales / scales[:, None]
    assert abs(scaled).max() < 1e-5 * abs(expected * scales / scales[:, None]).max()


def test_a_relaxing_spring_that_contact_sets_again_is_forgotten():
    flow = ExactFlow(trimmer())
    instant = flow.strobe(flow.rest(), 300).end
    multipliers = np.linalg.eigvals(flow.course(instant, 1).monodromy)
    truncated = ExactFlow(trimmer(ContactLaw.TRUNCATED))
    instant = truncated.strobe(truncated.rest(), 300).end
    others = np.linalg.eigvals(truncated.course(instant, 1).monodromy)
    assert min(abs(multipliers)) < 1e-12
    # The laws give nearly the same motion, as the digits of the definition do too.
    found = np.sort(abs(multipliers))[1:]
    np.testing.assert_allclose(found, np.sort(abs(others)), rtol=1e-6)


def test_stick_takes_a_dimension_away():
    mechanism = Mechanism(
        bodies={"body": Body(1.0)},
        frequency=0.4 / (2 * np.pi),
        pins={"base": Pin("ground", 1.0)},
        links={"spring": Link(("base", "body"), 1.0)},
        frictions={"floor": Friction(("ground", "body"), 0.7)},
    )
    flow = ExactFlow(mechanism)
    instant = flow.strobe(flow.rest(), 200).end
    course = flow.course(instant, 1)
    assert {kind for _, _, kind in course.events} == {4, 5}
    multipliers = np.linalg.eigvals(course.monodromy)
    assert min(abs(multipliers)) < 1e-12
    assert max(abs(multipliers)) < 1.0


def test_a_relaxing_spring_that_touches_nothing_dies_out_as_it_should():
    mechanism = Mechanism(
        bodies={"body": Body(1.0)},
        frequency=1.0,
        links={"spring": Link(("ground", "body"), 1.0, 0.1)},
        stops={"wall": Stop(("ground", "body"), 1.0, 2.0, 100.0)},
        pins={"base": Pin("ground", 1.0)},
    )
    flow = ExactFlow(mechanism)
    multipliers = np.linalg.eigvals(flow.course(flow.rest(), 1).monodromy)
    expected = [*np.exp(np.roots([1.0, 0.1, 1.0])), np.exp(-0.5)]
    np.testing.assert_allclose(np.sort_complex(multipliers), np.sort_complex(expected), rtol=1e-12)
