"""Fits of a linear oscillator, whose lines are a formula: best fit, profiles and notes by SciPy alone."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq, least_squares
from scipy.stats import f

from tests.quick import quick
from trimmer import Body, Force, Link, Mechanism, Output, Signal
from trimmer import fit as fit_numbers
from trimmer.errors import FitError
from trimmer.fitting import Fit, FitSettings

DRIVE, RATE, COUNT, BEGIN = 20.0, 1000.0, 2000, 0.00723
FORCES = {1: 50.0, 2: 30.0}
STIFFNESS, DAMPING = "links.spring.stiffness", "links.spring.damping"
ONCE = FitSettings(starts=1)
UNITS = ("m", "m/s", "m/s²")
TIMES = np.arange(COUNT) / RATE


def oscillator(stiffness: float = 1e4, damping: float = 15.0, **changes: object) -> Mechanism:
    made = Mechanism(
        bodies={"block": Body(1.0)},
        frequency=DRIVE,
        links={"spring": Link(("ground", "block"), stiffness, damping)},
        forces={
            f"shaker {order}": Force("block", amplitude=size, order=order) for order, size in FORCES.items()
        },
        outputs={"position": Output({"block": 1})},
    )
    return replace(made, **changes)  # type: ignore[arg-type]


def line(order: int, stiffness: float, damping: float, derivatives: int = 0) -> complex:
    """Complex amplitude at a multiple of the drive."""
    s = 2j * math.pi * DRIVE * order
    return complex(-1j * FORCES.get(order, 0.0) / (stiffness + s * (damping + s)) * s**derivatives)


def record(
    derivatives: int = 0,
    noise: float = 1e-5,
    more: np.ndarray | float = 0.0,
    numbers: tuple[float, float] = (1e4, 15.0),
) -> Signal:
    """The oscillator's motion from a time within the drive's period on, with noise."""
    values = sum(
        (line(order, *numbers, derivatives) * np.exp(2j * np.pi * DRIVE * order * (TIMES + BEGIN))).real
        for order in FORCES
    )
    noisy = noise * np.random.default_rng(7).normal(size=COUNT) * (2 * np.pi * DRIVE) ** derivatives
    return Signal(values + noisy + more, RATE, "position", UNITS[derivatives])


def fitted(signal: Signal) -> Fit:
    start = oscillator(stiffness=1.3e4, damping=10.0)
    return fit_numbers(start, {"position": signal}, (STIFFNESS, DAMPING), settings=ONCE)


def residual(fit: Fit, stiffness: float, damping: float, angle: float) -> np.ndarray:
    """Differences of the formula's lines from the measured ones, in standard deviations."""
    (derivatives,) = fit.measured.derivatives
    orders = np.arange(1, len(fit.measured.lines) + 1)
    lines = np.array([line(order, stiffness, damping, derivatives) for order in orders])
    apart = (lines * np.exp(1j * angle * orders) - fit.measured.lines[:, 0]) / fit.measured.deviations[:, 0]
    return np.concatenate([apart.real, apart.imag])


def lowest(fit: Fit, **held: float) -> tuple[np.ndarray, float]:
    """Return the best stiffness, damping and angle, and chi-square, with some of them held."""
    names = [name for name in ("stiffness", "damping", "angle") if name not in held]
    scale = {"stiffness": 1e4, "damping": 15.0, "angle": 1.0}
    begin = {"stiffness": 1.0, "damping": 1.0, "angle": 2 * math.pi * DRIVE * BEGIN}

    def of(unknown: np.ndarray) -> np.ndarray:
        free = {name: scale[name] * at for name, at in zip(names, unknown, strict=True)}
        return residual(fit, **{**free, **held})

    found = least_squares(of, [begin[name] for name in names], xtol=1e-14, ftol=1e-14, gtol=1e-14)
    return found.x, 2.0 * float(found.cost)


@pytest.fixture(scope="module", params=quick([0, 1, 2], 2))
def fit(request: pytest.FixtureRequest) -> Fit:
    return fitted(record(request.param))


def test_the_fit_is_the_least_squares_of_the_formula(fit: Fit) -> None:
    (stiffness, damping, angle), chi_square = lowest(fit)
    assert fit.judgement.chi_square == pytest.approx(chi_square, abs=0.02)
    values = {each.place: each for each in fit.numbers}
    for place, value in ((STIFFNESS, 1e4 * stiffness), (DAMPING, 15.0 * damping)):
        width = values[place].upper - values[place].lower  # type: ignore[operator]
        assert abs(values[place].value - value) < 0.02 * width
        assert fit.mechanism.value(place) == values[place].value
    # By so much later than the measurement a drive period begins.
    shift = (-angle / (2 * math.pi * DRIVE)) % fit.period
    assert fit.shift == pytest.approx(shift, abs=1e-3 / DRIVE)
    assert fit.judgement.freedom == 2 * len(fit.measured.lines) - 3
    assert fit.judgement.explained
    assert (fit.weak, fit.notes) == ((), ())


