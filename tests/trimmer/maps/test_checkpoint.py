"""Files of maps: interrupted, gone on with, damaged, and of others."""

import hashlib
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer import Mechanism, MotionKind, SerialRunner, motion_map
from trimmer.errors import MapFileError
from trimmer.files import FileWriteError
from trimmer.maps.motion_map import MapInterruptedError
from trimmer.runners import ProcessRunner

PLACES = {"frequency": [1.0, 1.05, 1.1], "stops.wall.gap": [8.0, 10.0]}
SERIAL = SerialRunner()


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "map.jsonl"


@pytest.fixture(scope="module")
def whole():
    return motion_map(impact_oscillator(), PLACES, runner=SERIAL)


class Stopping:
    """A runner that is interrupted after some cells."""

    def __init__(self, cells: int) -> None:
        self.cells = cells

    def results(self, work, cells):
        for done, cell in enumerate(cells):
            if done == self.cells:
                raise KeyboardInterrupt
            yield work(cell)


def interrupted(file: Path, cells: int) -> None:
    with pytest.raises(MapInterruptedError, match=f"after {cells} of 6 cells, which .*map.jsonl holds"):
        motion_map(impact_oscillator(), PLACES, runner=Stopping(cells), file=file)


def resume(file: Path):
    return motion_map(impact_oscillator(), PLACES, runner=SERIAL, file=file, resume=True)


def test_the_file_says_all_that_it_depends_on(file: Path) -> None:
    motion_map(impact_oscillator(), PLACES, runner=SERIAL, file=file)
    header, *cells = map(json.loads, file.read_text("utf-8").splitlines())
    assert Mechanism.from_toml_text(header["mechanism"]) == impact_oscillator()
    assert header["places"] == list(PLACES)
    assert header["values"] == list(PLACES.values())
    assert header["settings"]["most_periods"] == 300
    # The digest of the keys above as JSON with sorted keys; so another program can know the inputs again.
    content = {name: header[name] for name in ("mechanism", "places", "settings", "values")}
    digest = hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
    assert header["inputs"] == digest
    assert sorted(cell["number"] for cell in cells) == list(range(6))


@pytest.mark.parametrize("cells", [0, 1, 5])
def test_an_interrupted_map_goes_on_to_the_same_numbers(file: Path, whole, cells: int) -> None:
    interrupted(file, cells)
    assert len(file.read_text("utf-8").splitlines()) == 1 + cells
    assert resume(file).cells == whole.cells


def test_a_map_may_be_interrupted_again(file: Path, whole) -> None:
    interrupted(file, 1)
    with pytest.raises(MapInterruptedError, match=r"after 3 of 6 cells"):
        motion_map(impact_oscillator(), PLACES, runner=Stopping(2), file=file, resume=True)
    assert resume(file).cells == whole.cells


def test_a_map_that_is_done_is_read_back_without_any_work(file: Path, whole) -> None:
    motion_map(impact_oscillator(), PLACES, runner=SERIAL, file=file)
    again = motion_map(impact_oscillator(), PLACES, runner=Stopping(0), file=file, resume=True)
    assert again.cells == whole.cells


@pytest.mark.parametrize("kept", [1, 40, 300])
def test_a_half_written_line_is_dropped(file: Path, whole, kept: int) -> None:
    interrupted(file, 3)
    content = file.read_bytes()
    last = content.rindex(b"\n", 0, len(content) - 1) + 1
    file.write_bytes(content[: last + kept])
    assert resume(file).cells == whole.cells
    assert len(file.read_text("utf-8").splitlines()) == 7


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"mechanism": impact_oscillator(7.0)}, "another mechanism"),
        ({"values": {"frequency": [1.0, 1.05, 1.1], "stops.wall.gap": [8.0, 11.0]}}, "other values"),
        ({"values": {"frequency": [1.0, 1.05, 1.1]}}, "other places"),
        ({"most_periods": 200}, "other settings"),
    ],
)
def test_a_file_of_other_inputs_is_refused(file: Path, changes, message: str) -> None:
    interrupted(file, 1)
    before = file.read_bytes()
    settings = {"mechanism": impact_oscillator(), "values": PLACES, **changes}
    with pytest.raises(MapFileError, match=f"begun with {message}"):
        motion_map(**settings, runner=SERIAL, file=file, resume=True)
    assert file.read_bytes() == before


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"inputs": "0" * 64}, "begun with other inputs"),
        ({"program": "0.0"}, "begun with another version of this program"),
        ({"trimmer map": 0}, "has format 0 of the file of a map, but this program writes"),
        ('{"other": 3}', "is no file of a map"),
        ("[1]", "is no file of a map"),
        ('{"trimmer map"', "is no file of a map"),
    ],
)
def test_a_file_with_another_header_is_refused(
    file: Path, changes: dict[str, object] | str, message: str
) -> None:
    interrupted(file, 1)
    header, cell = file.read_text("utf-8").splitlines()
    first = changes if isinstance(changes, str) else json.dumps({**json.loads(header), **changes})
    file.write_text(f"{first}\n{cell}\n", "utf-8")
    with pytest.raises(MapFileError, match=message):
        resume(file)


