"""The chain from a claim to its step and from a step to its lines of code; symbols, waveforms and numbers."""

import inspect
from dataclasses import replace

import numpy as np
import pytest
import sympy

from derivations.elements.backlash import GAP, friction_waveform
from derivations.elements.friction import LEVEL, relay_waveform
from derivations.elements.harmonics import odd_harmonic
from derivations.elements.narrative import element_narrative
from derivations.narrative import narrative
from derivations.step import Formula, NarrativeStep
from derivations.symbols import A
from report.cache.source_closure import ROOT
from report.data.statements import read_inventory
from report.derivation.code_lines import code_lines
from report.derivation.nomenclature import (
    NomenclatureError,
    entries,
    formulas,
    nomenclature,
    symbols,
    symbols_of_step,
)
from report.derivation.number_steps import number_steps
from report.derivation.pictures import sampled, waveform_pictures
from report.derivation.places_of_claims import UnknownStepError, named_steps, places
from report.derivation.waveform_svg import first_harmonic
from report.judging.claim import Kind
from report.judging.finding import Finding
from report.judging.verdict import Impact, Verdict
from report.numbers.newton_by_hand import newton_by_hand

CONSTANTS = frozenset({r"\pi"})


@pytest.fixture(scope="module")
def steps(evidence):
    return narrative(evidence.derivation) + element_narrative() + number_steps(evidence)


def finding(claim: str, source: str = "none.py", explanation: str = "") -> Finding:
    return Finding(
        claim, Kind.STATEMENT, "1", "", Verdict.REPRODUCED, explanation, "", Impact.NONE, source, ()
    )


def test_every_claim_has_a_step(steps):
    inventory = read_inventory()
    found = places([finding(claim, entry.source) for claim, entry in inventory.items()], steps)
    lost = [f"{claim} ({entry.source})" for claim, entry in inventory.items() if claim not in found]
    assert not lost, f"add the claims or their sources to report/data/steps.csv: {lost}"
    assert found["eq-2.46"] == "df-load"
    assert found["txt-5.2.1-prediction"] == "solution"


def test_a_claim_is_placed_by_its_own_line_then_its_equation_then_its_source():
    steps = (NarrativeStep("one", "One", "", (Formula("a = b", "2.9"),)), NarrativeStep("two", "Two", "", ()))
    claims = [finding("eq-2.9", "x.py"), finding("txt-1", "x.py"), finding("txt-2", "y.py")]
    assert places(claims, steps, {"x.py": "two"}) == {"eq-2.9": "one", "txt-1": "two"}
    assert places(claims, steps, {"eq-2.9": "two"}) == {"eq-2.9": "two"}
    with pytest.raises(UnknownStepError, match=r"y\.py"):
        places(claims, steps, {"y.py": "three"})


def test_what_is_placed_exists():
    inventory = read_inventory()
    for of in named_steps():
        assert of in inventory or (ROOT / of).is_file(), f"report/data/steps.csv names {of}"


def test_steps_have_identifiers_and_titles_of_their_own(steps):
    assert len({step.id for step in steps}) == len({step.title for step in steps}) == len(steps)


def test_every_step_but_what_is_only_read_leads_to_its_lines_of_code(steps):
    assert [step.id for step in steps if not step.code] == ["reading"]
    for function in {each for step in steps for each in step.code}:
        lines = code_lines(function)
        file = (ROOT / lines.path).read_text(encoding="utf-8").splitlines()
        assert "\n".join(file[lines.first - 1 : lines.last]).rstrip() == lines.text
        assert lines.name in lines.text
        assert lines.last - lines.first < 130


def test_code_of_another_project_is_refused():
    with pytest.raises(ValueError, match="no code of this project"):
        code_lines(inspect.unwrap)


def test_every_symbol_of_the_derivation_is_in_the_nomenclature(steps):
    explained = CONSTANTS.union(*(entry.covers for entry in entries()))
    missing = {step.id: sorted(symbols_of_step(step) - explained) for step in steps}
    assert not {step: names for step, names in missing.items() if names}


