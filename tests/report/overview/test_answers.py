"""Answers and corrected results rest on claims that exist, and on numbers that were solved."""

import re

from report.data.statements import read_inventory
from report.numbers.evidence import Evidence
from report.overview.answers import answers
from report.overview.corrected_results import corrected_results


def test_all_seven_questions_are_answered_from_claims(evidence: Evidence) -> None:
    given = answers(evidence)
    assert len(given) == 7
    known = read_inventory()
    for answer in given:
        assert answer.question.endswith("?")
        assert answer.claims
        assert [claim for claim in answer.claims if claim not in known] == []


def test_every_corrected_result_names_its_claim_and_a_corrected_value(evidence: Evidence) -> None:
    known = read_inventory()
    rows = corrected_results(evidence)
    assert len(rows) > 10
    for row in rows:
        assert row.claim in known
        assert row.harmonic_balance


def test_exact_and_predicted_values_differ_as_the_error_says(evidence: Evidence) -> None:
    rows = corrected_results(evidence)
    amplitude = next(row for row in rows if row.quantity == r"amplitude, stable, $b$ = $4\times10^{-6}$ m")
    # Harmonic balance is off by 0.31 % (tests/trimmer/orbits/test_periodic_orbits.py).
    ratio = float(amplitude.harmonic_balance) / float(amplitude.exact_orbit)
    assert abs(ratio - 1.0031) < 1e-4
    error = next(row for row in rows if row.claim == "txt-5.2.1-amplitude-error")
    assert error.harmonic_balance == "0.31"


def test_numbers_in_answers_are_those_of_the_limit_cycles(evidence: Evidence) -> None:
    first = answers(evidence)[0].now
    assert f"{evidence.cycles.friction.stable.amplitude:.2f} times" in first
    merger = evidence.cycles.equivalent.in_place.merger.force_per_gap
    assert re.search(rf"\b{merger:.0f} N/m", answers(evidence)[3].now)
