"""Harmonics of forces against fine sums over time, and their derivatives against differences."""

from collections.abc import Callable

import numpy as np
import pytest

from tests.quick import quick
from trimmer import ContactLaw, Play, Stop
from trimmer.harmonics.balance import friction_harmonics
from trimmer.harmonics.contact import HarmonicContact
from trimmer.harmonics.crossings import crossings
from trimmer.harmonics.forces import Harmonics
from trimmer.harmonics.waveform import Decay, PeriodicWaveform

OMEGA = 2.0
SAMPLES = 50_000
BETWEEN = ("ground", "body")


def waveform(seed: int, harmonics: int = 6) -> PeriodicWaveform:
    random = np.random.default_rng(seed)
    orders = np.arange(harmonics + 1)
    coefficients = random.normal(size=harmonics + 1) + 1j * random.normal(size=harmonics + 1)
    coefficients /= (1.0 + orders) ** 1.5
    coefficients[0] = 0.2 * coefficients[0].real
    return PeriodicWaveform(coefficients, OMEGA)


def by_sums(force: np.ndarray, harmonics: int) -> np.ndarray:
    coefficients = 2.0 * np.fft.rfft(force) / len(force)
    coefficients[0] *= 0.5
    return coefficients[: harmonics + 1]


def by_time_steps(part: Play | Stop, distance: PeriodicWaveform) -> np.ndarray:
    """Follow the law of the relaxing contact in small steps over two periods; return the second."""
    step = distance.period / SAMPLES
    times = step * np.arange(SAMPLES)
    s, rate = distance.at(times), distance.slope(times)
    upper = 0.5 * part.gap if isinstance(part, Play) else part.gap
    lower = -upper if isinstance(part, Play) else -np.inf
    forces, z, decay = np.zeros(SAMPLES), 0.0, np.exp(-part.stiffness / part.damping * step)
    for number in range(2 * SAMPLES):
        at = number % SAMPLES
        z = min(max(z * decay, s[at] - upper), s[at] - lower)
        # Where the side of the slot is pushed it moves with the end, and the force must be a push.
        held = s[at] - upper if s[at] - z >= upper else s[at] - lower if s[at] - z <= lower else None
        force = 0.0 if held is None else part.stiffness * held + part.damping * rate[at]
        pushes = held is not None and force * (1.0 if held == s[at] - upper else -1.0) > 0.0
        forces[at] = force if pushes else 0.0
    return forces


PARTS = [
    Play(BETWEEN, 3.0, 0.4, 0.5, ContactLaw.RELAXING),
    Play(BETWEEN, 3.0, 0.4, 0.5, ContactLaw.TRUNCATED),
    Play(BETWEEN, 3.0, 0.4, 0.5, ContactLaw.PULLING),
    Play(BETWEEN, 3.0, 0.0, 0.5),
    Stop(BETWEEN, 3.0, 0.4, 0.3, ContactLaw.RELAXING),
    Stop(BETWEEN, 3.0, 0.0, -0.3),
    Play(BETWEEN, 3.0, 0.4, 0.0, ContactLaw.PULLING),
]


def sampled_force(part: Play | Stop, distance: PeriodicWaveform) -> np.ndarray:
    if part.law is ContactLaw.RELAXING and part.damping > 0.0:
        return by_time_steps(part, distance)
    times = distance.period * np.arange(SAMPLES) / SAMPLES
    s, rate = distance.at(times), distance.slope(times)
    upper = 0.5 * part.gap if isinstance(part, Play) else part.gap
    beyond = np.where(s > upper, s - upper, 0.0)
    if isinstance(part, Play):
        beyond = np.where(s < -upper, s + upper, beyond)
    force = np.where(beyond != 0.0, part.stiffness * beyond + part.damping * rate, 0.0)
    return force if part.law is ContactLaw.PULLING else np.where(force * beyond > 0.0, force, 0.0)


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize("seed", quick([1, 2], 0))
def test_contact(part: Play | Stop, seed: int) -> None:
    distance = waveform(seed)
    expected = by_sums(sampled_force(part, distance), 6)
    assert HarmonicContact(part, distance).harmonics().coefficients == pytest.approx(expected, abs=5e-4)


@pytest.mark.parametrize("drift", [0.0, 0.7, 50.0])
def test_friction(drift: float) -> None:
    distance = waveform(3)
    times = distance.period * np.arange(SAMPLES) / SAMPLES
    expected = by_sums(1.5 * np.sign(distance.slope(times) + drift), 6)
    # A sum errs by up to half a sample at each of at most twelve jumps of 3.
    error = 2.0 * 12.0 * 1.5 / SAMPLES
    assert friction_harmonics(distance, drift, 1.5).coefficients == pytest.approx(expected, abs=error)


