"""Elements that are known by their output over a period, with scales and frequencies other than 1."""

import math

import control
import numpy as np
import pytest

from trimmer.elements import ControlElement, OwnElement, Relay, Saturation, StaticElement
from trimmer.errors import UnsupportedElementError, WrongTypeError

PLAY, LOOP = control.friction_backlash_nonlinearity(0.4), control.relay_hysteresis_nonlinearity(2.0, 0.3)
CLIPPED = control.saturation_nonlinearity(0.5)


class Late(OwnElement):
    """A cube that is a delay of 2 ms late; there is an output from the amplitude 0.5 on and up to 4 only."""

    amplitude_scale = 0.25
    depends_on_frequency = True

    def output(self, phase, amplitude, omega):
        if not 0.5 <= amplitude <= 4.0:
            return np.full(phase.shape, np.nan)
        return (amplitude * np.sin(phase - 2e-3 * omega)) ** 3


def exact(amplitude: float, omega: float, harmonic: int = 1) -> complex:
    """sin³ θ = (3 sin θ - sin 3θ)/4."""
    return {1: 0.75, 3: -0.25}[harmonic] * amplitude**2 * np.exp(-2e-3j * harmonic * omega)


def of(function) -> object:
    """A static nonlinearity of python-control without a formula."""

    class Peer(control.descfcn.DescribingFunctionNonlinearity):
        def __call__(self, x):
            return function(x)

        def _isstatic(self):
            return True

    return Peer()


def test_an_estimate_is_that_at_its_amplitude_and_frequency() -> None:
    element = Late()
    for harmonic in (1, 3):
        found = element.describing_function_estimate(2.0, 691.0, harmonic)
        assert found.value == pytest.approx(exact(2.0, 691.0, harmonic), rel=1e-12)
        assert 0 < found.error < 1e-9
        assert element.describing_function(2.0, 691.0, harmonic) == found.value
    even = element.describing_function_estimate(2.0, 691.0, 2)
    assert (even.value, even.error) == (0, element.describing_function_estimate(2.0, 691.0).error)
    for harmonic in (1, 2):
        assert np.isnan(element.describing_function_estimate(0.4, 691.0, harmonic).value)
    for amplitude, omega in (([2.0], 691.0), (2.0, [691.0]), (math.inf, 691.0), (math.nan, 691.0)):
        with pytest.raises(ValueError, match="must be one finite number each"):
            element.describing_function_estimate(amplitude, omega)  # type: ignore[arg-type]


def test_values_stand_at_their_places() -> None:
    amplitudes, omegas = np.array([[2.0, math.inf, 0.4], [3.0, math.nan, 1.5]]), np.array([[691.0], [200.0]])
    found = Late().describing_function(amplitudes, omegas)
    assert np.isnan(found).tolist() == [[False, True, True], [False, True, False]]
    expected = [exact(2.0, 691.0), exact(3.0, 200.0), exact(1.5, 200.0)]
    assert found[~np.isnan(found)] == pytest.approx(expected, rel=1e-12)
    phases = np.array([0.3, 2.0, math.nan, 9.0, 0.3])
    given, at = np.array([2.0, 3.0, 2.0, 2.0, 0.4]), np.array([691.0, 691.0, 691.0, 200.0, 691.0])
    output = Late().waveform(phases, given, at)
    assert np.isnan(output).tolist() == [False, False, True, False, True]
    known = [0, 1, 3]
    assert output[known] == pytest.approx(((given * np.sin(phases - 2e-3 * at)) ** 3)[known], rel=1e-10)
    assert np.isnan(Late().waveform(0.3, [2.0, math.nan], [math.nan, 691.0])).all()


def test_derivatives_are_one_sided_where_there_is_no_output_beyond() -> None:
    """N = 3/4 A² exp(-jτω): A dN/dA = 2 N, so dN/du = -2 N A/scale, and dN/d(ln ω) = -jτω N."""
    for amplitude, accuracy in ((2.0, 1e-8), (0.5, 1e-4), (4.0, 1e-4)):
        value, by_u, by_log_omega = Late().expansion(amplitude, 691.0)
        assert value == pytest.approx(exact(amplitude, 691.0), rel=1e-12)
        assert by_u == pytest.approx(-2.0 * value * amplitude / 0.25, rel=accuracy)
        assert by_log_omega == pytest.approx(-2e-3j * 691.0 * value, rel=1e-7)
    assert np.isnan(Late().expansion(0.4, 691.0)).all()


def test_the_mean_slope_of_a_cube_and_bounds_in_any_shape() -> None:
    element = StaticElement(lambda x: x**3, scale=0.5)
    # The mean of 3 x² is 3/2 A².
    assert element.mean_gain([[2.0], [0.3]]) == pytest.approx(np.array([[6.0], [0.135]]), rel=1e-7)
    assert np.isnan(Late().mean_gain([2.0, 3.0])).tolist() == [True, True]
    assert element.derivatives(2.0).by_log_omega == 0
    assert element.domain([1.0, 2.0]).tolist() == [math.inf] * 2
    assert element.sensitivity((0.0, 1.0)) == element.variation((0.0, 1.0)) == (math.inf, math.inf)
    assert (element.amplitude_scale, StaticElement(np.sin).amplitude_scale) == (0.5, 1.0)


@pytest.mark.parametrize(
    ("arguments", "error"),
    [((int,), WrongTypeError), ((np.sin, 0.0), ValueError), ((np.sin, 1.0, 0.3), WrongTypeError)],
)
def test_what_no_static_element_is_made_of(arguments, error) -> None:
    with pytest.raises(error, match=r"^(function|scale|kinks) must be"):
        StaticElement(*arguments)


