"""What is asked, told and left out of samples, with work that is given."""

from __future__ import annotations

import hashlib
import importlib
import json
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.design.made import oscillator
from trimmer import TrimmerParameters
from trimmer.errors import MapFileError, UncertaintyError
from trimmer.uncertainty import loop_samples, samples, study
from trimmer.uncertainty.distributions import Joint, Normal, Scatter, Uncertainty, Uniform
from trimmer.uncertainty.indices import Indices, _salib, indices_of, saltelli_points
from trimmer.uncertainty.kept import NOWHERE, Keeping, begin, header, resumed
from trimmer.uncertainty.loop_samples import LoopFile, LoopNumbers, LoopSamples, sample_loop
from trimmer.uncertainty.points import EDGE, Plan, within_cube
from trimmer.uncertainty.sample_file import SampleFile
from trimmer.uncertainty.samples import SampleInputs, SampleSettings, trials_of
from trimmer.uncertainty.statistics import share_of
from trimmer.uncertainty.study import study_samples, warm_up

SCATTERS = (
    Scatter("bodies.block.mass", "kg", Uniform(0.4, 0.6)),
    Scatter("links.spring.stiffness", "N/m", Normal(9e3, 100.0)),
)
TOGETHER = Joint(("bodies.block.mass", "links.spring.stiffness"), ((0.01, 1.0), (1.0, 1e4)))


def test_numbers_that_scatter_together_are_no_base_of_indices() -> None:
    uncertainty = Uncertainty(SCATTERS, (TOGETHER,))
    assert not uncertainty.independent
    assert Uncertainty(SCATTERS, (Joint(TOGETHER.places, ((0.01, 0.0), (0.0, 1e4))),)).independent
    file = SampleFile(oscillator(), (), uncertainty)
    with pytest.raises(UncertaintyError, match="independent numbers"):
        study_samples(file, SampleSettings(count=4), indices=True, quiet=True)
    loop = LoopFile(LoopNumbers(TrimmerParameters.thesis(), 4e-5), uncertainty)
    with pytest.raises(UncertaintyError, match="independent numbers"):
        sample_loop(loop, SampleSettings(count=4), indices=True)


def test_values_have_a_column_for_each_number() -> None:
    shares = np.array([[0.5, 0.5], [0.25, 0.8413447460685429], [0.75, 0.15865525393145707]])
    values = Uncertainty(SCATTERS).values(shares)
    np.testing.assert_allclose(values, [[0.5, 9e3], [0.45, 9.1e3], [0.55, 8.9e3]])
    both = Uncertainty(SCATTERS, (TOGETHER,)).values(np.array([[0.5, 0.5], [0.9, 0.2]]))
    np.testing.assert_allclose(both[0], [0.5, 9e3])
    nothing = Uncertainty(())
    given = np.zeros((3, 0))
    assert nothing.values(given).shape == (3, 0)
    assert nothing.values(given) is not given


def test_the_same_negative_value_everywhere_has_no_indices() -> None:
    for values, used in ((np.full(8, -1.0), 2), (np.full(8, -1.0) + 1e-13 * np.arange(8), 2)):
        assert indices_of(values, ("a", "b"), 0) == Indices((), used, 2)
    assert indices_of(np.full(8, np.nan), ("a", "b"), 0) == Indices((), 0, 2)


def test_without_salib_it_is_told_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> None:
        assert name == "SALib.sample.sobol"
        raise ImportError(name)

    monkeypatch.setattr(importlib, "import_module", missing)
    with pytest.raises(UncertaintyError, match=r"pip install 'trimmer\[sensitivity\]'"):
        _salib("sample")
    with pytest.raises(UncertaintyError, match="SALib"):
        saltelli_points(2, 8, 0)


def inputs(values: np.ndarray, possible: list[bool]) -> SampleInputs:
    return SampleInputs(oscillator(), Uncertainty(SCATTERS), SampleSettings(), values, np.array(possible))


def test_the_digest_is_that_of_what_the_header_says_and_of_the_values() -> None:
    values = np.array([[0.45, 9e3], [0.55, 9.1e3]])
    found = header(inputs(values, [True, True]))
    kept = {key: found[key] for key in ("mechanism", "places", "settings", "asked")}
    told = json.dumps(kept, sort_keys=True).encode() + values.tobytes()
    assert found["inputs"] == hashlib.sha256(told).hexdigest()
    assert kept["mechanism"] == oscillator().to_toml()
    assert Keeping(None, False, False) == NOWHERE


def test_where_nothing_is_left_nobody_is_asked() -> None:
    runner: Any = SimpleNamespace()
    assert trials_of(inputs(np.ones((2, 2)), [False, False]), runner) == ()


def test_a_share_of_nothing_may_be_anything() -> None:
    found = share_of(0, 0)
    assert (found.count, found.total, found.lowest, found.highest) == (0, 0, 0.0, 1.0)


def test_points_keep_off_the_faces_of_the_cube() -> None:
    edge = 2.0**-40
    assert edge == EDGE
    assert within_cube(np.array([0.0, 0.3, 1.0])).tolist() == [edge, 0.3, 1.0 - edge]
    assert [Plan.SOBOL.count(each) for each in (1, 2, 3, 512, 513)] == [1, 2, 4, 512, 1024]
    assert Plan.LATIN_HYPERCUBE.count(513) == 513


