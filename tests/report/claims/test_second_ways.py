"""Second ways that claims share: that they agree with something else, and that they can disagree."""

import math

import numpy as np
import pytest

from report.chapters.second_ways import by_division_back, by_grid, by_matching_real_parts
from report.judging.claim import Claim, ClaimPart
from report.judging.comparisons.assertion import Assertion
from report.judging.comparisons.printed import power, power_of
from report.judging.judge import ContradictionError, judge
from report.judging.parts import so
from report.numbers.friction_in_place import force_response
from report.numbers.independent.harmonics import BY_FRICTION, BY_THE_PIN, displacements
from report.numbers.thesis import DRIVE_FREQUENCY, LARGE_GAP
from report.numbers.time_stepping import FINE_STEP, lines_in_steps, steps
from trimmer.linear import real_axis_crossings, response_at
from trimmer.thesis import TrimmerBody

CUTTER, GUARD = TrimmerBody.CUTTER.index, TrimmerBody.GUARD.index


def test_a_second_way_that_leads_elsewhere_stops_the_judgement(inventory):
    finding = Assertion(statement="it is so", derived=True, evidence="", method="one way")
    sound, unsound = (
        Claim("eq-2.1", (ClaimPart("", finding, so("another", holds)),), "") for holds in (True, False)
    )
    (part,) = judge(sound, inventory["eq-2.1"]).parts
    assert part.method == "one way; confirmed by another"
    with pytest.raises(ContradictionError, match="another"):
        judge(unsound, inventory["eq-2.1"])


@pytest.mark.parametrize("omega", [10.0, 690.8, 4609.5, 3e4])
def test_the_matrices_written_by_hand_give_the_responses_of_the_model(evidence, omega):
    numbers = evidence.numbers
    pin = displacements(numbers.parameters, omega, numbers.parameters.k2 * BY_THE_PIN)
    friction = displacements(numbers.parameters, omega, BY_FRICTION)
    expected = complex(response_at(numbers.displacement_only, omega))
    assert pin[CUTTER] - pin[GUARD] == pytest.approx(expected, rel=1e-9)
    expected = complex(response_at(force_response(numbers.parameters), omega))
    assert friction[CUTTER] - friction[GUARD] == pytest.approx(expected, rel=1e-9)


def test_a_conversion_is_turned_round():
    assert by_division_back(5.12e3, 5.12e3 / (2 * math.pi)).comparison.compare().agrees
    assert not by_division_back(5.12e3, 814.9).comparison.compare().agrees


def test_crossings_and_solutions_are_counted_on_a_grid(evidence):
    system = evidence.numbers.displacement_only
    assert by_grid(system, 0).comparison.compare().agrees
    turned = sum(crossing.value > 0 for crossing in real_axis_crossings(system))
    assert turned > 0
    assert by_grid(-system, turned).comparison.compare().agrees
    assert not by_grid(system, 1).comparison.compare().agrees
    # Without friction harmonic balance has two limit cycles for every gap.
    assert by_matching_real_parts(system, 0.0, 2).comparison.compare().agrees
    assert not by_matching_real_parts(system, 0.0, 1).comparison.compare().agrees


def test_steps_without_reference_stay_on_the_limit_cycle(evidence):
    orbit = evidence.motion.closed.orbits.friction.stable
    (line,) = lines_in_steps(orbit, LARGE_GAP, [steps(0.0, DRIVE_FREQUENCY)], [orbit.frequency])
    assert line == pytest.approx(LARGE_GAP * abs(orbit.harmonics[0]), rel=0.002)


def test_steps_of_friction_agree_with_the_exact_motion(evidence):
    relay = evidence.motion.closed.relay
    exact = np.array([run.last_turn for run in relay.friction])
    assert np.array(relay.last_turn_in_steps) == pytest.approx(exact, rel=0.02, abs=2 * FINE_STEP)


@pytest.mark.parametrize(
    ("digits", "shown"),
    [
        ("2e-8", r"$2\times10^{-8}$"),
        ("1e-8", "$10^{-8}$"),
        ("3.3138e-05", r"$3.3138\times10^{-5}$"),
        ("5e+07", r"$5\times10^{7}$"),
        ("0.6", "$0.6$"),
        ("0e+00", "$0$"),
    ],
)
def test_powers_of_ten_are_written_out(digits, shown):
    assert power(digits) == shown


def test_a_number_is_rounded_before_it_is_written():
    assert power_of(3.31579e-5, 2) == r"$3.32\times10^{-5}$"
