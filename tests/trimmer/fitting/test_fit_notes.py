"""What is said beside a fit, and numbers of its result, from fits made by hand."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.fitting.known import Known, measured
from trimmer import Signal
from trimmer.errors import FitError
from trimmer.fitting import fit as module
from trimmer.fitting.fit import FitSettings, _checked, _kind, _notes, _number, _open, _profiled
from trimmer.fitting.profile import Side
from trimmer.fitting.result import Fit, FittedNumber
from trimmer.fitting.search import Searched
from trimmer.fitting.unknowns import Unknown

GAP = Unknown("plays.p.gap", "m", 4e-5, True)
PHASE = Unknown("pins.p.phase", "rad", 0.1, False)
LINES = np.array([[1.0 + 0j], [0.5j]])


def test_both_ends_of_a_number_are_values_of_their_coordinates() -> None:
    found = _number(GAP, np.log(2.0), Side(np.log(1.5), np.log(1.6)), Side(None, np.log(4.0), lost=True))
    assert (found.place, found.unit, found.before) == ("plays.p.gap", "m", 4e-5)
    assert (found.value, found.lower) == pytest.approx((8e-5, 6e-5))
    assert (found.lowest, found.highest) == pytest.approx((6.4e-5, 1.6e-4))
    assert found.upper is None
    assert found.lower_note == ""
    assert list(found.sentences) == [f"plays.p.gap: {found.upper_note}"]
    assert "upper end is open: beyond 0.00016 m no stable motion" in found.upper_note


def test_why_an_end_is_open() -> None:
    better: Any = SimpleNamespace()
    assert _open(GAP, Side(0.1, 0.1), "lower") == ""
    assert "better fits were met" in _open(GAP, Side(None, 0.0, better=better), "lower")
    told = _open(PHASE, Side(None, 0.4), "upper")
    assert told.startswith("the upper end is open: 0.5 rad fits within the noise too")


def misfit(opposite: float = 100.0, **of_measured: Any) -> Any:
    lines = measured(LINES, **of_measured)
    return SimpleNamespace(
        measured=lines, model=SimpleNamespace(unknowns=(GAP, PHASE)), opposite=lambda best: opposite
    )


def best(coordinates: tuple[float, float] = (0.0, 0.0), period_count: int = 1) -> Any:
    orbit = SimpleNamespace(period_count=period_count)
    return SimpleNamespace(
        coordinates=np.array(coordinates), chi_square=10.0, motion=SimpleNamespace(orbit=orbit)
    )


def notes(of: Any, fitted: Any, frequency: float = 50.0) -> list[str]:
    mechanism: Any = SimpleNamespace(frequency=frequency)
    return list(_notes(mechanism, of, fitted))


def test_each_doubt_has_its_note(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "faults", lambda signal: ())
    assert notes(misfit(), best()) == []
    assert notes(misfit(), best(), 50.0 / 1.00009) == []
    (told,) = notes(misfit(), best(), 50.0 / 1.0002)
    assert told.startswith("the measured drive, 50 Hz, is +0.02 % off")
    (told,) = notes(misfit(), best(), 50.0 / 0.9998)
    assert "-0.02 % off" in told
    (told,) = notes(misfit(noiseless=True), best())
    assert "hardly any noise" in told
    (told,) = notes(misfit(4.9), best())
    assert "opposite sign" in told
    assert notes(misfit(5.1), best()) == []
    (told,) = notes(misfit(), best((-6.8, 0.0)))
    assert told.startswith("plays.p.gap: 4.455e-08 m is at the end")
    assert notes(misfit(), best((6.7, 970.0))) == []
    (told,) = notes(misfit(), best((0.0, 990.0)))
    assert told.startswith("pins.p.phase: 990.1 rad")
    (told,) = notes(misfit(period_count=2), best())
    assert "repeats after 2 drive periods, the fitted one after one drive period" in told
    assert list(_kind(measured(LINES, period_count=2), best(period_count=2))) == []


def test_faults_are_named_with_their_signal_where_there_are_several(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "faults", lambda signal: (SimpleNamespace(sentence="it clips"),))
    assert notes(misfit(), best()) == ["it clips"]
    two = misfit()
    two.measured = measured(np.ones((2, 2), complex))
    assert notes(two, best()) == ["s0: it clips", "s1: it clips"]


def test_profiles_begin_anew_at_a_better_fit() -> None:
    def residual(at: np.ndarray) -> np.ndarray:
        # Flat from 0.1 on, and there better by 5.
        return np.array([3.0 if at[0] < 0.15 else 2.0, 10.0 * (at[0] - 0.2 * (at[0] >= 0.15)), 9.0 * at[1]])

    known: Any = Known(residual)
    found, jacobian, sides = _profiled(known, known.at(0.0, 0.0), 4.0)
    assert found.coordinates == pytest.approx([0.2, 0.0], abs=1e-6)
    np.testing.assert_allclose(jacobian, [[0, 0], [10, 0], [0, 9]], atol=1e-6)
    (lower, upper), (left, right) = sides
    assert upper.end == pytest.approx(0.4, rel=1e-5)
    assert (left.end, right.end) == (pytest.approx(-2 / 9, rel=1e-5), pytest.approx(2 / 9, rel=1e-5))
    assert lower.better is None


def test_profiles_that_meet_better_fits_without_end_are_unknown() -> None:
    known: Any = Known(lambda at: np.array([40.0 - 25.0 * np.floor(at[0] / 0.1) * 0.1, 1.0 + 9 * at[1], 3.0]))
    found, _, sides = _profiled(known, known.at(0.05, -1 / 9), 4.0)
    assert len(sides) == 2
    for at, pair in zip(found.coordinates, sides, strict=True):
        for side in pair:
            assert (side.end, side.reached, side.better) == (None, at, found)


@pytest.mark.parametrize("meets", [0, 1, 9])
def test_profiles_are_those_of_the_last_fit(monkeypatch: pytest.MonkeyPatch, meets: int) -> None:
    asked: list[Any] = []

    def profile(misfit: Any, best: Any, jacobian: Any, place: int, allowed: float) -> Any:
        def side(sign: float) -> Side:
            asked.append((best.name, jacobian, place, allowed, sign))
            better: Any = (
                f"better than {best.name}" if best.name < meets and (place, sign) == (1, 1.0) else None
            )
            return Side(0.1 * sign, 0.2 * sign, better=better)

        return SimpleNamespace(side=side)

    def least(misfit: Any, better: str, free: np.ndarray) -> Any:
        assert free.tolist() == [True, True, True]
        return named(int(better.split()[-1]) + 1)

    def named(name: int) -> Any:
        return SimpleNamespace(name=name, coordinates=np.array([3.0, 5.0, 7.0]) + name)

    monkeypatch.setattr(module, "Profile", profile)
    monkeypatch.setattr(module, "nearby_minimum", least)
    known: Any = SimpleNamespace(jacobian=lambda fitted: f"slope at {fitted.name}")
    found, jacobian, sides = _profiled(known, named(0), 4.0)
    last = min(meets, 4)
    assert (found.name, jacobian) == (last, f"slope at {last}")
    both = [(place, sign) for place in range(3) for sign in (-1.0, 1.0)]
    rows = [(name, *each) for name in range(min(last + 1, 4)) for each in both[: 4 if name < meets else 6]]
    assert asked == [(name, f"slope at {name}", place, 4.0, sign) for name, place, sign in rows]
    if meets < 4:
        assert [(lower.end, upper.end) for lower, upper in sides] == [(-0.1, 0.1)] * 3
    else:
        for at, pair in zip((7.0, 9.0, 11.0), sides, strict=True):
            assert [(each.end, each.reached, each.better is found) for each in pair] == [(None, at, True)] * 2


def fit(**changes: Any) -> Fit:
    fields: dict[str, Any] = dict.fromkeys(Fit.__dataclass_fields__)
    searched = Searched(best(), 5, 5, (), 0)
    judgement = SimpleNamespace(chi_square=10.0, sentences=("it explains",))
    usual = {"measured": measured(LINES, period_count=2), "simulated": 2j * LINES, "searched": searched}
    return Fit(**{**fields, **usual, "judgement": judgement, "numbers": (), **changes})


def test_waveforms_are_sums_of_their_lines() -> None:
    times, data, simulated = fit().waveforms("s0", 8)
    assert times == pytest.approx(np.arange(8) * 0.04 / 8)
    angles = 2 * np.pi * 25.0 * times
    assert data == pytest.approx(np.cos(angles) - 0.5 * np.sin(2 * angles))
    assert simulated == pytest.approx(-2 * np.sin(angles) - np.cos(2 * angles))
    assert fit().period == pytest.approx(0.04)


def test_agreement_counts_the_starts() -> None:
    searched = fit().searched
    assert "5 of 5 starts came to this fit" in fit().agreement
    assert "one start alone" in fit(searched=replace(searched, starts=1, agreeing=1)).agreement
    assert "no start came" in fit(searched=replace(searched, starts=1, agreeing=0)).agreement
    told = fit(searched=replace(searched, agreeing=2, elsewhere=(20.0, 30.0), lost=1)).agreement
    assert told.startswith(
        "2 of 5 starts came to this fit, 2 to worse ones (chi-square 20 or more against 10)"
    )
    assert ", and 1 began where" in told


def test_a_fitted_number_without_notes_has_no_sentences() -> None:
    number = FittedNumber("p", "m", 1.0, 2.0, 1.5, None, 1.5, 3.0, upper_note="open")
    assert list(number.sentences) == ["p: open"]
    assert list(replace(number, upper_note="", lower_note="low").sentences) == ["p: low"]


def test_settings_are_checked() -> None:
    for wrong in ({"spread": 1.0}, {"spread": 101.0}, {"confidence": 0.0}, {"confidence": 1.0}):
        with pytest.raises(FitError, match=next(iter(wrong))):
            FitSettings(**wrong)  # type: ignore[arg-type]
    for wrong in ({"starts": 0}, {"seed": -1}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            FitSettings(**wrong)  # type: ignore[arg-type]
    assert FitSettings(starts=1, spread=100.0, seed=0, confidence=0.5).spread == 100.0


def test_nothing_measured_or_an_unknown_output_is_refused() -> None:
    mechanism: Any = SimpleNamespace(frequency=50.0, outputs={"alpha": 1, "beta": 2})
    signal = Signal(np.ones(100), 1e3, "s", "m")
    assert _checked(mechanism, {"alpha": signal}) == 50.0
    with pytest.raises(FitError, match="nothing was measured"):
        _checked(mechanism, {})
    with pytest.raises(FitError, match="no output 'zzz'; there are alpha, beta"):
        _checked(mechanism, {"alpha": signal, "zzz": signal})
