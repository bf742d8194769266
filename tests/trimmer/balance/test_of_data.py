"""Limit cycles of a plant that is known at some frequencies alone, beside those of the plant itself."""

import re
from collections.abc import Callable
from pathlib import Path

import control
import numpy as np
import pytest

from trimmer import (
    ClosedLoop,
    Drive,
    OpenLoop,
    TrimmerError,
    UndecidedWarning,
    harmonic_balance,
    harmonic_leakage,
    limit_cycles,
)
from trimmer.elements import Element, FrictionBacklash, Relay, Saturation, ViscousBacklash, ViscousFriction
from trimmer.linear import MeasuredResponse, measured_response

PLANT = control.tf([4.0], [1.0, 2.0, 1.0, 0.0])


def data(points: int) -> MeasuredResponse:
    """The response of the plant at frequencies in equal ratios."""
    omega = np.geomspace(0.05, 20.0, points)
    return MeasuredResponse(omega, PLANT(1j * omega))


@pytest.mark.parametrize(
    "element", [Saturation(1.0), Relay(1.0), FrictionBacklash(0.2), ViscousBacklash(0.2, 0.5)], ids=repr
)
@pytest.mark.parametrize("points", [12, 40])
def test_what_data_predict_is_what_the_plant_does_within_the_bound(element: Element, points: int) -> None:
    found, known = harmonic_balance(data(points), element), harmonic_balance(PLANT, element)
    assert not found.certificate.complete
    assert found.certificate.doubts[0].startswith("frequency-response data have no certificate")
    assert len(found.limit_cycles) == len(known.limit_cycles) == len(found.bounds) == 1
    (cycle,), (exact,), (bound,) = found.limit_cycles, known.limit_cycles, found.bounds
    assert abs(cycle.amplitude - exact.amplitude) <= bound.amplitude <= exact.amplitude
    # At 1 rad/s, in the middle of all the frequencies, symmetry leaves nothing but rounding.
    assert abs(cycle.omega - exact.omega) <= bound.omega + 1e-14
    assert (cycle.stable, cycle.index) == (exact.stable, exact.index)
    assert cycle.residual < 1e-6


def test_what_bends_evenly_may_be_off_by_twice_its_bend_and_the_spline_by_what_it_is_seen_to() -> None:
    x = np.linspace(0.0, 2.0, 9)
    between = np.linspace(0.0, 2.0, 33)
    bound = MeasuredResponse(np.exp(x), np.exp(-0.7 * x**2)).error(between)
    before = between % 0.25
    assert bound == pytest.approx(3.0 * 0.7 * before * (0.25 - before), abs=1e-12)


def test_a_bound_is_what_the_worst_response_that_is_so_far_off_does() -> None:
    element, off = FrictionBacklash(0.2), 1e-4
    (cycle,), (bound,) = (balance := harmonic_balance(data(12), element)).limit_cycles, balance.bounds
    others = [
        harmonic_balance(MeasuredResponse(data(12).omega, data(12).response * (1 + turn * off)), element)
        for turn in (1.0, 1.0j)
    ]
    for name in ("amplitude", "omega"):
        # What a turned change moves is a cosine of the angle, of which two at right angles tell the largest.
        moved = [getattr(each.limit_cycles[0], name) - getattr(cycle, name) for each in others]
        assert np.hypot(*moved) / off == pytest.approx(getattr(bound, name) / bound.response, rel=1e-2)


def test_the_bound_falls_with_the_square_of_the_distance_of_points() -> None:
    x = np.linspace(np.log(0.06), np.log(19.0), 2001)
    coarse, fine = (data(points).error(x).max() for points in (201, 401))
    assert coarse / fine == pytest.approx(4.0, rel=0.1)
    known = PLANT(1j * np.exp(x))
    assert (np.abs(data(201).at(np.exp(x)) / known - 1.0) <= data(201).error(x) + 1e-12).all()


def test_an_integrator_is_exact_between_its_points() -> None:
    omega = np.array([0.1, 0.4, 3.0, 50.0])
    between = np.geomspace(0.1, 50.0, 23)
    found = MeasuredResponse(omega, 2.0 / (1j * omega) ** 2)
    assert found.at(between) == pytest.approx(2.0 / (1j * between) ** 2, rel=1e-12)
    assert found.error(np.log(between)) == pytest.approx(np.zeros(23), abs=1e-12)
    assert np.isnan(found.at([0.09, 51.0])).all()


