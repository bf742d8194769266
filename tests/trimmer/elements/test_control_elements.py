"""The nonlinearities of python-control in place of elements, and our elements in place of its own."""

import control
import matplotlib
import numpy as np
import pytest

from tests.quick import quick
from trimmer import FrictionBacklash, OpenLoop, ViscousBacklash, harmonic_balance, harmonic_leakage
from trimmer.elements import ControlElement, Element, Relay, Saturation, ScaledElement, SumOfElements
from trimmer.errors import UnsupportedElementError, WrongTypeError
from trimmer.loops import ClosedLoop

PLANT = control.tf([60.0], [1.0, 3.0, 3.0, 1.0])
PAIRS = (
    (control.saturation_nonlinearity(0.5), Saturation(0.5)),
    (control.relay_hysteresis_nonlinearity(2.0, 0.3), Relay(2.0, 0.3)),
    (control.friction_backlash_nonlinearity(0.4), FrictionBacklash(0.4)),
)


class Cubic(control.descfcn.DescribingFunctionNonlinearity):
    """A static one without a formula."""

    def __call__(self, x):
        return x**3

    def _isstatic(self):
        return True


@pytest.mark.parametrize(("peer", "ours"), quick(PAIRS, 0), ids=lambda each: type(each).__name__)
def test_limit_cycles_are_ours_but_not_certain(peer, ours: Element) -> None:
    before = dict(vars(peer))
    theirs, known = harmonic_balance(PLANT, peer), harmonic_balance(PLANT, ours)
    assert known.certificate.complete
    for found, sure in zip(theirs.limit_cycles, known.limit_cycles, strict=True):
        assert found.amplitude == pytest.approx(sure.amplitude, rel=1e-8)
        assert found.omega == pytest.approx(sure.omega, rel=1e-8)
    certificate = theirs.certificate
    assert not certificate.complete
    assert "has no bounds of its describing function" in certificate.doubts[0]
    assert len(theirs.limit_cycles) == 1
    leakage = harmonic_leakage(PLANT, peer, theirs.limit_cycles[0])
    assert leakage == pytest.approx(harmonic_leakage(PLANT, ours, known.limit_cycles[0]), rel=1e-3)
    assert dict(vars(peer)) == before


@pytest.mark.parametrize(("peer", "ours"), quick(PAIRS, 2), ids=lambda each: type(each).__name__)
def test_every_harmonic_is_that_of_our_closed_form(peer, ours: Element) -> None:
    element = ControlElement(peer)
    for amplitude in (0.33, 0.7, 12.0):
        for harmonic in (1, 3, 9):
            own = element.describing_function(amplitude, harmonic=harmonic)
            assert own == pytest.approx(ours.describing_function(amplitude, harmonic=harmonic), abs=1e-11)
        estimate = element.describing_function_estimate(amplitude)
        assert estimate.value == pytest.approx(ours.describing_function(amplitude), abs=1e-11)
    phases = np.linspace(-7.0, 7.0, 91)
    assert element.waveform(phases, 0.9) == pytest.approx(ours.waveform(phases, 0.9), abs=1e-12)


def test_they_are_taken_wherever_an_element_is() -> None:
    peer = control.saturation_nonlinearity(0.5)
    assert isinstance(ClosedLoop(PLANT, peer).element, ControlElement)
    assert isinstance(ScaledElement(peer, 2.0).element, ControlElement)
    assert SumOfElements((peer, Relay(1.0))).describing_function(1.0) == pytest.approx(
        (Saturation(0.5) + Relay(1.0)).describing_function(1.0)
    )
    for total in (Relay(1.0) + peer, Relay(1.0) - peer):
        assert isinstance(total, SumOfElements)
        assert not total.has_bounds
    assert (
        harmonic_balance(ClosedLoop(PLANT, peer)).limit_cycles == harmonic_balance(PLANT, peer).limit_cycles
    )
    with pytest.raises(WrongTypeError, match="drive"):
        OpenLoop(PLANT, peer, None)  # type: ignore[arg-type]


def test_one_without_a_formula_is_integrated() -> None:
    assert ControlElement(Cubic()).describing_function([2.0, 4.0]) == pytest.approx([3.0, 12.0], rel=1e-12)


@pytest.mark.parametrize("limit", [1e-4, 1.0, 300.0])
def test_its_scale_is_where_its_gain_bends(limit: float) -> None:
    scale = ControlElement(control.saturation_nonlinearity(limit)).amplitude_scale
    assert scale == pytest.approx(limit, rel=0.1)


def test_something_else_is_refused() -> None:
    with pytest.raises(
        WrongTypeError, match=r"nonlinearity must be a control\.DescribingFunctionNonlinearity"
    ):
        ControlElement(3.0)
    with pytest.raises(UnsupportedElementError, match="the class saturation_nonlinearity is not an element"):
        harmonic_balance(PLANT, control.saturation_nonlinearity)


def test_python_control_plots_our_elements() -> None:
    matplotlib.use("agg")
    amplitude, omega = np.linspace(0.6, 20, 40), np.geomspace(0.1, 10, 60)
    plot = control.describing_function_plot(PLANT, FrictionBacklash(1.0), amplitude, omega)
    assert len(plot.lines[1][0].get_xdata()) == 40
    matplotlib.pyplot.close(plot.figure)


def test_a_missing_omega_is_an_error_in_python_control_too() -> None:
    with pytest.raises(ValueError, match=r"depends on frequency: .* freeze it with \.at\(omega\)"):
        control.describing_function(ViscousBacklash(1.0, 0.2), [1.0])
