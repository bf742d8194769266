"""What a fit hands on from its arguments to its parts, and from these to its result, with stand-ins."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.stats import f

from tests.trimmer.fitting.known import measured
from tests.trimmer.maps.machines import impact_oscillator
from trimmer import Signal
from trimmer.errors import FitError, WrongTypeError
from trimmer.fitting import fit as module
from trimmer.fitting.fit import FitSettings, _result, fit_mechanism
from trimmer.fitting.profile import Side
from trimmer.fitting.search import Searched
from trimmer.fitting.unknowns import Unknown
from trimmer.signals.signal import SignalError

SIGNAL = Signal(np.zeros(100), 1e3, "x", "m")
FREE = ("stops.wall.gap", "stops.wall.stiffness")
LINES = np.array([[1.0 + 0j], [0.5j]])


class Asked:
    """Stands in for the parts of ``fit_mechanism``, and keeps what they are asked."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.lines, self.found = measured(LINES, period_count=3), "searched"
        for name in ("measure_lines", "Model", "Misfit", "search", "_result"):
            monkeypatch.setattr(module, name, getattr(self, name.strip("_").lower()))

    def measure_lines(self, *given: Any) -> Any:
        self.of_lines = given
        return self.lines

    def model(self, *given: Any) -> str:
        self.of_model = given
        return "model"

    def misfit(self, *given: Any) -> Any:
        self.of_misfit = given
        return SimpleNamespace(model=SimpleNamespace(mechanism=None), measured=self.lines)

    def search(self, *given: Any) -> Any:
        self.of_search = given
        return self.found

    def result(self, *given: Any) -> str:
        self.of_result = given
        return "result"


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Asked:
    return Asked(monkeypatch)


def test_a_fit_searches_among_motions_at_the_measured_drive(asked: Asked) -> None:
    mechanism, signals, settings = impact_oscillator(), {"x": SIGNAL}, FitSettings(7, 3.0, 11, 0.9)
    assert fit_mechanism(mechanism, signals, FREE, settings=settings) == "result"  # type: ignore[comparison-overlap]
    assert asked.of_lines == (signals, mechanism.frequency, None)
    driven, unknowns, *rest = asked.of_model
    assert driven.frequency == 50.0
    assert driven.value("stops.wall.gap") == 10.0
    assert [each.place for each in unknowns] == list(FREE)
    assert rest == [("s0",), (0,), 3, 2]
    assert asked.of_misfit == (asked.lines, "model")
    misfit, *searched = asked.of_search
    assert searched == [7, 3.0, 11]
    assert asked.of_result == (mechanism, misfit, "searched", settings)
    fit_mechanism(mechanism, signals, FREE, drive_frequency=1.25)
    assert asked.of_lines[2] == 1.25
    assert asked.of_result[3] == FitSettings(5, 2.0, 0, 0.95)


@pytest.mark.parametrize("frequency", [0.0, -1.0, math.inf])
def test_a_drive_that_is_given_must_be_positive_and_finite(asked: Asked, frequency: float) -> None:
    with pytest.raises(SignalError, match="must be positive and finite"):
        fit_mechanism(impact_oscillator(), {"x": SIGNAL}, FREE, drive_frequency=frequency)


def test_wrong_types_are_named(asked: Asked) -> None:
    mechanism: Any = impact_oscillator()
    for name, given in (
        ("mechanism", ("it", {"x": SIGNAL}, FREE)),
        ("measured", (mechanism, SIGNAL, FREE)),
        ("the signal of x", (mechanism, {"x": [1.0]}, FREE)),
        ("free", (mechanism, {"x": SIGNAL}, "stops.wall.gap")),
    ):
        with pytest.raises(WrongTypeError, match=name):
            fit_mechanism(*given)
    with pytest.raises(WrongTypeError, match="settings"):
        fit_mechanism(mechanism, {"x": SIGNAL}, FREE, settings=5)  # type: ignore[arg-type]
    with pytest.raises(FitError, match="no drive"):
        fit_mechanism(replace(mechanism, frequency=None, forces={}), {"x": SIGNAL}, FREE)


def test_as_many_numbers_are_fitted_as_lines_tell(asked: Asked) -> None:
    # Two lines are four numbers, of which one is the origin of time.
    assert fit_mechanism(impact_oscillator(), {"x": SIGNAL}, FREE)
    with pytest.raises(FitError, match="3 numbers cannot be fitted to 2 lines"):
        fit_mechanism(impact_oscillator(), {"x": SIGNAL}, (*FREE, "bodies.mass.mass"))


