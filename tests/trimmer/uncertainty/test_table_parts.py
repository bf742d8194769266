"""What is read of a table whose numbers have two places, and each problem that is told of it, once."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.uncertainty.distributions import Normal, Scatter, Uncertainty, Uniform
from trimmer.uncertainty.table import _reason_against, uncertainty_of

GAP, MASS = "plays.bridge.gap", "bodies.motor.mass"
NUMBERS = SimpleNamespace(places={GAP: "m", MASS: "kg"}, value={GAP: -4e-5, MASS: 0.5}.__getitem__)
KNOWN = (Scatter(GAP, "m", Uniform(1e-5, 2e-5), True), Scatter("other", "m", Uniform(1.0, 2.0), True))


def read(content: object, known: tuple[Scatter, ...] = ()) -> tuple[Uncertainty, list]:
    problems: list = []
    found = uncertainty_of(content, NUMBERS, problems, known)
    return found, [(each.place, each.reason, each.value) for each in problems]


ALONE = {
    "no section": (3, ("uncertainty",), "is a section: write [uncertainty] on a line of its own"),
    "no place": ({"plays bridge": {"normal": 1.0}}, ("uncertainty", "plays bridge"), "plays bridge"),
    "another place": (
        {"plays.bridge.gab": {"normal": 1.0}},
        ("uncertainty", "plays.bridge.gab"),
        f"mean {GAP}",
    ),
    "an empty name": ({"plays..gap": {"normal": 1.0}}, ("uncertainty", "plays..gap"), "is no place: write"),
    "no table": ({GAP: 5}, ("uncertainty", GAP), "say how it scatters, as in {"),
    "another key": ({GAP: {"normal": 1.0, "abc": 1.0}}, ("uncertainty", GAP, "abc"), "unknown key; write {"),
    "two ways": ({GAP: {"normal": 1.0, "uniform": "10 %"}}, ("uncertainty", GAP), "in one way, as in {"),
    "a mean alone": ({GAP: {"mean": 1.0}}, ("uncertainty", GAP), "in one way, as in {"),
    "a bad mean": (
        {GAP: {"normal": "5 %", "mean": True}},
        ("uncertainty", GAP, "mean"),
        "give a number in m",
    ),
    "a bad deviation": ({GAP: {"normal": "5 kg"}}, ("uncertainty", GAP, "normal"), "kg"),
    "no deviation": (
        {GAP: {"normal": 0.0}},
        ("uncertainty", GAP, "normal"),
        "a standard deviation is positive",
    ),
    "a bad end": ({GAP: {"uniform": [1.0, True]}}, ("uncertainty", GAP, "uniform"), "give a number in m"),
    "another bad end": (
        {GAP: {"uniform": [None, 1.0]}},
        ("uncertainty", GAP, "uniform"),
        "give a number in m",
    ),
    "equal ends": (
        {GAP: {"uniform": [1.0, 1.0]}},
        ("uncertainty", GAP, "uniform"),
        "the first end is the sm",
    ),
    "one end": ({GAP: {"uniform": [1.0]}}, ("uncertainty", GAP, "uniform"), "give both ends, as in ["),
    "a bad share": ({GAP: {"uniform": "much %"}}, ("uncertainty", GAP, "uniform"), "is no number"),
    "no covariance": ({"covariance": {"places": []}}, ("uncertainty", "covariance"), "write { places = ["),
    "a covariance of no place": (
        {"covariance": {"places": ["plays.bridge.gab"], "matrix": [[1.0]]}},
        ("uncertainty", "covariance"),
        f"there is no number 'plays.bridge.gab'; did you mean {GAP}",
    ),
    "a bad covariance": (
        {"covariance": {"places": [GAP], "matrix": [[-1.0]]}},
        ("uncertainty", "covariance", "matrix"),
        "variances, on the diagonal, are positive",
    ),
}


@pytest.mark.parametrize("name", ALONE)
def test_a_problem_is_told_once_and_nothing_is_read(name: str) -> None:
    content, place, reason = ALONE[name]
    found, problems = read(content)
    assert found == Uncertainty(())
    ((at, told, _),) = problems
    assert at == place
    assert reason in told
    # What else stands there is read, and so is what nobody knows.
    if isinstance(content, dict):
        more, again = read({**content, MASS: {"normal": "10 %"}}, KNOWN)
        assert again == problems
        assert more == Uncertainty((Scatter(MASS, "kg", Normal(0.5, 0.05)), *KNOWN))


def test_a_number_that_scatters_twice_is_told_and_scatters_once() -> None:
    content = {
        MASS: {"uniform": "20 %"},
        "covariance": {"places": [GAP, MASS], "matrix": [[4e-12, 1e-7], [1e-7, 0.01]]},
    }
    found, problems = read(content, KNOWN)
    assert problems[0][:2] == (("uncertainty", "covariance"), f"{MASS} scatters twice; say it once")
    assert len(problems) == 1
    assert found.places == (MASS, GAP, "other")
    assert [each.unit for each in found.scatters] == ["kg", "m", "m"]
    mass, gap = found.scatters[:2]
    assert (mass.distribution, mass.assumed) == (Normal(0.5, pytest.approx(0.1)), False)
    assert (gap.distribution, gap.assumed) == (Normal(-4e-5, pytest.approx(2e-6)), False)
    (joint,) = found.joints
    assert (joint.places, joint.covariance) == ((GAP, MASS), ((4e-12, 1e-7), (1e-7, 0.01)))


def test_shares_are_of_the_size_of_the_number_or_of_the_mean() -> None:
    forms = {
        "10 %": Normal(-4e-5, pytest.approx(4e-6)),
        " 10 % ": Normal(-4e-5, pytest.approx(4e-6)),
        "3 um": Normal(-4e-5, pytest.approx(3e-6)),
        2e-6: Normal(-4e-5, 2e-6),
    }
    for text, expected in forms.items():
        assert read({GAP: {"normal": text}})[0].scatters[0].distribution == expected
    (scatter,) = read({GAP: {"normal": "10 %", "mean": "-60 um"}})[0].scatters
    assert scatter.distribution == Normal(pytest.approx(-6e-5), pytest.approx(6e-6))
    (scatter,) = read({GAP: {"uniform": " 25 %"}})[0].scatters
    assert scatter.distribution == Uniform(pytest.approx(-5e-5), pytest.approx(-3e-5))


@pytest.mark.parametrize(
    ("matrix", "reason"),
    [
        ([[1.0, 0.5], [0.5, 1.0]], ""),
        ([[1.0, 1.0], [1.0, 1.0]], ""),
        ([[4.0, -6.0], [-6.0, 9.0]], ""),
        ([[4.0, 6.00001], [6.00001, 9.0]], "a correlation would exceed 1"),
        ([[1e-12, -2e-6], [-2e-6, 1.0]], "a correlation would exceed 1"),
        ([[1.0, 0.5], [0.5 + 1e-6, 1.0]], "is symmetric"),
        ([[1.0, 0.0], [0.0, 0.0]], "variances"),
        ([[0.0, 0.0], [0.0, 1.0]], "variances"),
        ([[1.0, 0.0], [0.0, np.nan]], "products of SI units"),
        ([[1.0, "a"], [0.0, 1.0]], "products of SI units"),
        ([[1.0, 0.5], [0.5]], "give 2 rows of 2 numbers"),
        ([[1.0, 0.5], 3.0], "give 2 rows of 2 numbers"),
        ([[1.0, 0.5]], "give 2 rows of 2 numbers"),
        ("ab", "give 2 rows of 2 numbers"),
    ],
)
def test_what_is_no_covariance_of_two_numbers_is_told(matrix: object, reason: str) -> None:
    found = _reason_against(matrix, ("a", "b"))
    assert found == "" if not reason else reason in found
