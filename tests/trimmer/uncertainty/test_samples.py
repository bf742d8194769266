"""Samples of mechanisms, their file, and the command."""

import hashlib
import json
import math
from dataclasses import replace

import control
import numpy as np
import pytest

from tests.trimmer.problem_machines import machine_text
from trimmer import ClosedLoop, MotionKind, Relay, SerialRunner, respond, sample
from trimmer.command_line.mechanisms.sample_text import as_json, distribution_lines
from trimmer.design import Measure, MeasureOfPart, Trial
from trimmer.errors import MapFileError, UncertaintyError
from trimmer.maps.inputs import varied
from trimmer.runners import ProcessRunner
from trimmer.uncertainty import (
    Keeping,
    Plan,
    SampleFile,
    Samples,
    SampleSettings,
    SampleStudy,
    sample_mechanism,
    study_samples,
    uncertainty_from,
)
from trimmer.uncertainty.sample_file import sample_file_of_text

TEXT = """
frequency = 0.2
[bodies]
mass = { mass = 1.0 }
[links]
spring = { between = ["ground", "mass"], stiffness = 4.0, damping = 0.3 }
[stops]
stop = { between = ["ground", "mass"], stiffness = 10.0, gap = 0.4 }
[forces]
drive = { on = "mass", amplitude = 2.0 }
[outputs]
x = { mass = 1 }
[targets]
stroke_at_least = 0.9
[uncertainty]
"stops.stop.gap" = { uniform = [0.3, 0.5] }
"links.spring.stiffness" = { normal = "5 %" }
"""
FILE = sample_file_of_text(TEXT, "stop.toml")
SETTINGS = SampleSettings(count=10, seed=4, most_periods=60)
STROKE = MeasureOfPart(Measure.STROKE, "x")


def sampled(file: SampleFile, settings: SampleSettings, runner=SerialRunner(), **others) -> Samples:  # noqa: B008
    return sample(file.subject, file.uncertainty, settings, targets=file.targets, runner=runner, **others)


@pytest.fixture(scope="module")
def samples():
    return sampled(FILE, SETTINGS)


def test_each_is_what_respond_finds(samples) -> None:
    for trial in samples.trials[:3]:
        found = respond(varied(FILE.mechanism, FILE.uncertainty.places, trial.values))
        assert trial.value(STROKE.measure, "x") == pytest.approx(found.motion.peak_to_peak["x"], rel=1e-8)
        assert trial.period_count == found.period_count


def test_by_its_old_name_it_warns_and_does_the_same(samples) -> None:
    with pytest.warns(DeprecationWarning, match=r"is trimmer\.sample\(file\.subject, .*\) now$") as told:
        old = sample_mechanism(FILE, SETTINGS, runner=SerialRunner(), quiet=True)
    assert told[0].filename == __file__
    assert (old.inputs.settings, old.targets) == (SETTINGS, FILE.targets)
    np.testing.assert_array_equal(old.met, samples.met)


def test_yield_counts_what_meets_the_targets(samples) -> None:
    np.testing.assert_array_equal(samples.met, samples.measured(STROKE) >= 0.9)
    assert sum(samples.kinds.values()) == 10


def test_who_does_them_changes_no_digit(samples) -> None:
    assert sampled(FILE, SETTINGS, runner=ProcessRunner(1, chunk=1)).trials == samples.trials


def test_a_killed_run_goes_on_to_the_same(samples, tmp_path) -> None:
    path = tmp_path / "samples.jsonl"
    assert sampled(FILE, SETTINGS, keeping=Keeping(path)).trials == samples.trials
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(lines[:5]) + lines[5][:20])  # as a killed run leaves it
    resumed = sampled(FILE, SETTINGS, keeping=Keeping(path, resume=True))
    assert resumed.trials == samples.trials
    assert sorted(path.read_bytes().splitlines()) == sorted(line.rstrip() for line in lines)


