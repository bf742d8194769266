import numpy as np
import pytest

from trimmer import CoulombFriction, FrictionBacklash, InertiaBacklash, Relay, ViscousBacklash
from trimmer.elements import DeadZone, Element, Preload, Saturation, ViscousFriction

GAP = 4e-5
OMEGA = 4000.0
GAMMAS = (0.02, 0.5, 1.0, 3.0, 100.0)
ELEMENTS: tuple[Element, ...] = (
    FrictionBacklash(GAP),
    InertiaBacklash(GAP),
    *(ViscousBacklash(GAP, gamma / OMEGA) for gamma in GAMMAS),
    CoulombFriction(3.0),
    Relay(2.0),
    ViscousFriction(0.5),
    2.0 * FrictionBacklash(GAP) - Relay(1e-5),
    Saturation(GAP / 2, 0.5),
    DeadZone(GAP / 2, 0.5),
    Preload(1e-5, 0.25),
    *(Relay(2.0, hysteresis, GAP / 2 - hysteresis) for hysteresis in (GAP / 2, 0.0, GAP / 8, 3 * GAP / 8)),
)
PHASES = np.linspace(0, 2 * np.pi, 40001)[:-1]


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
@pytest.mark.parametrize("amplitude", [2.5e-5, 1e-4])
def test_the_harmonics_are_the_fourier_coefficients_of_the_waveform(
    element: Element, amplitude: float
) -> None:
    output = element.waveform(PHASES, amplitude, OMEGA)
    size = np.abs(output).max() / amplitude
    for harmonic in range(1, 8):
        coefficient = 2j * np.mean(output * np.exp(-1j * harmonic * PHASES)) / amplitude
        value = element.describing_function(amplitude, OMEGA, harmonic)
        assert abs(value - coefficient) < 2e-4 * size


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
def test_the_output_is_odd_and_periodic(element: Element) -> None:
    phases = PHASES + 1e-4
    output = element.waveform(phases, 6e-5, OMEGA)
    half_a_period_later = element.waveform(phases + np.pi, 6e-5, OMEGA)
    three_periods_earlier = element.waveform(phases - 6 * np.pi, 6e-5, OMEGA)
    size = np.abs(output).max()
    assert np.abs(half_a_period_later + output).max() < 1e-9 * size
    assert np.abs(three_periods_earlier - output).max() < 1e-9 * size


@pytest.mark.parametrize("element", ELEMENTS[:7], ids=repr)
@pytest.mark.parametrize("amplitude", [2.1e-5, 4e-5, 4e-2])
def test_the_load_stays_within_the_gap_and_never_jumps(element: Element, amplitude: float) -> None:
    output = element.waveform(PHASES, amplitude, OMEGA)
    play = output - amplitude * np.sin(PHASES)
    assert np.abs(play).max() <= GAP / 2 * (1 + 1e-9) + 1e-15 * amplitude
    assert np.abs(np.diff(output, append=output[:1])).max() < 1.01 * amplitude * (PHASES[1] - PHASES[0])


def test_outside_the_domain_there_is_no_waveform() -> None:
    assert np.isnan(FrictionBacklash(GAP).waveform(0.0, GAP / 2))
    assert np.isnan(ViscousBacklash(GAP, 1.0).waveform([0.0, 2.0], GAP / 4, 1.0)).all()