def test_an_output_gets_phases_of_one_period_and_its_own_breaks() -> None:
    seen = []

    class Seen(Late):
        def output(self, phase, amplitude, omega):
            seen.append((float(phase.min()), float(phase.max()), amplitude, omega))
            return super().output(phase, amplitude, omega)

    assert Seen().waveform([-1.0, 7.0], 2.0, 691.0) == pytest.approx(
        (2.0 * np.sin(np.array([-1.0, 7.0]) - 1.382)) ** 3, rel=1e-10
    )
    assert seen == [(pytest.approx(7.0 - 2 * math.pi), pytest.approx(2 * math.pi - 1.0), 2.0, 691.0)]


@pytest.mark.parametrize("phases", [[0.3], [4.0, 0.3, 2.0], [2.0, 2.0, -1.0, 5.0]])
def test_one_with_memory_runs_through_both_peaks_whatever_is_asked(phases: list[float]) -> None:
    """The play lags by half of its gap, the relay switches at ±0.3; neither begins in its steady motion."""
    for place, value in zip(phases, ControlElement(PLAY).waveform(phases, 0.9).tolist(), strict=True):
        height = 0.9 * math.sin(place)
        rising = math.cos(place) > 0
        expected = max(height - 0.2, -0.7) if rising else min(height + 0.2, 0.7)
        assert value == pytest.approx(expected, abs=1e-12)
    relay = ControlElement(LOOP).waveform(phases, 0.9)
    assert relay.tolist() == Relay(2.0, 0.3).waveform(phases, 0.9).tolist()


def test_only_one_without_memory_passes_the_mean_in_a_known_way() -> None:
    for amplitude in (0.3, 0.7, 4.0):
        found = ControlElement(CLIPPED).mean_gain(amplitude)
        assert found == pytest.approx(Saturation(0.5).mean_gain(amplitude), rel=1e-6)
    assert np.isnan(ControlElement(PLAY).mean_gain([0.7, 0.9])).tolist() == [True, True]


@pytest.mark.parametrize(("factor", "count"), [(1.0, 0), (1.0099, 0), (1.0102, 1), (0.9, 1)])
def test_a_formula_may_be_one_percent_off(factor: float, count: int) -> None:
    class Wrong(control.saturation_nonlinearity):
        def describing_function(self, A):
            return factor * super().describing_function(A)

    element = ControlElement(Wrong(0.5))
    assert len(element.doubts_at(0.7)) == count
    own = Saturation(0.5).describing_function(0.7)
    assert element.describing_function([0.7, math.inf])[0] == pytest.approx(factor * own, rel=1e-12)
    assert np.isnan(element.describing_function(math.inf))
    third = Saturation(0.5).describing_function(0.7, harmonic=3)
    assert element.describing_function(0.7, harmonic=3) == pytest.approx(third, abs=1e-12)
    assert ControlElement(of(np.sin)).doubts_at(0.7) == ()


@pytest.mark.parametrize("fails", [ValueError, ZeroDivisionError])
def test_a_formula_that_fails_below_a_threshold_gives_none_there(fails) -> None:
    class Failing(control.relay_hysteresis_nonlinearity):
        def describing_function(self, A):
            if A < 0.3:
                raise fails("below the threshold")
            return super().describing_function(A)

    element = ControlElement(Failing(2.0, 0.3))
    assert np.isnan(element.describing_function([0.2, 0.9])).tolist() == [True, False]
    assert np.isnan(element.describing_function(0.2, harmonic=3))
    estimate = element.describing_function_estimate(0.2)
    assert np.isnan([estimate.value, estimate.error, estimate.odd]).all()


@pytest.mark.parametrize(("share", "odd"), [(3e-7, True), (3e-6, False), (-3e-6, False)])
def test_an_output_may_be_even_by_a_millionth(share: float, odd: bool) -> None:
    class Even(control.friction_backlash_nonlinearity):
        def __call__(self, x):
            return super().__call__(x) + share * abs(x)

    for peer in (of(lambda x: 5.0 * x + 5.0 * share * abs(x)), Even(1e-9)):
        if odd:
            assert ControlElement(peer).nonlinearity is not peer
        else:
            with pytest.raises(UnsupportedElementError, match="is not odd, at the input"):
                ControlElement(peer)


def odd_on_a_grid(x: float) -> float:
    """Be odd at the phases that python-control samples, at any amplitude that is a power of two."""
    size = 2.0 ** math.floor(math.log2(abs(x))) if x else 1.0
    turns = math.asin(abs(x) / (2.0 * size)) / (2.0 * math.pi) * 100
    return x + (0.1 * abs(x) if abs(turns - round(turns)) > 1e-6 else 0.0)


class Biased(control.relay_hysteresis_nonlinearity):
    def __call__(self, x):
        return super().__call__(x) + 0.01


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(
    "peer",
    [
        of(lambda x: x + 0.1 * abs(x) * (abs(x) < 1e-10)),
        of(lambda x: x + 0.1 * abs(x) * (abs(x) > 1e10)),
        of(odd_on_a_grid),
        of(lambda x: min(max(x, -0.5), 1.0)),
        Biased(1.0, 0.1),
    ],
    ids=["tiny", "huge", "between", "one side", "biased"],
)
def test_what_is_even_at_some_inputs_only_is_refused_too(peer) -> None:
    with pytest.raises(UnsupportedElementError, match="is not odd, at the input"):
        ControlElement(peer)