def test_a_file_of_others_is_kept(tmp_path) -> None:
    path = tmp_path / "samples.jsonl"
    sampled(FILE, SampleSettings(count=2), keeping=Keeping(path))
    with pytest.raises(MapFileError, match="is a file of samples already"):
        sampled(FILE, SampleSettings(count=2), keeping=Keeping(path))
    with pytest.raises(MapFileError, match="other settings"):
        sampled(FILE, SampleSettings(count=3), keeping=Keeping(path, resume=True))
    with pytest.raises(MapFileError, match="cannot be read"):
        sampled(FILE, SampleSettings(count=2), keeping=Keeping(tmp_path / "none", resume=True))


def test_the_header_says_all_that_samples_depend_on(tmp_path) -> None:
    path = tmp_path / "samples.jsonl"
    found = sampled(FILE, SETTINGS, keeping=Keeping(path))
    header = json.loads(path.read_text().splitlines()[0])
    assert header["places"] == ["stops.stop.gap", "links.spring.stiffness"]
    assert header["settings"] == {"count": 10, "plan": "latin-hypercube", "seed": 4, "most_periods": 60}
    content = {key: header[key] for key in ("mechanism", "places", "settings", "asked")}
    told = json.dumps(content, sort_keys=True).encode() + found.inputs.values.tobytes()
    assert header["inputs"] == hashlib.sha256(told).hexdigest()
    values = FILE.uncertainty.values(Plan.LATIN_HYPERCUBE.points(10, 2, 4))
    np.testing.assert_array_equal(found.inputs.values, values)


class Once:
    """A runner that does the last sample first, and counts."""

    def __init__(self) -> None:
        self.done = 0

    def results(self, work, samples):
        for each in reversed(list(samples)):
            self.done += 1
            yield work(each)


def test_what_is_kept_is_not_done_again_unless_it_is_replaced(samples, tmp_path) -> None:
    path = tmp_path / "samples.jsonl"
    resumed, replaced = Keeping(path, resume=True), Keeping(path, overwrite=True)
    for keeping, done in ((Keeping(path), 10), (resumed, 0), (replaced, 10)):
        runner = Once()
        assert sampled(FILE, SETTINGS, runner=runner, keeping=keeping).trials == samples.trials
        assert runner.done == done


def test_what_was_drawn_and_found_is_told(samples) -> None:
    assert samples.message.startswith("10 samples (latin-hypercube, seed 4), each from rest")
    assert "for at most 60 drive periods" in samples.message
    assert "no mechanism can have" not in samples.message
    counts = list(samples.kinds.values())
    assert counts == sorted(counts, reverse=True)
    chaotic = Trial((0.4, 4.0), MotionKind.CHAOTIC, None, samples.trials[0].measures)
    unknown = tuple((each, np.nan) for each, _ in samples.trials[0].measures)
    failed = Trial((0.4, 4.0), None, None, unknown)
    mixed = replace(samples, trials=(failed, chaotic, *samples.trials[:1], chaotic))
    assert next(iter(mixed.kinds.items())) == ("chaotic over 60 drive periods", 2)
    assert (mixed.failed, mixed.kinds["failed"]) == (1, 1)
    assert mixed.message.endswith(" 1 motion could not be followed to its end.")
    np.testing.assert_array_equal(mixed.measured(STROKE)[0], np.nan)
    assert mixed.met.tolist()[0] is False
    told = json.loads(as_json(SampleStudy(mixed, {}, None, math.nan)))["kinds"]
    assert (told["failed"]["count"], told["failed"]["share"]) == (1, 0.25)


def test_what_the_file_only_gives_a_range_of_is_named() -> None:
    text = TEXT.replace("stiffness = 4.0", 'stiffness = "3.9 N/m..4.1 N/m"')
    ranged = sample_file_of_text("\n".join(text.splitlines()[:-1]), "stop.toml")
    found = sampled(ranged, SampleSettings(count=1, most_periods=20))
    assert "Of links.spring.stiffness the file only gives a range" in found.message


