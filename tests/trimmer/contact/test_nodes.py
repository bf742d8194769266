"""A motion at given times and at the nodes of quadrature, in plain Python, against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.contact.hand_made import COUNT, STEP, log_of, tables_of
from tests.trimmer.uncompiled import uncompile
from trimmer.contact import nodes as nodes_module
from trimmer.contact.nodes import NODES
from trimmer.contact.statuses import ARRIVED
from trimmer.contact.tables import Tables
from trimmer.contact.work import Log

OMEGA = 6.0


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    uncompile(monkeypatch, nodes_module)


def turning() -> tuple[Tables, Log]:
    """Return x' = omega y, y' = -omega x until 0.6 s, and the same with a step of half the length after."""
    tables, log = tables_of([()], (2,), (ARRIVED,)), log_of(2)
    tables.step[1] = STEP / 2
    for mode, step in enumerate(tables.step):
        matrix = np.zeros((3, 3))
        matrix[0, 1], matrix[1, 0] = OMEGA * step, -OMEGA * step
        terms = [np.linalg.matrix_power(matrix, k) / math.factorial(k) for k in range(COUNT)]
        tables.screen[mode, :, :3] = sum(terms).T
        for k, term in enumerate(terms):
            tables.series[mode, :, 3 * k : 3 * k + 3] = term.T
    log.start[:], log.mode[:] = (0.0, 0.6), (0, 1)
    log.state[:] = (0.0, 1.0, 1.0), (3.0, 0.0, 1.0)
    return tables, log


def exact(times: np.ndarray) -> np.ndarray:
    x = np.where(times < 0.6, np.sin(OMEGA * times), 3 * np.cos(OMEGA * (times - 0.6)))
    y = np.where(times < 0.6, np.cos(OMEGA * times), -3 * np.sin(OMEGA * (times - 0.6)))
    return np.stack([x, y, np.ones_like(times)], axis=1)


def test_at_any_times() -> None:
    tables, log = turning()
    times = np.array([0.0, 0.0, 0.1, STEP, STEP, 0.3, 0.55, 0.6, 0.61, 0.725, 1.9])
    np.testing.assert_allclose(nodes_module.sample(tables, log, times), exact(times), rtol=1e-12, atol=1e-13)
    assert nodes_module.sample(tables, log, times[:0]).shape == (0, 3)
    late = times[-1:]
    np.testing.assert_allclose(nodes_module.sample(tables, log, late), exact(late), rtol=1e-12)


@pytest.mark.parametrize("rate", [16.0, 0.5])
def test_a_relaxing_spring_follows_from_the_start_of_its_row(rate: float) -> None:
    tables, log = turning()
    tables.settled[1], tables.relaxing_state[1], tables.relaxation[1, 1] = 0, 0, rate
    log.state[1] = 0.05, 0.0, 1.0
    times = np.array([0.3, 0.6, 0.7, 1.3])
    states = nodes_module.sample(tables, log, times)
    np.testing.assert_allclose(states[1:, 0], 0.05 * np.exp(-rate * (times[1:] - 0.6)), rtol=1e-12)
    assert states[0, 0] == pytest.approx(math.sin(1.8), rel=1e-12)


def test_each_row_lasts_until_the_next_one() -> None:
    tables, _ = turning()
    log = log_of(3)
    log.start[:] = 0.0, 0.1, 0.3
    log.state[:, 0], log.state[:, 1] = (1.0, 2.0, 3.0), 0.0
    times = np.array([0.05, 0.1, 0.25, 0.3, 0.4])
    expected = np.array([1.0, 2.0, 2.0, 3.0, 3.0]) * np.cos(OMEGA * (times - [0.0, 0.1, 0.1, 0.3, 0.3]))
    np.testing.assert_allclose(nodes_module.sample(tables, log, times)[:, 0], expected, rtol=1e-12)


def test_sums_over_the_nodes_are_integrals() -> None:
    tables, log = turning()
    end = 1.08
    found = nodes_module.nodes(tables, log, end)
    assert len(found.times) == (3 + 4) * NODES
    assert found.rows.tolist() == [0] * 3 * NODES + [1] * 4 * NODES
    assert (np.diff(found.times) > 0).all()
    np.testing.assert_allclose(found.states, exact(found.times), rtol=1e-11, atol=1e-12)
    assert found.weights.sum() == pytest.approx(end, rel=1e-14)
    assert found.weights @ found.times == pytest.approx(end**2 / 2, rel=1e-14)
    x, first = found.states[:, 0], found.rows == 0
    squares = [
        0.6 / 2 - math.sin(2 * OMEGA * 0.6) / (4 * OMEGA),
        9 * (0.24 + math.sin(2 * OMEGA * 0.48) / (4 * OMEGA)),
    ]
    assert found.weights[first] @ x[first] ** 2 == pytest.approx(squares[0], rel=1e-13)
    assert found.weights[~first] @ x[~first] ** 2 == pytest.approx(squares[1], rel=1e-13)


def test_a_row_of_no_length_has_no_nodes() -> None:
    tables, log = turning()
    log.start[1] = 0.0
    found = nodes_module.nodes(tables, log, STEP / 2)
    assert found.rows.tolist() == [1] * NODES
    assert found.weights.sum() == pytest.approx(STEP / 2, rel=1e-14)