def differences(
    force: Callable[[PeriodicWaveform], Harmonics], distance: PeriodicWaveform, change: np.ndarray
) -> np.ndarray:
    step = 1e-7
    ahead, behind = (
        force(PeriodicWaveform(distance.coefficients + sign * step * change, OMEGA)).coefficients
        for sign in (1, -1)
    )
    return np.asarray((ahead - behind) / (2.0 * step))


@pytest.mark.parametrize("part", [part for part in PARTS if part.law is not ContactLaw.RELAXING])
def test_derivative_of_contact(part: Play | Stop) -> None:
    distance, change = waveform(4), waveform(5).coefficients
    harmonics = HarmonicContact(part, distance).harmonics()
    derivative = harmonics.direct @ change + harmonics.conjugate @ change.conj()
    numeric = differences(lambda each: HarmonicContact(part, each).harmonics(), distance, change)
    assert derivative == pytest.approx(numeric, abs=1e-6)


def test_derivative_of_friction() -> None:
    distance, change = waveform(4), waveform(5).coefficients
    harmonics = friction_harmonics(distance, 0.3, 2.0)
    derivative = harmonics.direct @ change + harmonics.conjugate @ change.conj()
    numeric = differences(lambda each: friction_harmonics(each, 0.3, 2.0), distance, change)
    assert derivative == pytest.approx(numeric, abs=1e-6)


def test_crossings_that_nearly_meet() -> None:
    for depth in (1e-3, 1e-6, 1e-9):
        touching = PeriodicWaveform(np.array([-1.0 + depth, 1.0 + 0.0j]), OMEGA)
        found = crossings(touching, 0.5, 0.5 + touching.period)
        half = np.arccos(1.0 - depth) / OMEGA
        assert found == pytest.approx([touching.period - half, touching.period + half], rel=1e-9)
    assert len(crossings(PeriodicWaveform(np.array([-1.0 - 1e-9, 1.0 + 0.0j]), OMEGA), 0.5, 0.5 + np.pi)) == 0


def test_all_zeros_between_two_times_are_found() -> None:
    sine = PeriodicWaveform(np.array([0.0, 0.0, 0.0, -1j]), 691.0)  # sin(3 omega t)
    step = np.pi / (3.0 * 691.0)
    found = crossings(sine, 0.4 * step, 7.3 * step)
    assert found == pytest.approx(step * np.arange(1, 8), rel=1e-14)
    assert crossings(sine, 1.1 * step, 1.9 * step).size == 0
    fading = PeriodicWaveform(np.array([0.5, 0.0]), 691.0, Decay(1.0, 100.0, 0.0))
    assert crossings(fading, 0.0, 0.05) == pytest.approx([np.log(2.0) / 100.0], rel=1e-13)
    steep = PeriodicWaveform(np.array([1e-3, 0.0]), 691.0, Decay(1.0, 1e5, 0.0))
    assert crossings(steep, 0.0, 0.05) == pytest.approx([np.log(1e3) / 1e5], rel=1e-12)


@pytest.mark.parametrize("law", list(ContactLaw))
def test_a_stop_that_is_always_in_contact_is_a_spring_and_one_that_never_is_nothing(law: ContactLaw) -> None:
    wave = PeriodicWaveform(np.array([5.0, 1.0 + 0.5j]), 2.0)
    always = HarmonicContact(Stop(BETWEEN, 3.0, 0.1, 0.5, law), wave).harmonics()
    assert always.coefficients == pytest.approx([13.5, (3.0 + 0.2j) * (1.0 + 0.5j)], abs=1e-12)
    assert always.direct[1, 1] == pytest.approx(3.0 + 0.2j)
    inside = PeriodicWaveform(np.array([0.5, 1.0 + 0.5j]), 2.0)
    for part in (Stop(BETWEEN, 3.0, 0.1, 9.0, law), Play(BETWEEN, 3.0, 0.1, 9.0, law)):
        assert not any(each.any() for each in vars(HarmonicContact(part, inside).harmonics()).values())


def test_a_contact_made_where_the_distance_turns_has_a_force_and_no_end_that_jumps() -> None:
    """Of cos 2t, with a stop at 1: nothing but a touch, of which rounding decides."""
    part = Stop(BETWEEN, 0.3, 0.4, 1.0, ContactLaw.PULLING)
    for size in (1.0, 1.0 + 1e-15, 1.0 - 1e-15):
        harmonics = HarmonicContact(part, PeriodicWaveform(np.array([0.0, size + 0j]), 2.0)).harmonics()
        assert abs(harmonics.coefficients).max() < 1e-7
        assert np.isfinite(harmonics.direct).all() and np.isfinite(harmonics.conjugate).all()
