"""Pictures of harmonic balance, elements, orbits and identified loads: axes show what was computed."""

import control
import pytest

import trimmer
from tests.trimmer.drawing.pictures import VISCOUS, new_axes, points
from trimmer import HarmonicBalance


@pytest.mark.parametrize(
    ("draw", "told"),
    [
        (HarmonicBalance((), None).plot, "no loop"),
        (VISCOUS.plot, "depends on frequency"),
        (VISCOUS.plot_locus, "depends on frequency"),
    ],
)
def test_what_cannot_be_drawn_says_what_it_lacks(draw, told: str) -> None:
    with pytest.raises(ValueError, match=told):
        draw(new_axes())


@pytest.mark.parametrize("damping", [1e-3, 1e-5])
def test_a_sharp_resonance_is_met(damping: float) -> None:
    system = control.tf([1], [1, 2 * damping, 1])
    axes = trimmer.harmonic_balance(system, trimmer.FrictionBacklash(1.0)).plot(new_axes())
    curve = points(axes, "G(jω)") @ [1, 1j]
    assert abs(curve).max() == pytest.approx(0.5 / damping, rel=0.02)
