"""A design looks at outputs of velocity, acceleration and force as at displacements."""

import numpy as np
import pytest

from tests.trimmer.design.made import OSCILLATOR
from trimmer import MechanismError, SerialRunner
from trimmer.design import DesignOutcome, DesignSettings, Study
from trimmer.design.specification.design_file import design_file_of_text

OTHERS = """
speed = { velocity = { block = 1 } }
shock = { acceleration = { block = 1 } }
push = { force = "spring" }
"""
OMEGA = 2 * np.pi * 20
AMPLITUDE = 7.0 / abs(9e3 - 0.5 * OMEGA**2 + 4j * OMEGA)
SWINGS = {
    "block": (2 * AMPLITUDE, "m"),
    "double": (4 * AMPLITUDE, "m"),
    "speed": (2 * OMEGA * AMPLITUDE, "m/s"),
    "shock": (2 * OMEGA**2 * AMPLITUDE, "m/s²"),
    "push": (2 * abs(9e3 + 4j * OMEGA) * AMPLITUDE, "N"),
}
"""Peak to peak of each output: of x, -2 x, x', x'' and k x + c x'."""
SETTINGS = DesignSettings(starts=1, neighbours=3, cell_periods=400)


def test_each_output_is_measured_and_bounded_in_its_own_unit() -> None:
    targets = "[targets]\npeak_to_peak_at_most = { push = '80 N', shock = '200 m/s²', speed = '2 m/s' }\n"
    file = design_file_of_text(OSCILLATOR + OTHERS + targets, "mine.toml")
    design = Study(file, SETTINGS, SerialRunner()).short()
    assert design.motion is not None
    for name, (swing, unit) in SWINGS.items():
        assert design.motion.outputs[name].peak_to_peak == pytest.approx(swing, rel=1e-9)
        assert design.spectra[name].unit == unit
        assert design.spectra[name].lines[0].amplitude == pytest.approx(swing / 2, rel=1e-9)
    judged = {each.target.part: each for each in design.verdict.judged}
    assert {name: each.target.unit for name, each in judged.items()} == {
        name: SWINGS[name][1] for name in ("push", "shock", "speed")
    }
    for each in judged.values():
        assert each.value == pytest.approx(SWINGS[each.target.part][0], rel=1e-9)
        assert each.met == (each.value <= each.target.bound)
    assert design.verdict.outcome is DesignOutcome.MISSED
    assert [name for name, each in judged.items() if not each.met] == ["push"]


def test_a_number_alone_bounds_displacements() -> None:
    file = design_file_of_text(OSCILLATOR + OTHERS + "[targets]\nstroke_at_least = '1 mm'\n", "mine.toml")
    assert [each.part for each in file.targets] == ["block", "double"]


@pytest.mark.parametrize(
    ("target", "sentence"),
    [
        (
            "peak_to_peak_at_most = 3",
            "= 3: no output is a displacement, so say which one this bounds; there is p",
        ),
        ("peak_to_peak_at_most = { push = '3 mm' }", "targets.peak_to_peak_at_most.push = '3 mm': "),
        ("stroke_at_least = { pushed = 3 }", "there is no output 'pushed'; did you mean push?"),
    ],
)
def test_what_cannot_be_bounded_is_refused(target: str, sentence: str) -> None:
    head = OSCILLATOR.split("[outputs]")[0]
    text = f"{head}[outputs]\npush = {{ force = 'spring' }}\n[targets]\n{target}\n"
    with pytest.raises(MechanismError) as error:
        design_file_of_text(text, "mine.toml")
    assert sentence in str(error.value)