def test_a_cell_is_in_the_file_before_the_next_is_begun(file: Path) -> None:
    class Looking:
        def results(self, work, cells):
            for done, cell in enumerate(cells):
                assert file.read_bytes().count(b"\n") == 1 + done
                yield work(cell)

    motion_map(impact_oscillator(), PLACES, runner=Looking(), file=file)


def test_a_map_that_is_there_is_not_lost(file: Path) -> None:
    interrupted(file, 2)
    before = file.read_bytes()
    with pytest.raises(MapFileError, match="--resume"):
        motion_map(impact_oscillator(), PLACES, runner=SERIAL, file=file)
    assert file.read_bytes() == before
    motion_map(impact_oscillator(), PLACES, runner=SERIAL, file=file, overwrite=True)
    assert len(file.read_text("utf-8").splitlines()) == 7


def test_a_file_of_another_kind_is_not_lost(file: Path) -> None:
    file.write_text("my notes\n")
    with pytest.raises(FileWriteError, match="overwrite"):
        motion_map(impact_oscillator(), PLACES, runner=SERIAL, file=file)
    with pytest.raises(MapFileError, match="no file of a map"):
        resume(file)
    assert file.read_text() == "my notes\n"
    with pytest.raises(MapFileError, match="is a stream, with which no map can go on"):
        motion_map(impact_oscillator(), PLACES, runner=SERIAL, file=os.devnull)


PROGRAM = """
import sys
from tests.trimmer.maps.machines import linear_oscillator
from trimmer.maps.motion_map import motion_map
from trimmer.runners.processes import ProcessRunner
values = [1.0 + number / 1000 for number in range(1000)]
motion_map(linear_oscillator(), {"frequency": values}, runner=ProcessRunner(2), file=sys.argv[1])
"""


def begun(file: Path) -> subprocess.Popen[bytes]:
    """Begin a long map in another process, and wait for its first cells."""
    process = subprocess.Popen(
        [sys.executable, "-c", PROGRAM, str(file)], stderr=subprocess.PIPE, start_new_session=True
    )
    deadline = time.monotonic() + 60
    while not file.exists() or file.read_bytes().count(b"\n") < 10:
        assert process.poll() is None, process.stderr.read() if process.stderr else ""
        assert time.monotonic() < deadline
        time.sleep(0.02)
    return process


def members(group: int) -> list[int]:
    """Return the processes of a group that are there still, without those that only wait to be collected."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                fields = (entry / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if int(fields[2]) == group and fields[0] != "Z":
                found.append(int(entry.name))
    return found


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks at processes through /proc")
def test_a_killed_map_goes_on_to_the_same_numbers_and_leaves_no_process(file: Path) -> None:
    process = begun(file)
    process.kill()
    process.communicate()
    deadline = time.monotonic() + 20
    while members(process.pid):
        assert time.monotonic() < deadline, "a process outlived the one that began it"
        time.sleep(0.05)
    done = file.read_bytes().count(b"\n") - 1
    assert 9 <= done < 1000
    values = {"frequency": [1.0 + number / 1000 for number in range(1000)]}
    kept = file.read_bytes()
    again = motion_map(linear_oscillator(), values, runner=ProcessRunner(2), file=file, resume=True)
    assert file.read_bytes().startswith(kept[: kept.rindex(b"\n") + 1])
    some = {"frequency": values["frequency"][:40]}
    fresh = motion_map(linear_oscillator(), some, runner=SERIAL)
    assert [cell.motions for cell in again.cells[:40]] == [cell.motions for cell in fresh.cells]


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="sends a signal")
def test_control_c_leaves_a_file_to_go_on_with_and_says_so(file: Path) -> None:
    process = begun(file)
    os.killpg(process.pid, signal.SIGINT)
    _, errors = process.communicate(timeout=30)
    assert b"resume (--resume) goes on" in errors
    assert b"ForkProcess" not in errors
    assert file.read_bytes().endswith(b"\n")
    assert members(process.pid) == []


BODY = "frequency = 10\n[bodies]\nbody = { mass = 1.0 }\n[outputs]\nx = { body = 1 }\n[forces]\n"
DIVERGING = BODY + 'push = { on = "body", constant = 1.0, amplitude = 1.0 }\n'
RUBBING = '[frictions]\nrub = { between = ["ground", "body"], force = 2 }\n'
RESTING = BODY + 'push = { on = "body", amplitude = 1.0 }\n' + RUBBING


@pytest.mark.parametrize(("text", "kind"), [(DIVERGING, MotionKind.DIVERGING), (RESTING, MotionKind.REST)])
def test_a_map_goes_on_whatever_kind_its_motions_are_of(file: Path, text: str, kind: MotionKind) -> None:
    values = {"frequency": [9.0, 10.0]}
    machine = Mechanism.from_toml_text(text, "machine")
    first = motion_map(machine, values, runner=SERIAL, file=file, most_periods=30)
    assert first.kind.tolist() == [[kind, kind]]
    again = motion_map(machine, values, runner=Stopping(0), file=file, resume=True, most_periods=30)
    assert again.cells == first.cells
