"""What the first pages say rests on claims and numbers: screen, answers, what is right, roots, derivation."""

import re
from collections import Counter

import pytest

from report.data.statements import read_inventory
from report.judging.verdict import Severity, Verdict
from report.numbers.evidence import Evidence
from report.overview.answers import answers
from report.overview.balance import balance
from report.overview.corrected_results import corrected_results
from report.overview.opening import opening
from report.overview.roots import ROOTS
from report.overview.short import short
from report.rendering.summary import partly
from trimmer import Mechanism, MotionKind, respond


@pytest.fixture(scope="module")
def screen(evidence):
    return opening(evidence)


def words(screen) -> str:
    said = [*(f"{each.sentence} {each.action}" for each in screen.highlights)]
    said += [line.text for line in screen.advice]
    said += [screen.figure.title, screen.figure.caption]
    return re.sub(r"[*`$\\]", "", " ".join([screen.sentences, *said]))


def test_the_first_screen_is_short(screen) -> None:
    assert len(words(screen)) <= 1500  # 2000 with titles, counts, references and the figure's words


def test_what_matters_most_is_wrong_and_is_judged(screen, findings) -> None:
    for highlight in screen.highlights:
        if not highlight.places[0].startswith("twin"):
            assert all(findings[place].verdict.is_wrong for place in highlight.places)


def test_the_force_that_ends_the_limit_cycle(screen) -> None:
    # Harmonic balance of the thesis's loop has 1.62 N (tests/report/numbers/test_friction_in_place.py).
    assert "1.6 N" in words(screen)


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


def test_each_side_rests_on_cards_of_its_kind(evidence, findings) -> None:
    matters = balance(evidence)
    kept = {claim: findings[claim].verdict for matter in matters for claim in matter.kept}
    slips = {claim: findings[claim].verdict for matter in matters for claim in matter.slips}
    assert set(kept.values()) == {Verdict.REPRODUCED}, kept
    assert all(verdict.is_wrong for verdict in slips.values()), slips


def test_the_roll_off_has_the_numbers_of_its_card(evidence, findings) -> None:
    (matter,) = (each for each in balance(evidence) if "txt-5.1.2-roll-off" in each.slips)
    slope = findings["txt-5.1.2-roll-off"].parts[0]
    printed, derived = (str(side).lstrip("-").split()[0] for side in (slope.printed, slope.derived))
    assert f"falls by {derived} dB per decade, not by {printed}." in matter.wrong


def test_below_the_force_that_is_told_the_real_trimmer_does_not_repeat(evidence, project_folder) -> None:
    machine = Mechanism.from_toml(project_folder / "examples" / "thesis-play.toml")
    (told,) = re.findall(r"with 0.2 mm it takes (\S+) N", str(balance(evidence)))
    for force, kind in ((float(told), MotionKind.PERIODIC), (float(told) - 0.1, MotionKind.CHAOTIC)):
        changed = machine.with_value("plays.bridge.gap", 2e-4).with_value("frictions.blade.force", force)
        assert respond(changed).kind is kind


def test_each_card_that_changes_a_conclusion_has_one_root(findings):
    stands = Counter(claim for root in ROOTS for claim in root.claims)
    grave = {name for name, finding in findings.items() if finding.severity is Severity.CONCLUSION}
    assert set(stands) == grave
    assert set(stands.values()) == {1}


def test_three_trees_and_last_those_that_stand_alone():
    *trees, alone = ROOTS
    assert [tree.size > 1 and tree.words != "" for tree in trees] == [True] * 3
    assert alone.words == ""


def test_partly_is_what_has_parts_that_are_right(findings):
    assert partly(findings["lst-A.7"])
    assert not partly(findings["eq-D.3"])
    assert not partly(findings["eq-2.1"])
    assert sum(map(partly, findings.values())) > 70


def test_it_names_both_limit_cycles_and_the_exact_orbit(evidence) -> None:
    said = str(short(evidence))
    assert all(number in said for number in ("8.3152", "733.63", "8.2895", "733.57"))
