"""A thing that the thesis prints in several places is one item, whichever claims judge it."""

import pytest

from report.judging.items import items
from report.judging.verdict import Severity, Verdict

SHARED = {
    "733.33 Hz, limit cycle predicted for friction-controlled backlash": {
        *("txt-5.2.1-prediction", "tab-5.1", "tab-5.2", "fig-5.17", "fig-5.22", "eq-5.10"),
    },
    "2e-8 m, smallest gap with a limit cycle": {
        *("txt-5.2.1-threshold", "fig-5.6", "txt-5.2.1-touching", "txt-6-threshold"),
    },
    "815 Hz, limit cycle predicted for inertia-controlled backlash": {
        *("txt-5.2.2-prediction", "fig-5.13", "fig-5.17", "eq-5.10"),
    },
    "737.514 Hz, limit cycle predicted with 0.6 N of friction": {"txt-5.2.5-prediction", "fig-5.23"},
    "one limit cycle with 0.6 N of friction and a gap of 4e-6 m": {
        *("txt-5.2.5-prediction", "txt-5.2.5-amplitude", "fig-5.23"),
    },
    "-j 4F_c/(omega A pi), friction term of the equivalent nonlinearity": {
        *("eq-5.14", "txt-5.2.5-coulomb-term", "fig-5.21"),
    },
    "the open loop shows the limit cycle of the closed loop": {"fig-5.12", "txt-5.2.1-open-loop-peak"},
    "N G + 1 = 0, condition for harmonic balance of backlash": {"eq-5.7", "eq-5.11"},
    "0.5705 %, difference of 737.514 Hz to friction-controlled backlash": {
        *("txt-5.2.5-difference", "txt-5.2.5-quoted-prediction"),
    },
    "the amplitude is proportional to the gap, the frequency does not depend on it": {
        *("txt-5.2.1-proportional", "txt-7-proportional"),
    },
}


@pytest.fixture(scope="module")
def findings(findings, inventory):
    ids = [
        each
        for each in inventory
        if each.split("-")[1].startswith("5") or each in set.union(*SHARED.values())
    ]
    return [findings[each] for each in ids]


@pytest.mark.parametrize("name", SHARED)
def test_claims_on_one_printed_thing_share_its_item(name, findings):
    assert {finding.id for finding in findings if any(part.item == name for part in finding.parts)} >= SHARED[
        name
    ]
    assert [item.name for item in items(findings)].count(name) == 1


def test_a_number_that_was_tried_in_several_ways_counts_once(findings):
    parts = [part for finding in findings for part in finding.parts]
    for printed in ("737.514 Hz", "533.22 Hz", "814.9 Hz"):
        judged = {part.item for part in parts if str(part.printed) == printed and part.verdict.is_wrong}
        assert len(judged) == 1, printed


def test_what_rounding_and_reading_explain_is_a_slip(findings):
    """A prediction with rounded coefficients and a simulation read within half a percent change nothing."""
    by_item = {item.name: item for item in items(findings)}
    for name in (
        "733.33 Hz, limit cycle predicted for friction-controlled backlash",
        "3.3138e-5 m, amplitude predicted for friction-controlled backlash",
        "734.00 Hz, simulated frequency for 4e-6 m",
        "3.2995e-5 m, simulated amplitude for 4e-6 m",
        "221.989 Hz, peak of the spectrum with 0.6 N of friction",
    ):
        assert by_item[name].severity is Severity.SLIP, name


def test_exponents_of_equation_5_1_are_possibly_the_copy(findings):
    (finding,) = (each for each in findings if each.id == "eq-5.1")
    copied = [part for part in finding.parts if part.verdict is Verdict.COPY]
    assert [str(part.printed) for part in copied][:1] == ["7.0767"]
    assert all(part.decided_by for part in copied)
    assert finding.verdict is Verdict.EXPLAINED