@pytest.mark.parametrize(
    ("starts", "repeats", "where", "does"),
    [
        (5, 3, "all 5 starts", "repeats after 3 drive periods"),
        (1, 1, "its start", "repeats after one drive period"),
        (2, None, "all 2 starts", "does not repeat"),
    ],
)
def test_where_nothing_repeats_as_the_measurement_does_it_is_told(
    asked: Asked, monkeypatch: pytest.MonkeyPatch, starts: int, repeats: int | None, where: str, does: str
) -> None:
    from trimmer.response import settling

    orbit = None if repeats is None else SimpleNamespace(period_count=repeats)
    given: list[Any] = []
    monkeypatch.setattr(settling, "orbit_from_rest", lambda *each: given.append(each) or orbit)
    monkeypatch.setattr(module, "doubts_of", lambda lines: [f"doubt of {lines.frequency} Hz", "another"])
    asked.found = None  # type: ignore[assignment]
    with pytest.raises(FitError, match="the measured motion repeats after 3 drive periods, but ") as told:
        fit_mechanism(impact_oscillator(), {"x": SIGNAL}, FREE, settings=FitSettings(starts))
    assert f"from {where} that of the mechanism does not; with the numbers of the file it {does}: " in str(
        told.value
    )
    assert str(told.value).endswith("; doubt of 50.0 Hz; another")
    assert given == [(None, 400)]


def fitted(chi_square: float, angle: float = 0.0) -> Any:
    return SimpleNamespace(
        chi_square=chi_square,
        angle=angle,
        coordinates=np.array([math.log(2.0), 0.5]),
        lines="simulated",
        motion=SimpleNamespace(orbit="orbit"),
    )


@pytest.mark.parametrize(("better", "agreeing"), [(10.0, 3), (9.1, 3), (8.9, 0)])
def test_a_result_is_of_the_fit_at_which_the_profiles_end(
    monkeypatch: pytest.MonkeyPatch, better: float, agreeing: int
) -> None:
    unknowns = (Unknown("a.b.gap", "m", 4e-5, True), Unknown("c.d.offset", "m", -2e-3, False))
    model = SimpleNamespace(unknowns=unknowns, mechanism_at=lambda at: ("mechanism", at.tolist()))
    misfit: Any = SimpleNamespace(measured=measured(LINES, period_count=3, freedom=23.0), model=model)
    best = fitted(better, angle=-1.5)
    sides = [(Side(-0.1, -0.2), Side(1.0, 0.9)), (Side(None, 0.25), Side(0.75, 0.7))]
    asked: list[Any] = []

    def given(name: str, answer: Any) -> None:
        monkeypatch.setattr(module, name, lambda *each: asked.append((name, *each)) or answer)

    given("_profiled", (best, "slope", sides))
    given("judge", "judgement")
    given("weak_directions", ("weak",))
    given("_notes", iter(["one", "two"]))
    searched = Searched(fitted(10.0), 5, 3, (20.0, 30.0), 0)
    found = _result("before", misfit, searched, FitSettings(confidence=0.9))  # type: ignore[arg-type]
    allowed = float(f.ppf(0.9, 1, 23.0))
    assert asked == [
        ("_profiled", misfit, searched.best, pytest.approx(allowed, rel=1e-12)),
        ("judge", misfit.measured, best, 2),
        ("weak_directions", unknowns, "slope", pytest.approx(allowed, rel=1e-12)),
        ("_notes", "before", misfit, best),
    ]
    assert found.mechanism == ("mechanism", [math.log(2.0), 0.5])  # type: ignore[comparison-overlap]
    assert (found.before, found.confidence, found.measured) == ("before", 0.9, misfit.measured)
    assert (found.simulated, found.orbit, found.judgement) == ("simulated", "orbit", "judgement")
    assert (found.weak, found.notes) == (("weak",), ("one", "two"))
    # Turned back by 1.5 rad of a period of three drive periods at 50 Hz.
    assert found.shift == pytest.approx(1.5 / (2.0 * math.pi) * 3.0 / 50.0, rel=1e-12)
    gap, offset = found.numbers
    assert (gap.before, gap.value, gap.lower, gap.upper) == pytest.approx(
        (4e-5, 8e-5, 4e-5 * math.exp(-0.1), 4e-5 * math.e), rel=1e-12
    )
    assert (offset.value, offset.lower, offset.upper) == (-1e-3, None, pytest.approx(-0.5e-3, rel=1e-12))
    assert (found.searched.best, found.searched.agreeing, found.searched.starts) == (best, agreeing, 5)
    assert found.searched.elsewhere == ((20.0, 30.0) if agreeing else (10.0, 10.0, 10.0, 20.0, 30.0))