def test_ends_of_intervals_are_where_the_profile_exceeds_the_quantile(fit: Fit) -> None:
    _, least = lowest(fit)
    allowed = float(f.ppf(0.95, 1, fit.measured.freedom))
    for name, number in zip(("stiffness", "damping"), fit.numbers, strict=True):
        for end in (number.lower, number.upper):
            assert end is not None
            apart = end - number.value

            def excess(share: float) -> float:
                return lowest(fit, **{name: number.value + share * apart})[1] - least - allowed  # noqa: B023

            assert brentq(excess, 0.3, 3.0, xtol=1e-6) == pytest.approx(1.0, abs=0.06)
    assert fit.confidence == 0.95
    narrow = fit_numbers(
        oscillator(), fit.measured.signals, (STIFFNESS,), settings=FitSettings(starts=1, confidence=0.5)
    ).numbers[0]
    assert narrow.upper - narrow.lower < 0.5 * (fit.numbers[0].upper - fit.numbers[0].lower)  # type: ignore[operator]


def test_waveforms_are_sums_of_their_lines(fit: Fit) -> None:
    times, data, simulated = fit.waveforms("position", 8)
    drive = fit.measured.frequency
    assert times == pytest.approx(np.arange(8) / (8 * drive))
    assert drive == pytest.approx(DRIVE, rel=1e-4)
    orders = np.arange(1, len(fit.measured.lines) + 1)
    for values, lines in ((data, fit.measured.lines), (simulated, fit.simulated)):
        turned = np.exp(2j * np.pi * drive * np.outer(times, orders))
        assert values == pytest.approx((turned @ lines[:, 0]).real, rel=1e-9, abs=1e-12)


def test_two_outputs_with_a_common_noise_are_weighed_with_its_inverse_covariance() -> None:
    """What both hold in common is noise, so that the difference of both tells."""
    both = {"position": Output({"block": 1}), "double": Output({"block": 2})}
    clean, hum = record(noise=0.0).values, 1e-3 * np.random.default_rng(1).normal(size=COUNT)
    own = 1e-5 * np.random.default_rng(2).normal(size=COUNT)
    signals = {
        "position": Signal(clean + hum, RATE, "position", "m"),
        "double": Signal(2 * clean + hum + own, RATE, "double", "m"),
    }
    start = oscillator(1.1e4, outputs=both)
    together = fit_numbers(start, signals, (STIFFNESS,), settings=ONCE).numbers[0]
    alone = fit_numbers(start, {"double": signals["double"]}, (STIFFNESS,), settings=ONCE).numbers[0]
    assert together.value == pytest.approx(1e4, rel=1e-3)
    assert together.upper - together.lower < 0.1 * (alone.upper - alone.lower)  # type: ignore[operator]


@pytest.mark.slow
def test_springs_side_by_side_cannot_be_told_apart() -> None:
    both = oscillator(links={name: Link(("ground", "block"), 1e4, 5.0) for name in "ab"})
    signal = record(numbers=(2e4, 10.0))
    fit = fit_numbers(both, {"position": signal}, ["links.a.stiffness", "links.b.stiffness"], settings=ONCE)
    (weak,) = fit.weak
    assert set(weak.places) == {"links.a.stiffness", "links.b.stiffness"}
    assert weak.changes[0] == pytest.approx(-weak.changes[1], rel=0.1)
    assert "cannot be told apart: raising the" in weak.message and "and lowering the" in weak.message
    for number in fit.numbers:
        # Either may vanish, and the other one takes all of the 20 N/mm.
        assert number.lower is None
        assert f"{number.place}: {number.lower_note}" in list(number.sentences)
        assert "the lower end is open" in number.lower_note
        assert number.upper == pytest.approx(2e4, rel=0.01)


def test_a_mechanism_that_lacks_something_is_told() -> None:
    third = 3e-4 * np.cos(2 * np.pi * 3 * DRIVE * TIMES)
    hum = 2e-3 * np.cos(2 * np.pi * 27.1 * TIMES)
    half = 4e-4 * np.cos(2 * np.pi * 1.5 * DRIVE * TIMES)
    fit = fitted(record(more=third + hum + half))
    told = " ".join(fit.judgement.sentences)
    assert not fit.judgement.explained and fit.judgement.reduced > 20
    assert any(each.order == (6, 2) for each in fit.judgement.excesses)
    assert "3/2" in told and "at 27.1 Hz, which are no fraction of the drive" in told
    assert any("repeats after 2 drive periods, the fitted one after one" in note for note in fit.notes)


