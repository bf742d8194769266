"""Damaged files end with a result or one sentence that names the file, whoever reads them."""

import io
import json
import os
import wave
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from report.copy.reading import read_reader_copy
from report.judging.changes import read_claims
from tests.damage import damaged, damaged_data
from tests.quick import examples
from tests.trimmer.maps.machines import impact_oscillator
from trimmer import Mechanism, TrimmerError, TrimmerParameters, coexisting_motions, motion_map, read_signal
from trimmer.command_line.main import main
from trimmer.design import read_design_file
from trimmer.runners import SerialRunner
from trimmer.signals import read_wav
from trimmer.uncertainty import read_parameter_sample_file, read_sample_file

EXAMPLES = Path(__file__).parents[2] / "examples"
TWIN = (EXAMPLES / "thesis-play.toml").read_bytes()
SCATTER = (EXAMPLES / "scatter.toml").read_bytes()
PARAMETERS = TrimmerParameters.thesis().to_toml().encode()
SPREAD = PARAMETERS + b'\n[uncertainty]\nm1 = { normal = "2 %" }\ngap = { uniform = "10 %" }\n'
RECORD = b"time [s],x [m]\n" + b"".join(b"%.4f,%.6f\n" % (at / 1000, at % 7 / 1e3) for at in range(40))
CLAIM = {"id": "eq-2.8", "section": "2.1", "verdict": "reproduced", "severity": "none", "printed": "1"}
CLAIMS = json.dumps(
    {"schema": 2, "claims": [{**CLAIM, "derived": "1", "explanation": ""}]}, indent=1
).encode()
TEXT = "Chapter 1\nIt moves \N{GREEK SMALL LETTER OMEGA}.\n".encode() * 5
NUMBERS = {"frequency": [1.0, 1.05], "stops.wall.gap": [8.0, 10.0]}


def sound() -> bytes:
    held = io.BytesIO()
    with wave.open(held, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(1000)
        file.writeframes(bytes(range(200)))
    return held.getvalue()


READERS = {
    "mechanism": (TWIN, Mechanism.from_toml),
    "design": (SCATTER, read_design_file),
    "scatter": (SCATTER, read_sample_file),
    "parameters": (PARAMETERS, TrimmerParameters.from_toml),
    "loop": (SPREAD, lambda path: read_parameter_sample_file(path, 4e-5)),
    "record": (RECORD, read_signal),
    "sound": (sound(), read_wav),
    "claims": (CLAIMS, read_claims),
    "text copy": (TEXT, lambda path: read_reader_copy(path, "", accept_other=True)),
}


def told(path: Path, read: Callable[[Path], object]) -> None:
    try:
        read(path)
    except TrimmerError as error:
        assert str(path) in str(error)
        assert len(str(error)) < 3000


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", READERS)
def test_a_damaged_file_is_told_in_a_sentence(tmp_path: Path, name: str) -> None:
    valid, read = READERS[name]
    path = tmp_path / "damaged"
    path.write_bytes(valid)
    read(path)  # or else nothing would be shown

    @given(damaged(valid))
    def check(content: bytes) -> None:
        path.write_bytes(content)
        told(path, read)

    check()


SERIAL = {"most_periods": 40, "runner": SerialRunner()}
SAMPLE = ["sample", str(EXAMPLES / "scatter.toml"), "--count", "3", "--periods", "5", "--jobs", "1"]
OF_MAP = ["map", str(EXAMPLES / "den-hartog.toml"), "--vary", "frequency=0.1:0.12:2", "--jobs", "1"]


@pytest.fixture(scope="module")
def map_lines(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    path = tmp_path_factory.mktemp("map") / "map.jsonl"
    motion_map(impact_oscillator(), NUMBERS, file=path, **SERIAL)
    return path.read_text("utf-8").splitlines()


@pytest.fixture(scope="module")
def sample_lines(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    path = tmp_path_factory.mktemp("samples") / "samples.jsonl"
    assert main([*SAMPLE, "--output", str(path), "--quiet"]) == 0
    return path.read_text("utf-8").splitlines()


def one_damaged(draw: Callable[[st.SearchStrategy], Any], lines: list[str], path: Path) -> None:
    """Write lines of JSON with one of them damaged."""
    at = draw(st.integers(0, len(lines) - 1))
    line = draw(damaged_data(json.loads(lines[at])))
    path.write_text("\n".join([*lines[:at], line, *lines[at + 1 :]]) + "\n", "utf-8")


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(20, 60))
@given(data=st.data())
def test_a_damaged_map_is_gone_on_with_or_told(tmp_path: Path, map_lines: list[str], data) -> None:
    path = tmp_path / "map.jsonl"
    one_damaged(data.draw, map_lines, path)

    def go_on(path: Path) -> None:
        found = motion_map(impact_oscillator(), NUMBERS, file=path, resume=True, **SERIAL)
        assert found.peak_to_peak["x"].shape == found.lyapunov.shape == (2, 2)
        assert repr(found)
        coexisting_motions(found, runner=SerialRunner())

    told(path, go_on)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(15, 40))
@given(data=st.data())
def test_damaged_samples_are_gone_on_with_or_told(tmp_path: Path, sample_lines: list[str], data) -> None:
    path = tmp_path / "samples.jsonl"
    one_damaged(data.draw, sample_lines, path)
    assert main([*SAMPLE, "--output", str(path), "--resume", "--json", "--quiet"]) in (0, 2)


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"number": 3}, "number is 3, and there are 3 samples, from 0 on"),
        ({"measures": [1.0]}, "measures has 1 entries, not "),
        ({"kind": "periodic", "period_count": 0}, "period_count is 0, which does not fit kind"),
        ({"kind": None, "period_count": 1}, "period_count is 1, which does not fit kind"),
        ({"kind": None, "period_count": None}, ", where the motion failed"),
        ({"kind": "periodic", "period_count": 2}, "the period is inf, which is not period_count"),
        ({"measures": ["endless"]}, "a measure is 'endless', and the only word there is infinite"),
        ({"measures": [-1.0]}, "a measure is -1, which is no size of it"),
        ({"kind": "nonsense"}, "kind is 'nonsense'"),
        ({"period_count": "one"}, "period_count is 'one'"),
        ({"measures": 3}, "measures is 3"),
    ],
)
def test_a_sample_that_none_can_be(tmp_path: Path, sample_lines: list[str], capsys, changes, reason) -> None:
    kept = json.loads(sample_lines[1])
    measures = changes.get("measures", [1.0])
    whole = measures if reason.startswith("measures") else [*measures, *kept["measures"][1:]]
    path = tmp_path / "samples.jsonl"
    path.write_text(f"{sample_lines[0]}\n{json.dumps({**kept, **changes, 'measures': whole})}\n")
    assert main([*SAMPLE, "--output", str(path), "--resume", "--quiet"]) == 2
    assert reason in capsys.readouterr().err