def test_numbers_that_scatter_together_have_no_indices() -> None:
    places = '["stops.stop.gap", "links.spring.stiffness"]'
    text = TEXT.split("[uncertainty]")[0]
    text += f"[uncertainty]\ncovariance = {{ places = {places}, matrix = [[1e-4, 1e-4], [1e-4, 1e-2]] }}\n"
    with pytest.raises(UncertaintyError, match="independent numbers"):
        study_samples(sample_file_of_text(text, "stop.toml"), SampleSettings(count=4), indices=True)


def test_impossible_samples_are_refused_or_told() -> None:
    rare = sample_file_of_text(TEXT.replace('"5 %"', '"42 %"'), "stop.toml")
    with pytest.raises(UncertaintyError, match=r"% of the samples are impossible.*must be zero or greater"):
        sampled(rare, SampleSettings(count=99))
    found = sampled(rare, SampleSettings(count=130, most_periods=2))
    assert found.impossible == 1
    assert len(found.trials) == 129
    assert "1 sample that no mechanism can have was left out" in found.message


def test_without_a_drive_it_rests() -> None:
    free = TEXT.replace("frequency = 0.2", "").replace('drive = { on = "mass", amplitude = 2.0 }', "")
    found = sampled(sample_file_of_text(free, "free.toml"), SETTINGS)
    assert found.kinds == {"rest": len(found.trials)}
    assert "for at most 1700 periods of its slowest mode" in found.message
    assert "1700 periods of its slowest mode" in found.message


def test_a_loop_without_a_drive_has_its_limit_cycle() -> None:
    """An integrator with a relay goes to and fro between the edges of its hysteresis, whatever its level."""
    loop = ClosedLoop(control.tf([1], [1, 0]), Relay(1.0, hysteresis=0.1))
    scatters = {"element.hysteresis": {"uniform": [0.05, 0.2]}, "element.level": {"uniform": [0.5, 2.0]}}
    found = sample(loop, uncertainty_from(loop, scatters), replace(SETTINGS, count=8), quiet=True)
    assert found.kinds == {"period 1": 8}
    assert "in each the largest of the stable orbits" in found.message
    for trial in found.trials:
        assert trial.value(Measure.STROKE, "output") == pytest.approx(2 * trial.values[0], rel=1e-9)


def test_samples_of_a_sampled_machine_wait_for_as_much_as_a_map() -> None:
    axis = machine_text("sampled-axis").split("[targets]")[0]
    scatters = '[uncertainty]\n"controllers.axis.ki" = { uniform = [8.0, 12.0] }\n'
    found = sampled(sample_file_of_text(axis + scatters, "axis.toml"), replace(SETTINGS, count=2))
    assert found.kinds == {"rest": 2}
    assert "for at most 960 samples" in found.message


def test_how_many_values_are_finite_is_told() -> None:
    told = "\n".join(distribution_lines([("time", np.array([1.0, math.inf, 2.0, math.nan]), "s")]))
    assert "time, where finite: 2 of 4" in told


def test_indices_find_what_matters() -> None:
    pytest.importorskip("SALib")
    settings = SampleSettings(count=16, most_periods=60)
    study = study_samples(FILE, settings, indices=True, runner=SerialRunner())
    by_name = {quantity.name: found for quantity, found in study.indices.items()}
    assert by_name["peak to peak of x"].indices[0].place == "stops.stop.gap"
    assert by_name["whether the motion repeats with the drive"].blocks == 16
    assert len(study.samples.trials) == 16 * 4


def test_balance_is_near_the_exact_orbits() -> None:
    study = study_samples(FILE, SampleSettings(count=3, most_periods=60), balanced=2, runner=SerialRunner())
    assert len(study.balanced.numbers) == 2
    assert study.balanced.converged.all()
    assert (study.balanced.numbers, study.balanced.harmonics, study.indices) == ((0, 1), 15, {})
    assert study.per_second > 0.0
    assert (study.balanced.distances < 1e-2).all()