@pytest.mark.slow
def test_a_line_of_something_else_is_no_noise() -> None:
    hum = 1e-3 * np.cos(2 * np.pi * 7.3 * TIMES)
    with_hum, clean = fitted(record(more=hum).scaled(1e6, "um")), fitted(record())
    assert with_hum.judgement.explained
    for number, same in zip(with_hum.numbers, clean.numbers, strict=True):
        assert number.value == pytest.approx(same.value, rel=1e-3)
        assert number.upper == pytest.approx(same.upper, rel=1e-2)


@pytest.mark.parametrize(
    ("off", "told"), quick([(1.0002, ["+0.02 % off"]), (0.9998, ["-0.02 % off"]), (1.00005, [])], 1, 2)
)
def test_a_drive_that_differs_from_that_of_the_file_is_told(off: float, told: list[str]) -> None:
    start = oscillator(1.1e4, frequency=DRIVE / off)
    fit = fit_numbers(start, {"position": record(noise=1e-6)}, (STIFFNESS,), settings=ONCE)
    assert fit.measured.frequency == pytest.approx(DRIVE, rel=1e-5)
    assert fit.mechanism.frequency == fit.measured.frequency
    assert len(fit.notes) == len(told)
    assert all(words in note for words, note in zip(told, fit.notes, strict=True))


def test_what_speaks_against_a_fit_is_noted() -> None:
    signal = record()
    notes = fitted(Signal(-signal.values, RATE, "position", "m")).notes
    assert any("with the opposite sign of the measurement the fit would be better" in note for note in notes)
    (note,) = fitted(record(noise=0.0)).notes
    assert "hardly any noise is seen between the lines" in note
    clipped = np.clip(signal.values, -0.5 * abs(signal.values).max(), None)
    cut = {"position": Signal(clipped, RATE, "position", "m")}
    assert any("clip" in note for note in fit_numbers(oscillator(), cut, (STIFFNESS,), settings=ONCE).notes)


def test_a_number_that_wants_to_vanish_is_at_the_end_of_what_is_searched() -> None:
    extra = replace(
        oscillator(), links={**oscillator().links, "more": Link(("ground", "block"), 0.0, 5.0)}
    ).with_value("links.spring.damping", 16.0)
    fit = fit_numbers(extra, {"position": record()}, ["links.more.damping"], settings=ONCE)
    assert any(note.startswith("links.more.damping: 0.005") and "is at the end" in note for note in fit.notes)
    assert fit.numbers[0].lower is None and "the lower end is open" in fit.numbers[0].lower_note


def test_more_numbers_than_the_lines_tell_are_refused() -> None:
    """Four lines are eight numbers, of which one is the origin of time."""
    force = Force("block", constant=1.0, amplitude=50.0, phase=0.1, unbalance=0.01)
    one = oscillator(forces={"shaker": force})
    free = ["bodies.block.mass", STIFFNESS, DAMPING]
    free += [f"forces.shaker.{key}" for key in ("amplitude", "phase", "constant", "unbalance")]
    wave = 4e-3 * np.cos(2 * np.pi * DRIVE * TIMES) + 1e-5 * np.random.default_rng(1).normal(size=COUNT)
    with pytest.raises(FitError, match="7 numbers cannot be fitted to 4 lines"):
        fit_numbers(one, {"position": Signal(wave, RATE, "position", "m")}, free, settings=ONCE)


def test_starts_that_agree_are_counted() -> None:
    start, settings = oscillator(stiffness=1.3e4, damping=10.0), FitSettings(starts=3)
    fit = fit_numbers(start, {"position": record()}, (STIFFNESS, DAMPING), settings=settings)
    searched = fit.searched
    assert searched.agreeing + len(searched.elsewhere) + searched.lost == searched.starts == 3
    assert f"{searched.agreeing} of 3 starts came to this fit" in fit.agreement
    for changes, told in (
        ({"starts": 1, "agreeing": 1}, "one start alone"),
        ({"starts": 1, "agreeing": 0}, "no start came"),
        (
            {"starts": 5, "agreeing": 2, "elsewhere": (2e3, 3e3), "lost": 1},
            "2 of 5 starts came to this fit, 2 to worse ones (chi-square 2000 or more against",
        ),
        ({"lost": 1}, ", and 1 began where"),
    ):
        other = replace(fit, searched=replace(searched, **changes))
        assert told in other.agreement