@pytest.mark.parametrize("words", [SAMPLE, OF_MAP], ids=lambda each: each[0])
@pytest.mark.parametrize("make", [os.mkfifo, partial(os.symlink, "/dev/zero")])
def test_nothing_goes_on_with_a_stream(tmp_path: Path, capsys, words: list[str], make) -> None:
    make(path := tmp_path / "kept")
    assert main([*words, "--output", str(path), "--resume"]) == 2
    told = f"trimmer: {path} is a stream, from which nothing can go on: name a file\n"
    assert capsys.readouterr() == ("", told)


CELL = '{"number": 0, "motions": []}'


@pytest.mark.parametrize("line", [CELL, CELL.replace("0", "-1"), CELL.replace("0", "true"), "[" * 100_000])
def test_a_map_with_a_line_that_is_no_cell(tmp_path: Path, map_lines: list[str], line: str) -> None:
    path, twice = tmp_path / "map.jsonl", f"{map_lines[1]}\n{map_lines[1]}"
    for lines, at in ((line, 2), (twice, 3)):
        path.write_text(f"{map_lines[0]}\n{lines}\n")
        with pytest.raises(TrimmerError, match=rf"map\.jsonl, line {at}: is no cell .*take the line out"):
            motion_map(impact_oscillator(), NUMBERS, file=path, resume=True, **SERIAL)


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"period_count": -1}, "period_count, periods or starts are too small"),
        ({"periods": -1}, "period_count, periods or starts are too small"),
        ({"starts": 0}, "period_count, periods or starts are too small"),
        ({"failure": "a\nb"}, "failure is no text on one line"),
        ({"failure": "a\x1b[31m"}, "failure is no text on one line"),
        ({"measures": None}, "measures is null, and there is no failure"),
        ({"period_count": 0}, "period_count is 0, which does not fit kind"),
        ({"kind": "chaotic"}, "period_count is 1, which does not fit kind"),
        ({"holding": [0]}, "holding is of a motion at rest"),
        ({"states": []}, "states are 0, which does not fit"),
        ({"states": [[0.0, 0.0]] * 2}, "states are 2, which does not fit"),
        ({"states": [[0.0]]}, "states are not of as many numbers as the motion has states"),
        ({"states": [[0.0, -1e200]]}, "hold -1e\\+200, which no motion reaches"),
        ({"lyapunov": 1e200}, "hold 1e\\+200, which no motion reaches"),
        ({"largest_multiplier": -0.5}, "largest_multiplier is -0.5, which is no size"),
        ({"peak_to_peak": {}}, "measures.peak_to_peak is not of the parts"),
        ({"rms_acceleration": {}}, "measures.rms_acceleration is not of the parts"),
        ({"wear_power": {"a": 1.0}}, "measures.wear_power is not of the parts"),
        ({"peak_to_peak": {"x": -1.0}}, "measures.peak_to_peak.x is -1, which is no size"),
        ({"impacts": -1.0}, "measures.impacts is -1, which is no size"),
        ({"impact_speed": -0.5}, "measures.impact_speed is -0.5, which is no size"),
        ({"rms_acceleration": {"mass": 1e60}}, "measures.rms_acceleration.mass is 1e\\+60"),
        ({"wear_power": {"a": "b"}}, "wear_power.* is 'b'"),
        ({"periods": 10**20}, "periods.*whole number"),
        ({"events": True}, "events.*a number"),
    ],
)
def test_a_motion_that_none_can_be(tmp_path: Path, map_lines: list[str], changes, reason: str) -> None:
    first = json.loads(map_lines[1])
    motion = first["motions"][0]
    for name, value in changes.items():
        (motion if name in motion else motion["measures"])[name] = value
    path = tmp_path / "map.jsonl"
    path.write_text(f"{map_lines[0]}\n{json.dumps(first)}\n")
    with pytest.raises(TrimmerError, match=reason):
        motion_map(impact_oscillator(), NUMBERS, file=path, resume=True, **SERIAL)
