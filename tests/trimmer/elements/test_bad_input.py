import math
from collections.abc import Callable

import numpy as np
import pytest

from trimmer import (
    CoulombFriction,
    DeadZone,
    FrictionBacklash,
    InertiaBacklash,
    Preload,
    ViscousBacklash,
    ViscousFriction,
)
from trimmer.elements import Element, ElementAtFrequency, Relay, Saturation, ScaledElement, SumOfElements

ELEMENTS: tuple[Element, ...] = (
    FrictionBacklash(1.0),
    InertiaBacklash(1.0),
    ViscousBacklash(1.0, 1.0),
    CoulombFriction(1.0),
    Relay(1.0),
    ViscousFriction(1.0),
    FrictionBacklash(1.0) + Relay(1.0),
    2.0 * FrictionBacklash(1.0),
    FrictionBacklash(1.0).at(1.0),
    Saturation(0.8),
    DeadZone(0.8),
    Preload(1.0, 1.0),
    Relay(1.0, hysteresis=0.8),
    Relay(1.0, hysteresis=0.2, dead_zone=0.6),
)
BUILDERS: dict[str, Callable[[float], Element]] = {
    "gap": FrictionBacklash,
    "force": CoulombFriction,
    "level": Relay,
    "damping": ViscousFriction,
    "threshold": Saturation,
    "slope": lambda slope: DeadZone(1.0, slope),
    "slope ": lambda slope: Preload(1.0, slope),
    "level ": lambda level: Preload(level, 1.0),
    "gap ": InertiaBacklash,
    "gap  ": lambda gap: ViscousBacklash(gap, 1.0),
    "omega": lambda omega: ElementAtFrequency(Relay(1.0), omega),
}


@pytest.mark.parametrize("field", BUILDERS)
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_a_field_must_be_positive_and_finite(field: str, value: float) -> None:
    with pytest.raises(
        ValueError, match=rf"^{field.strip()} must be positive and finite \(.*\), not {value}$"
    ):
        BUILDERS[field](value)


@pytest.mark.parametrize("value", [-1e-9, -math.inf, math.nan])
def test_a_time_constant_must_not_be_negative(value: float) -> None:
    with pytest.raises(
        ValueError, match=rf"time_constant must be zero, positive or infinite \(s\), not {value}$"
    ):
        ViscousBacklash(1.0, value)


@pytest.mark.parametrize("field", ["hysteresis", "dead_zone"])
@pytest.mark.parametrize("value", [-1e-9, math.nan, math.inf])
def test_a_threshold_of_a_relay_is_not_negative(field: str, value: float) -> None:
    with pytest.raises(ValueError, match=rf"^{field} must (not be negative|be finite)"):
        Relay(1.0, **{field: value})


@pytest.mark.parametrize("value", [0.0, math.nan, math.inf])
def test_a_factor_must_be_finite_and_not_zero(value: float) -> None:
    with pytest.raises(ValueError, match="factor must be finite and not zero"):
        ScaledElement(Relay(1.0), value)


def test_a_sum_needs_a_term() -> None:
    with pytest.raises(ValueError, match="at least one element"):
        SumOfElements(())


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
class TestArguments:
    def test_amplitudes_must_be_positive(self, element: Element) -> None:
        for amplitude in (0.0, -1.0, [1.0, -2.0]):
            for method in (element.describing_function, element.derivatives):
                with pytest.raises(ValueError, match=r"amplitude must be positive .*, not -?[012]\.0$"):
                    method(amplitude, 1.0)
            with pytest.raises(ValueError, match="amplitude must be positive"):
                element.waveform(0.0, amplitude, 1.0)

    def test_omega_must_be_positive_and_finite(self, element: Element) -> None:
        for omega in (0.0, -1.0, math.inf):
            with pytest.raises(ValueError, match=r"omega must be (positive|finite)"):
                element.describing_function(1.0, omega)
            with pytest.raises(ValueError, match=r"omega must be (positive|finite)"):
                element.domain(omega)

    def test_harmonics_are_counted_from_one(self, element: Element) -> None:
        for harmonic in (0, -1, 1.0, 1.5, True, "1", None):
            with pytest.raises(ValueError, match="harmonic must be a whole number from 1 on"):
                element.describing_function(1.0, 1.0, harmonic)

    def test_nan_in_gives_nan_out(self, element: Element) -> None:
        for harmonic in (1, 2, 3):
            values = element.describing_function([math.nan, 1.0, 1.0], [1.0, math.nan, 1.0], harmonic)
            assert np.isnan(values).tolist() == [True, True, False]
        output = element.waveform([math.nan, 0.5, 0.5], [1.0, math.nan, 1.0], 1.0)
        assert np.isnan(output).tolist() == [True, True, False]

    def test_a_waveform_needs_a_finite_amplitude(self, element: Element) -> None:
        with pytest.raises(ValueError, match="amplitude must be finite"):
            element.waveform(0.0, math.inf, 1.0)

    def test_any_harmonic_number_of_numpy_will_do(self, element: Element) -> None:
        for harmonic in np.arange(1, 4):
            value = element.describing_function(1.0, 1.0, harmonic)
            assert value == element.describing_function(1.0, 1.0, int(harmonic))


@pytest.mark.parametrize("element", [ViscousBacklash(1.0, 1.0), ViscousFriction(1.0)], ids=repr)
def test_omega_is_asked_for_where_it_counts(element: Element) -> None:
    for total in (element, -element, element + Relay(1.0)):
        for call in (
            lambda total=total: total.describing_function(1.0),
            lambda total=total: total.waveform(0.0, 1.0),
            lambda total=total: total.derivatives(1.0),
            total.domain,
            lambda total=total: total.sensitivity((0.1, 0.2)),
            lambda total=total: total.variation((0.1, 0.2)),
        ):
            with pytest.raises(ValueError, match=r"depends on frequency: give omega \(rad/s\)"):
                call()


@pytest.mark.parametrize("amplitude", [None, "1", 1j, [1.0, None], True])
def test_an_amplitude_that_is_no_real_number_is_refused(amplitude: object) -> None:
    with pytest.raises(ValueError, match=r"^amplitude must be a real number or an array of such"):
        FrictionBacklash(1.0).describing_function(amplitude)  # type: ignore[arg-type]
