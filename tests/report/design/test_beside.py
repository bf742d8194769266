"""What is met at the point alone: the formula says what comes at other speeds, and as a mass scatters."""

import numpy as np

from report.design.tables.judged import target_rows
from report.design.words.verdict import around_sentence, verdict_sentence
from tests.trimmer.design.made import OSCILLATOR
from trimmer import SerialRunner
from trimmer.design import DesignOutcome, DesignSettings, Study
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.design.trials.surroundings import SPEEDS, Beside
from trimmer.uncertainty import with_uncertainty

WANTED = """
[targets]
stroke_at_least = { block = "10 mm" }
[uncertainty]
"bodies.block.mass" = { uniform = ["0.48 kg", "0.52 kg"] }
"""
SETTINGS = DesignSettings(starts=1, neighbours=3, machines=3, cell_periods=200)


def stroke(frequency: float, mass: float = 0.5) -> float:
    """Return 2 F / |k - m w^2 + i c w|, m."""
    omega = 2 * np.pi * frequency
    return float(14.0 / abs(9e3 - mass * omega**2 + 4j * omega))


def test_a_target_that_is_missed_beside_the_point_is_told_with_the_worst_that_came_out() -> None:
    file = with_uncertainty(design_file_of_text(OSCILLATOR + WANTED, "mine.toml"))
    design = Study(file, SETTINGS, SerialRunner()).short()
    verdict, around, (target,) = design.verdict, design.around, file.targets
    assert (verdict.outcome, verdict.missed, verdict.beside) == (DesignOutcome.MET, (target,), (target,))
    assert around is not None and len(around.beside(Beside.SCATTER)) == SETTINGS.machines
    for condition, trial in around.trials:
        mass = 0.5 + sum(shift for _, shift in condition.shifts)
        assert 0.48 <= mass <= 0.52
        found = trial.value(target.measure, target.part)
        assert abs(found / stroke(20.0 * (1 + condition.speed), mass) - 1) < 1e-6
    assert sorted({condition.speed for condition, _ in around.trials}) == sorted((0.0, *SPEEDS))
    told = verdict_sentence(design).replace("\\", "")
    assert "**The target is met in the file, but not beside it**: at a speed 5 % lower" in told
    assert f"the peak to peak of block is {1e3 * stroke(19.0):.3g} mm" in told
    head, row = target_rows(design)
    assert head[4:] == ["At ±5 % speed", "As numbers scatter", "Verdict"]
    assert row[-1] == "missed beside it"
    assert "at speeds up to 5 % lower and higher, and for 3 machines" in around_sentence(design)