def test_each_meaning_of_a_symbol_stands_once():
    found = [(entry.symbol, entry.meaning) for entry in entries()]
    assert len(found) == len(set(found))
    letters = [entry.symbol for entry in entries()]
    assert letters.count("A") == 2
    assert {"b", r"\beta", "G", "N_n", "M", "D", "x", "y"} <= set(letters)


def test_a_symbol_is_placed_where_it_stands_first(steps):
    cards = (finding("txt-1", explanation="No formula."), finding("eq-5.7", explanation=r"With $\beta$."))
    rows = nomenclature(steps, cards)
    places = {(row.symbol, row.meaning[:5]): row.first for row in rows}
    assert places["A", "ampli"] == "df-method"
    assert places["A", "state"] == "state-space"
    assert places[r"\omega", "angul"] == "df-method"
    assert places[r"\beta", "gap o"] == "eq-5.7"
    assert not [row for row in rows if row.symbol == r"\phi"], "no card holds it"
    held = {step.id: symbols_of_step(step) for step in steps}
    order = list(held)
    explicit = {entry.meaning for entry in entries() if entry.first}
    for entry, row in ((entry, row) for entry in entries() for row in rows if entry.meaning == row.meaning):
        if row.first in held:
            assert held[row.first] & entry.covers
            earlier = order[: order.index(row.first)]
            assert row.meaning in explicit or not any(held[step] & entry.covers for step in earlier)


def test_a_symbol_that_does_not_stand_where_it_is_said_to_is_an_error(steps):
    without = [replace(step, text="", formulas=()) if step.id == "spectrum" else step for step in steps]
    with pytest.raises(NomenclatureError, match="spectrum"):
        nomenclature(without, ())


@pytest.mark.parametrize(
    ("latex", "found"),
    [
        (r"\dot{q}_{1} = \ddot q_2", {"q_1", "q_2"}),
        (r"\frac{\partial L}{\partial \dot{q}_2} + \dots", {"L", "q_2"}),
        (r"\omega_c t \text{ for } \sin\theta", {r"\omega_c", "t", r"\theta"}),
        (r"\begin{cases} A & \ell \end{cases}", {"A", r"\ell"}),
        (r"\operatorname{Re} N_{eq}", {"N_eq"}),
        (r"\left|C_{1}\right|", {"C_1"}),
    ],
)
def test_symbols_are_letters_with_their_index(latex, found):
    assert symbols(latex) == found


def test_formulas_in_prose_are_those_between_dollars():
    assert list(formulas("With $a$ and $b_1 = 2$.")) == ["a", "b_1 = 2"]


@pytest.mark.parametrize(
    ("waveform", "values"),
    [
        (relay_waveform(LEVEL), {LEVEL: sympy.Rational(7, 10)}),
        (friction_waveform(), {A: sympy.Integer(1), GAP: sympy.Rational(6, 5)}),
    ],
)
def test_waveforms_have_the_first_harmonic_of_the_derivation(waveform, values):
    gain = complex(odd_harmonic(waveform, sympy.Integer(1), 1).subs(values).evalf())
    phases = np.array([0.3, 1.1])
    drawn = first_harmonic(sampled(waveform, values), phases)
    assert drawn == pytest.approx((gain * np.exp(1j * phases)).imag, abs=3e-3)


def test_pictures_are_small_and_have_words():
    pictures = waveform_pictures()
    assert set(pictures) <= {step.id for step in element_narrative()}
    for picture in pictures.values():
        assert len(picture.svg) < 10_000
        assert picture.alternative_text in picture.svg.replace("&#x27;", "'")


def test_the_solution_by_hand_is_that_of_the_search(evidence):
    rows = (evidence.numbers.numerator, evidence.numbers.denominator)
    *_, last = newton_by_hand(*([float(each) for each in row] for row in rows))
    cycle = evidence.cycles.friction.stable
    assert last.omega == pytest.approx(cycle.omega, rel=1e-12)
    assert last.amplitude == pytest.approx(cycle.amplitude, rel=1e-10)
    assert f"{last.frequency:.2f}" == "733.63"


def test_a_method_that_does_not_settle_says_so():
    with pytest.raises(ArithmeticError, match="residual"):
        newton_by_hand([1.0], [1.0, 0.0])
