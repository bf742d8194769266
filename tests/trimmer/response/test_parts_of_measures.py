"""Single measures of motions whose log and rows are made by hand, and what tables show."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.contact.statuses import CONTACT_BROKEN, CONTACT_MADE, NOTHING, STICK
from trimmer.response import measures as module
from trimmer.response.measures import ContactMeasures, FrictionMeasures, Measures
from trimmer.response.orbit import MechanismOrbit

KINDS = [NOTHING, CONTACT_MADE, CONTACT_BROKEN, CONTACT_MADE, NOTHING, CONTACT_MADE]


def motion() -> SimpleNamespace:
    """Six segments of a motion with two contacts and two frictions, two states and the one."""
    log = SimpleNamespace(
        start=np.array([0.0, 1.0, 2.5, 3.0, 5.0, 6.0]),
        part=np.array([0, 1, 1, 0, 0, 1]),
        kind=np.array(KINDS),
        mode=np.array([0, 1, 0, 1, 2, 1]),
        state=np.array([[1.0, -2.0, 1], [2.0, -3, 1], [5.0, 6, 1], [7.0, 8, 1], [9.0, 1, 1], [-4, 5, 1]]),
    )
    machine = SimpleNamespace(
        stiffness=np.array([10.0, 20.0]),
        contact_rate=np.array([[1.0, 0.0, 0.5], [0.0, 2.0, 0.0]]),
        friction_rate=np.array([[1.0, 1.0, 0.0], [0.0, -1.0, 0.0]]),
        kinetic=np.array([3.0, 5.0]),
    )
    statuses = np.array([[7, 7, STICK, 0], [7, 7, 0, STICK], [7, 7, 0, 0]])
    layout = SimpleNamespace(contacts=("slot", "end"), frictions=("floor", "face"))
    tables = SimpleNamespace(statuses=statuses)
    nodes = SimpleNamespace(
        rows=np.array([0, 1, 3, 4]),
        weights=np.array([1.0, 2.0, 3.0, 4.0]),
        states=np.array([[1.0, 2.0, 1.0], [-3.0, 1.0, 1.0], [2.0, -7.0, 1.0], [0.5, 0.25, 1.0]]),
    )
    modes = SimpleNamespace(machine=machine, tables=tables, layout=layout)
    return SimpleNamespace(log=log, modes=modes, nodes=nodes, duration=8.0)


@pytest.mark.parametrize(
    ("ends", "largest"), [((-7.0, 3.0), 7.0), ((-1.0, 3.0), 3.0), ((-5.0, -2.0), 5.0), ((1.0, 2.0), 2.0)]
)
def test_the_largest_force_may_push_or_pull(monkeypatch: pytest.MonkeyPatch, ends, largest: float) -> None:
    monkeypatch.setattr(module, "extremes", lambda course, signal: ends)
    touching = np.array([False, True, False, True, True, False])
    monkeypatch.setattr(module, "while_status", lambda course, part, statuses: touching)
    found = Measures(motion(), None, 1, 4).contacts
    # Speeds are those of the states in which contacts of this part are made.
    assert found == {
        "slot": ContactMeasures(1 / 4, (7.5,), largest, (1.5 + 2.0 + 1.0) / 8),
        "end": ContactMeasures(2 / 4, (6.0, 10.0), largest, (1.5 + 2.0 + 1.0) / 8),
    }


def test_a_friction_loses_where_it_slides() -> None:
    found = Measures(motion(), None, 2, 4).frictions
    # The floor sticks in mode 0, the face in mode 1; speeds at the nodes are 3, 2, 5, 3/4 and 2, 1, 7, 1/4.
    lost = 3.0 * (2 * 2 + 3 * 5 + 4 * 0.75), 5.0 * (1 * 2 + 4 * 0.25)
    assert found == {
        "floor": FrictionMeasures(lost[0] / 4, lost[0] / 8, (1.0 + 0.5) / 8),
        "face": FrictionMeasures(lost[1] / 4, lost[1] / 8, (1.5 + 2.0 + 2.0) / 8),
    }


def test_events_are_counted_by_drive_periods() -> None:
    assert Measures(motion(), None, 2, 4).events_per_period == 4 / 4
    assert Measures(motion(), None, 2, 2).events_per_period == 4 / 2


def test_the_table_of_an_orbit_has_a_row_for_each_harmonic() -> None:
    outputs = {
        "x": SimpleNamespace(harmonics=np.array([3.0, 2.0, 1.0])),
        "y": SimpleNamespace(harmonics=np.array([0.3, 0.2, 0.1])),
    }
    course = SimpleNamespace(duration=1.5)

    def table(periods: int, measured: dict):
        orbit = MechanismOrbit(None, periods, 1, course, np.ones(1), np.zeros(1), 0.0, True, "")
        object.__setattr__(orbit, "measures", SimpleNamespace(outputs=measured))
        return orbit._table()

    driven = table(3, outputs)
    assert driven.units == {"order": "", "frequency": "Hz", "outputs.x": "m", "outputs.y": "m"}
    expected = [[1, 2.0, 3.0, 0.3], [2, 4.0, 2.0, 0.2], [3, 6.0, 1.0, 0.1]]
    np.testing.assert_allclose([list(map(float, row)) for row in driven.rows()], expected)
    assert [row[1] for row in table(0, outputs).rows()] == pytest.approx([1 / 1.5, 2 / 1.5, 2.0])
    assert list(table(1, {}).rows()) == []


def test_measures_of_an_orbit_span_its_periods() -> None:
    for periods, count, expected in ((6, 3, (3, 6)), (1, 1, (1, 1)), (0, 1, (1, 1)), (0, 0, (1, 1))):
        orbit = MechanismOrbit("flow", periods, count, "course", np.ones(1), np.zeros(1), 0.0, True, "")
        found = orbit.measures
        assert (found.course, found.flow) == ("course", "flow")
        assert (found.period_count, found.periods) == expected
