"""A user's own elements: quadrature with an error that can be read, limit cycles without a proof."""

import control
import numpy as np
import pytest
import scipy.special

from tests.quick import quick
from trimmer import ClosedLoop, WrongTypeError, harmonic_balance, limit_cycles, simulate
from trimmer.elements import DeadZone, Element, OwnElement, Preload, Relay, Saturation, StaticElement
from trimmer.errors import UndecidedWarning, UnsupportedElementError, UnsupportedMotionError

PLANT = control.tf([60.0], [1.0, 3.0, 3.0, 1.0])


def saturated(x: np.ndarray) -> np.ndarray:
    return 0.8 * np.clip(x, -0.5, 0.5)


def dead(x: np.ndarray) -> np.ndarray:
    return x - np.clip(x, -0.5, 0.5)


def silent(x: np.ndarray) -> np.ndarray:
    return np.sign(x) * (np.abs(x) > 0.5)


def preloaded(x: np.ndarray) -> np.ndarray:
    return 0.3 * x + 0.7 * np.sign(x)


PAIRS = (
    (saturated, (0.5,), Saturation(0.5, 0.8)),
    (dead, (0.5,), DeadZone(0.5)),
    (silent, (0.5,), Relay(1.0, dead_zone=0.5)),
    (preloaded, (0.0,), Preload(0.7, 0.3)),
)


class Cubic(OwnElement):
    amplitude_scale = 2.0

    def output(self, phase, amplitude, omega):
        return (amplitude * np.sin(phase)) ** 3


class Hysteresis(OwnElement):
    """A relay with the hysteresis 1 whose output is a time constant late."""

    amplitude_scale = 1.0
    depends_on_frequency = True

    def output(self, phase, amplitude, omega):
        if amplitude <= 1.0:
            return np.full(phase.shape, np.nan)
        return np.where(np.mod(phase - self.breaks(amplitude, omega)[0], 2.0 * np.pi) < np.pi, 1.0, -1.0)

    def breaks(self, amplitude, omega):
        return (np.arcsin(1.0 / amplitude) + 0.1 * omega,) if amplitude > 1.0 else ()


@pytest.mark.parametrize(
    ("function", "kinks", "exact"), PAIRS, ids=lambda each: getattr(each, "__name__", "")
)
@pytest.mark.parametrize("named", [True, False], ids=["kinks named", "kinks not named"])
def test_quadrature_is_the_closed_form_within_its_error(function, kinks, exact: Element, named: bool) -> None:
    element = StaticElement(function, scale=0.5, kinks=kinks if named else ())
    for amplitude in (0.3, 0.50001, 0.77, 3.1, 4e4):
        for harmonic in (1, 3, 7):
            estimate = element.describing_function_estimate(amplitude, harmonic=harmonic)
            size = 1.0 + abs(complex(exact.describing_function(amplitude)))
            closed = complex(exact.describing_function(amplitude, harmonic=harmonic))
            # The phase of a kink is as uncertain as the sine is rounded, which counts next to the peak.
            rounding = 4e-16 * size / np.sqrt(1.0 - (0.5 / amplitude) ** 2) if amplitude > 0.5 else 1e-15
            assert abs(estimate.value - closed) <= estimate.error + rounding
            assert estimate.error < 3e-12 * size
            assert element.describing_function(amplitude, harmonic=harmonic) == estimate.value
    assert element.mean_gain(0.77) == pytest.approx(exact.mean_gain(0.77), rel=1e-4)


def test_the_error_tells_what_is_too_rough_to_integrate() -> None:
    """A function with a kink or a jump at every scale: what is left shows in the error."""
    rough = StaticElement(lambda x: x * np.sin(3e5 * np.abs(x)), scale=1.0)
    assert rough.describing_function_estimate(1.0).error > 1e-4


def test_a_sine_has_bessel_functions_for_harmonics() -> None:
    """N_n = 2 J_n(A)/A for y = sin x, by the expansion of Jacobi and Anger."""
    element = StaticElement(np.sin)
    for harmonic in (1, 3, 15):
        exact = 2.0 * scipy.special.jv(harmonic, 7.3) / 7.3
        assert element.describing_function(7.3, harmonic=harmonic) == pytest.approx(exact, abs=1e-14)


def test_an_element_with_memory_that_depends_on_frequency() -> None:
    own, relay = Hysteresis(), Relay(1.0, hysteresis=1.0)
    for omega in (0.2, 3.0):
        exact = relay.describing_function(2.5, harmonic=3) * np.exp(-0.3j * omega)
        assert own.describing_function(2.5, omega, 3) == pytest.approx(exact, rel=1e-12)
        slope = own.derivatives(2.5, omega)
        value = complex(own.describing_function(2.5, omega))
        assert slope.by_log_omega == pytest.approx(-0.1j * omega * value, rel=1e-7)
    assert np.isnan(own.describing_function(0.9, 1.0))
    with pytest.raises(ValueError, match="depends on frequency"):
        own.describing_function(2.0)


