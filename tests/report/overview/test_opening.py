"""The first screen: short, its numbers right, and each finding on a claim that is there."""

import re

import pytest

from report.overview.opening import opening

MOST_CHARACTERS = 2000


@pytest.fixture(scope="module")
def findings(findings):
    return tuple(findings.values())


@pytest.fixture(scope="module")
def screen(evidence):
    return opening(evidence)


def words(screen) -> str:
    said = [*(f"{each.sentence} {each.action}" for each in screen.highlights)]
    said += [line.text for line in screen.advice]
    return re.sub(r"[*`$\\]", "", " ".join([screen.sentences, *said]))


def test_the_first_screen_is_short(screen) -> None:
    assert len(words(screen)) < MOST_CHARACTERS - 430  # headings, the counts, references and grades too


def test_what_matters_most_is_wrong_and_is_judged(screen, findings) -> None:
    by_id = {finding.id: finding for finding in findings}
    for highlight in screen.highlights:
        if not highlight.places[0].startswith("twin"):
            assert all(by_id[place].verdict.is_wrong for place in highlight.places)


def test_the_force_that_ends_the_limit_cycle(screen) -> None:
    # Harmonic balance of the thesis's loop has 1.62 N (tests/report/numbers/test_friction_in_place.py).
    assert "1.6 N" in words(screen)
