"""Samples of the thesis's loop."""

from dataclasses import replace

import numpy as np
import pytest

from trimmer import FrictionBacklash, TrimmerParameters, limit_cycles, pin_model
from trimmer.ensembles import SampledLimitCycles
from trimmer.errors import UncertaintyError
from trimmer.thesis import ParameterError
from trimmer.uncertainty import (
    LimitCycleSamples,
    Plan,
    SampleSettings,
    read_parameter_sample_file,
    sample_limit_cycles,
)

GAP = 4e-5


def written(path, lines: str):
    path.write_text(f"{TrimmerParameters.thesis().to_toml()}\n[uncertainty]\n{lines}\n", encoding="utf-8")
    return path


@pytest.fixture
def path(tmp_path):
    lines = 'k2 = { normal = "5 %" }\nc2 = { uniform = "5 %" }\ngap = { normal = "5 um" }'
    return written(tmp_path / "series.toml", lines)


def test_the_table_is_none_of_the_parameters(path) -> None:
    assert TrimmerParameters.from_toml(path) == TrimmerParameters.thesis()


def test_each_sample_has_its_own_limit_cycles(path) -> None:
    samples = sample_limit_cycles(read_parameter_sample_file(path, GAP), SampleSettings(count=30, seed=2))
    amplitude, frequency = samples.largest
    for row in range(4):
        values = dict(zip(samples.file.uncertainty.places, samples.values[row].tolist(), strict=True))
        element = FrictionBacklash(values.pop("gap"))
        changed = TrimmerParameters(**{**vars(TrimmerParameters.thesis()), **values})
        largest = max(
            (c for c in limit_cycles(pin_model(changed), element) if c.stable), key=lambda c: c.amplitude
        )
        assert amplitude[row] == pytest.approx(largest.amplitude, rel=1e-8)
        assert frequency[row] == pytest.approx(largest.frequency, rel=1e-8)


def test_the_largest_is_sought_among_the_stable_ones(path) -> None:
    amplitude, omega = np.array([[1.0, 2.0, 3.0], [1.0, 2.0, np.nan]]), 2.0 * np.pi * np.ones((2, 3))
    stable, nothing = np.array([[True, True, False], [False, False, False]]), np.zeros(2, dtype=bool)
    found = SampledLimitCycles(amplitude, omega, stable, np.array([3, 2]), nothing, nothing)
    made = sample_limit_cycles(read_parameter_sample_file(path, GAP), SampleSettings(count=2))
    sizes, frequencies = replace(made, found=found).largest
    np.testing.assert_array_equal(sizes, [2.0, np.nan])
    np.testing.assert_array_equal(frequencies, [1.0, np.nan])


def test_what_no_trimmer_can_have_is_left_out_and_told(tmp_path) -> None:
    """A mass must be positive; at most 1 % of the samples may have none."""
    file = read_parameter_sample_file(written(tmp_path / "series.toml", 'm2 = { normal = "39 %" }'), GAP)
    samples: LimitCycleSamples = sample_limit_cycles(file, SampleSettings(count=300, seed=3))
    left = int((samples.values <= 0.0).sum())
    assert 1 <= left <= 3
    np.testing.assert_array_equal(samples.possible, samples.values[:, 0] > 0.0)
    assert len(samples.largest[0]) == 300 - left
    many, were = ("1 sample", "was") if left == 1 else (f"{left} samples", "were")
    told = f"300 samples (latin-hypercube, seed 3). {many} that no trimmer can have {were} left out. "
    assert samples.message.startswith(told)
    assert samples.per_second > 0.0


def test_existence_and_size_have_indices_apart(path) -> None:
    pytest.importorskip("SALib")
    file = read_parameter_sample_file(path, GAP)
    samples = sample_limit_cycles(file, SampleSettings(count=256), indices=True)
    assert samples.indices["whether there is a stable limit cycle"].indices == ()
    # The amplitude is as many times larger as the gap, which scatters most.
    assert samples.indices["its amplitude"].indices[0].place == "gap"
    gap = {each.place: each for each in samples.indices["its frequency"].indices}["gap"]
    assert gap.total == pytest.approx(0.0, abs=1e-9)
    assert samples.settings.plan is Plan.SOBOL


@pytest.mark.parametrize(
    ("lines", "error", "told"),
    [
        ("", ParameterError, "nothing scatters"),
        ('m9 = { normal = "5 %" }', ParameterError, "there is no number 'm9'"),
        ('m2 = { normal = "5 Hz" }', ParameterError, "line 2[0-9]: uncertainty.m2"),
        ('m2 = { normal = "80 %" }', UncertaintyError, "most of them as m2 would be"),
    ],
)
def test_what_cannot_be_used_is_named(tmp_path, lines: str, error: type[Exception], told: str) -> None:
    with pytest.raises(error, match=told):
        sample_limit_cycles(
            read_parameter_sample_file(written(tmp_path / "series.toml", lines), GAP),
            SampleSettings(count=200),
        )