@pytest.mark.parametrize(
    ("function", "kinks", "exact"), quick(PAIRS, 1), ids=lambda each: getattr(each, "__name__", "")
)
def test_limit_cycles_are_those_with_the_closed_form_but_not_certain(function, kinks, exact: Element) -> None:
    element = StaticElement(function, scale=0.5, kinks=kinks)
    own, sure = harmonic_balance(PLANT, element), harmonic_balance(PLANT, exact)
    assert sure.certificate.complete
    # Frequencies that agree to rounding leave their order open.
    by_amplitude = (sorted(each.limit_cycles, key=lambda c: c.amplitude) for each in (own, sure))
    pairs = zip(*by_amplitude, strict=True)
    for found, known in pairs:
        assert found.amplitude == pytest.approx(known.amplitude, rel=1e-8)
        assert found.omega == pytest.approx(known.omega, rel=1e-8)
        assert found.stable == known.stable
    assert not own.certificate.complete
    assert not own.success
    assert own.certificate.winding_number is None
    assert (
        "has no bounds of its describing function: amplitudes from 5e-09 to 5e+07"
        in own.certificate.doubts[0]
    )


@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_limit_cycles_warn_that_nothing_is_proven() -> None:
    with pytest.warns(UndecidedWarning, match="has no bounds of its describing function"):
        (cycle,) = limit_cycles(PLANT, Cubic())
    # 0.75 A² = 8/60, the gain at which the loop is marginal.
    assert cycle.amplitude == pytest.approx(np.sqrt(8.0 / 60.0 / 0.75), rel=1e-10)
    assert not cycle.stable


@pytest.mark.slow
def test_limit_cycles_of_an_element_that_depends_on_frequency() -> None:
    class Late(OwnElement):
        amplitude_scale = 1e-3
        depends_on_frequency = True

        def output(self, phase, amplitude, omega):
            return np.clip(amplitude * np.sin(phase - 0.05 * omega), -1e-3, 1e-3)

    balance = harmonic_balance(PLANT, Late(), (0.5, 5.0))
    (cycle,) = balance.limit_cycles
    late = Saturation(1e-3).describing_function(cycle.amplitude) * np.exp(-0.05j * cycle.omega)
    assert late * PLANT(1j * cycle.omega) == pytest.approx(-1.0, abs=1e-8)
    assert balance.certificate.omegas == pytest.approx((0.5, 5.0))
    assert "run away with its mean" in balance.certificate.doubts[1]


def test_an_element_that_is_not_odd_is_refused() -> None:
    for function in (lambda x: x + 0.01 * x**2, lambda x: np.maximum(x, 0.0), lambda x: np.sign(x) + 1e-4):
        with pytest.raises(UnsupportedElementError, match="is not odd at the amplitude"):
            StaticElement(function).describing_function(1.0)
    grid = np.sin(2.0 * np.pi * np.arange(1000) / 1000)

    def odd_on_a_grid(x: np.ndarray) -> np.ndarray:
        """Be odd at 1000 phases of the amplitude 1 that are evenly spaced."""
        return x + 0.1 * (np.abs(np.subtract.outer(x, grid)).min(axis=-1) > 1e-9)

    assert np.all(odd_on_a_grid(grid) == -odd_on_a_grid(-grid))
    with pytest.raises(UnsupportedElementError, match="is not odd at the amplitude 1:"):
        StaticElement(odd_on_a_grid).describing_function(1.0)


def test_there_is_no_motion_in_time() -> None:
    with pytest.raises(
        UnsupportedMotionError, match=r"StaticElement\(saturated, .* known by its output over a period"
    ):
        simulate(ClosedLoop(PLANT, StaticElement(saturated)), 1.0)


def test_what_a_user_writes_wrongly_is_named() -> None:
    with pytest.raises(WrongTypeError, match=r"function must return shape \(\d+,\), not \(\)"):
        StaticElement(lambda x: 1.0).describing_function(1.0)
    with pytest.raises(WrongTypeError, match="function must be"):
        StaticElement(lambda x: "a").describing_function(1.0)

    class Short(Cubic):
        def output(self, phase, amplitude, omega):
            return phase[:3]

    with pytest.raises(WrongTypeError, match=r"output must return shape"):
        Short().describing_function(1.0)