def test_a_motion_is_followed_before_the_clock_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    done: list = []
    file = SampleFile(oscillator(), (), Uncertainty(SCATTERS))
    monkeypatch.setattr(study, "TrialWork", lambda *given: lambda values: done.append((*given, values)))
    warm_up(file)
    assert done == [(file.mechanism, (), (), 2, ())]
    clock = iter([10.0, 14.0])
    monkeypatch.setattr(study, "warm_up", lambda file: done.append("warm"))
    monkeypatch.setattr(study.time, "perf_counter", lambda: done.append("clock") or next(clock))
    done_samples = SimpleNamespace(trials=(1, 2, 3))
    monkeypatch.setattr(study, "sample_mechanism", lambda *given, **options: done_samples)
    monkeypatch.setattr(study, "balanced_samples", lambda samples, count: (samples, count))
    found = study_samples(file, SampleSettings(count=4), balanced=7)
    assert done[1:] == ["warm", "clock", "clock"]
    assert (found.per_second, found.balanced) == (0.75, (done_samples, 7))


def test_a_loop_tells_how_many_samples_it_did_in_a_second(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = iter([10.0, 14.0])
    monkeypatch.setattr(loop_samples.time, "perf_counter", lambda: next(clock))
    cycles = SimpleNamespace(count=np.zeros(6), message="Told.")
    asked: list = []
    monkeypatch.setattr(
        loop_samples,
        "_limit_cycles",
        lambda file, values, *given: asked.append((len(values), *given)) or cycles,
    )
    scatters = (Scatter("k2", "N/m", Normal(1e4, 1.0)), Scatter("gap", "m", Normal(4e-5, 1e-6)))
    file = LoopFile(LoopNumbers(TrimmerParameters.thesis(), 4e-5), Uncertainty(scatters))
    found = sample_loop(file, SampleSettings(count=6, seed=3), output="out", channels="in")
    assert asked == [(6, "out", "in")]
    assert (found.per_second, found.found, found.indices) == (1.5, cycles, {})
    assert (found.values.shape, found.possible.all()) == ((6, 2), True)
    np.testing.assert_array_equal(found.values, file.uncertainty.values(Plan.LATIN_HYPERCUBE.points(6, 2, 3)))
    assert found.message == "6 samples (latin-hypercube, seed 3). Told."
    some = LoopSamples(file, found.settings, found.values, np.arange(6) > 1, cycles, {}, 1.5)
    assert some.message == (
        "6 samples (latin-hypercube, seed 3). 2 samples that no trimmer can have were left out. Told."
    )


def test_one_block_of_samples_is_a_power_of_two_and_small_values_have_indices(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked: list = []

    def sample(problem: dict[str, Any], blocks: int, **options: Any) -> np.ndarray:
        asked.append((problem["num_vars"], blocks, options))
        return np.full((blocks * 4, 2), 0.5)

    def analyze(problem: dict[str, Any], values: np.ndarray, **options: Any) -> dict[str, list[float]]:
        return {key: [0.1, 0.2] for key in ("S1", "ST", "S1_conf", "ST_conf")}

    salib = SimpleNamespace(sample=sample, analyze=analyze)
    monkeypatch.setattr("trimmer.uncertainty.indices._salib", lambda part: salib)
    for blocks in (1, 2, 8):
        assert saltelli_points(2, blocks, 5).shape == (4 * blocks, 2)
        assert asked[-1] == (2, blocks, {"calc_second_order": False, "seed": 5})
    for blocks in (3, 5, 6, 7, 9, 12):
        with pytest.raises(UncertaintyError, match=f"{blocks} blocks of samples"):
            saltelli_points(2, blocks, 5)
    for spread, count in ((5e-15, 2), (5e-16, 0)):
        found = indices_of(1e-3 + spread * np.arange(8) / 7, ("a", "b"), 0)
        assert len(found.indices) == count


def test_a_file_is_begun_once_and_a_damaged_one_is_not_gone_on_with(tmp_path) -> None:
    made, path = inputs(np.array([[0.45, 9e3], [0.55, 9.1e3]]), [True, True]), tmp_path / "samples.jsonl"
    begin(path, made)
    with pytest.raises(MapFileError, match="is a file of samples already"):
        begin(path, made)
    begin(path, made, overwrite=True)
    line = {"number": 1, "kind": "periodic", "period_count": 1, "measures": []}
    with path.open("a") as file:
        file.write(json.dumps(line) + "\n")
    found = resumed(path, made, ())
    assert list(found) == [1]
    assert (found[1].values, found[1].period_count) == ((0.55, 9.1e3), 1)
    for change in (
        {"number": 2},
        {"number": "a"},
        {"kind": "nonsense"},
        {"measures": [1.0]},
        {"measures": 3},
    ):
        begin(path, made, overwrite=True)
        with path.open("a") as file:
            file.write(json.dumps(line | change) + "\n" + json.dumps(line) + "\n")
        with pytest.raises(MapFileError, match="line 2"):
            resumed(path, made, ())


def test_samples_are_512_with_a_progress_bar_unless_it_is_said_otherwise(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked: list = []
    file = SampleFile(oscillator(), (), Uncertainty(SCATTERS))

    def trials(made: SampleInputs, runner: object, keeping: Keeping, *, quiet: bool) -> tuple:
        asked.append((len(made.values), made.settings, runner, keeping, quiet))
        return ()

    monkeypatch.setattr(samples, "trials_of", trials)
    monkeypatch.setattr(samples, "_reason_against", lambda *given: "")
    found = samples.sample_mechanism(file)
    assert (found.trials, found.targets) == ((), ())
    plan = SampleSettings(512, Plan.LATIN_HYPERCUBE, 0, 300)
    assert asked == [(512, plan, None, NOWHERE, False)]
    keeping = Keeping(overwrite=True)
    samples.sample_mechanism(file, SampleSettings(4), runner="runner", keeping=keeping, quiet=True)
    assert asked[1] == (4, SampleSettings(4), "runner", keeping, True)