@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_the_short_form_warns_and_harmonics_beyond_the_data_are_not_known() -> None:
    frd = control.frd(PLANT(1j * np.geomspace(0.2, 5.0, 60)), np.geomspace(0.2, 5.0, 60))
    with pytest.warns(UndecidedWarning, match="have no certificate"):
        (cycle,) = limit_cycles(frd, Saturation(1.0))
    third, fifth = harmonic_leakage(frd, Saturation(1.0), cycle, (3, 7))
    assert third == pytest.approx(harmonic_leakage(PLANT, Saturation(1.0), cycle, (3,))[0], rel=1e-3)
    assert np.isnan(fifth)
    assert harmonic_balance(frd, Saturation(1.0)).plot().get_xlabel() == "real part"


def test_a_phase_that_turns_far_between_two_points_is_told() -> None:
    resonance = control.tf([1.0], [1.0, 0.02, 1.0])
    omega = np.geomspace(0.5, 2.0, 8)  # Between the two in the middle lies the resonance, at 1 rad/s.
    doubts = MeasuredResponse(omega, resonance(1j * omega)).doubts
    assert re.search(r"between 0\.9\d+ and 1\.1\d+ rad/s the phase turns by 16\d degrees", doubts[-1])


FRD = control.frd([1.0, 2.0, 3.0, 4.0], [1.0, 2.0, 3.0, 4.0])
REFUSED: dict[str, tuple[Callable[[], object], str]] = {
    "beyond": (lambda: harmonic_balance(FRD, Relay(1.0), (0.5, 2.0)), "goes beyond the data, 1 to 4 rad/s"),
    "linear": (lambda: harmonic_balance(FRD, ViscousFriction(1.0)), "is linear"),
    "closed": (lambda: ClosedLoop(FRD, Relay(1.0)), "how a plant moves does not follow from its response"),
    "driven": (
        lambda: OpenLoop(FRD, Relay(1.0), Drive(1.0, frequency=1.0)),
        "harmonic_balance.data, element",
    ),
    "zero": (lambda: MeasuredResponse([0, 1, 2, 3], [1, 1, 1, 1]), "leave zero out"),
    "table": (lambda: MeasuredResponse(np.ones((4, 2)), np.ones((4, 2))), "as many responses as frequencies"),
    "fewer": (lambda: MeasuredResponse([1, 2, 3, 4], [1, 1, 1]), "as many responses as frequencies"),
    "order": (lambda: MeasuredResponse([1, 3, 2, 4], [1, 1, 1, 1]), "positive and rising"),
    "few": (lambda: MeasuredResponse([1, 2, 3], [1, 1, 1]), "4 or more, not shapes"),
    "vanishing": (lambda: MeasuredResponse([1, 2, 3, 4], [1, 1, 0, 1]), "the response at 3 rad/s is 0"),
    "text": (lambda: MeasuredResponse([1, 2, 3, 4], ["a", 1, 0, 1]), "are no complex numbers"),
    "several": (
        lambda: harmonic_balance(control.frd(np.ones((2, 2, 4)), [1, 2, 3, 4]), Relay(1.0)),
        "of 2 inputs and 2 outputs are not accepted",
    ),
    "sampled": (
        lambda: harmonic_balance(control.frd([1, 1, 1, 1], [1, 2, 3, 4], 0.1), Relay(1.0)),
        "must be continuous in time",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_data_do_not_tell_is_refused(case: str) -> None:
    call, message = REFUSED[case]
    with pytest.raises(TrimmerError, match=message):
        call()


@pytest.mark.parametrize(
    "head", ["frequency,real,imaginary", "omega,decibels,degrees", "omega,magnitude,phase"]
)
def test_a_table_is_read(head: str, tmp_path: Path) -> None:
    known = data(12)
    size, turned = np.abs(known.response), np.angle(known.response)
    columns = {
        "frequency": known.omega / (2.0 * np.pi),
        "omega": known.omega,
        "real": known.response.real,
        "imaginary": known.response.imag,
        "magnitude": size,
        "decibels": 20.0 * np.log10(size),
        "phase": turned,
        "degrees": np.degrees(turned),
    }
    table = np.column_stack([columns[name] for name in head.split(",")])
    np.savetxt(tmp_path / "plant.csv", table, delimiter=",", header=head, comments="", fmt="%.17g")
    found = measured_response(tmp_path / "plant.csv")
    assert found.omega == pytest.approx(known.omega, rel=1e-14)
    assert found.response == pytest.approx(known.response, rel=1e-13)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("f,real\n1,2\n", "the columns are f, real; name them frequency"),
        ("frequency,real\n1,2\n", "the columns are frequency, real"),
        ("frequency,real,imaginary\n1,2,0\n", "plant.csv: frequency-response data must be"),
    ],
)
def test_other_tables_are_refused(text: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "plant.csv").write_text(text)
    with pytest.raises(TrimmerError, match=message):
        measured_response(tmp_path / "plant.csv")
