from __future__ import annotations

import os
import socket
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from trimmer.files import FileWriteError, write_atomically
from trimmer.parameters import TrimmerParameters

CONTENTS = {
    "csv": b"time [s],q2-q4 [m]\n0.0,1e-3\n",
    "wav": b"RIFF\x24\x00\x00\x00WAVEfmt ",
    "png": b"\x89PNG\r\n\x1a\n\x00",
    "svg": b'<?xml version="1.0" encoding="utf-8" standalone="no"?>\n<!DOCTYPE svg PUBLIC "-//W3C//DTD">',
    "pdf": b"%PDF-1.7\n",
    "html": b"<!DOCTYPE html>\n<html>",
    "json": b'{\n  "schema": 1}',
    "toml": TrimmerParameters.thesis().to_toml().encode(),
    "mechanism": TrimmerParameters.thesis().to_mechanism(1.5e-3, 110.0).to_toml().encode(),
    "py": b'"""Linear trimmer in numbers.\n"""',
    "tex": b"\\documentclass[11pt]{article}\n\\usepackage{amsmath}\n\\title{The trimmer: derivation}\n",
    "txt": b"anything",
}
"""How a file of each kind begins; the last is of none."""


def test_writes_text_as_utf8_without_changing_line_ends(tmp_path: Path) -> None:
    write_atomically(tmp_path / "a.txt", "ω\r\nb\n")
    assert (tmp_path / "a.txt").read_bytes() == "ω\r\nb\n".encode()


def test_writes_bytes_and_makes_parent_folders(tmp_path: Path) -> None:
    write_atomically(tmp_path / "new" / "folder" / "a.bin", b"\x00\xff")
    assert (tmp_path / "new" / "folder" / "a.bin").read_bytes() == b"\x00\xff"


def test_replaces_a_file_and_keeps_its_permissions(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_text("old")
    path.chmod(0o640)
    write_atomically(path, "new")
    assert path.read_text() == "new"
    assert path.stat().st_mode & 0o777 == 0o640


def test_a_new_file_has_the_permissions_of_any_new_file(tmp_path: Path) -> None:
    (tmp_path / "plain").write_text("")
    write_atomically(tmp_path / "whole", "")
    assert (tmp_path / "whole").stat().st_mode == (tmp_path / "plain").stat().st_mode


def test_a_symbolic_link_stays_and_its_target_changes(tmp_path: Path) -> None:
    (tmp_path / "target").write_text("old")
    (tmp_path / "link").symlink_to(tmp_path / "target")
    write_atomically(tmp_path / "link", "new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "target").read_text() == "new"


def test_a_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileWriteError, match="is a folder"):
        write_atomically(tmp_path, "text")


def test_a_file_in_place_of_a_parent_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(FileWriteError, match=r"file/a\.txt cannot be written"):
        write_atomically(tmp_path / "file" / "a.txt", "text")


def test_a_failure_keeps_the_old_file_and_leaves_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.txt"
    path.write_text("old")

    def fail(source: object, target: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", fail)
    with pytest.raises(FileWriteError, match=r"a\.txt cannot be written: No space left on device"):
        write_atomically(path, "new")
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("old", CONTENTS)
@pytest.mark.parametrize("new", CONTENTS)
def test_only_a_file_of_the_same_kind_is_replaced(tmp_path: Path, old: str, new: str) -> None:
    path = tmp_path / "a file"
    path.write_bytes(CONTENTS[old] + b"old")
    if old == new:
        write_atomically(path, CONTENTS[new] + b"new")
        assert path.read_bytes() == CONTENTS[new] + b"new"
        return
    with pytest.raises(FileWriteError, match=r"a file is there already and is .*--overwrite"):
        write_atomically(path, CONTENTS[new])
    assert path.read_bytes() == CONTENTS[old] + b"old"
    write_atomically(path, CONTENTS[new], overwrite=True)
    assert path.read_bytes() == CONTENTS[new]
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(
    "mine",
    [
        "m1 = 0.035\n",
        "# my trimmer\nm1 = 0.035\n",
        "t,x\n0,1\n",
        "0.1\n0.2\n",
        '{"a": 1}',
        "\\documentclass{book}",
    ],
)
def test_a_file_of_the_user_is_kept(tmp_path: Path, mine: str) -> None:
    path = tmp_path / "mine"
    path.write_text(mine)
    for content in (CONTENTS["csv"], CONTENTS["wav"], CONTENTS["json"], CONTENTS["svg"]):
        with pytest.raises(FileWriteError, match="is there already and is no"):
            write_atomically(path, content)
    assert path.read_text() == mine


def test_an_empty_file_is_replaced(tmp_path: Path) -> None:
    (tmp_path / "a.csv").touch()
    write_atomically(tmp_path / "a.csv", CONTENTS["csv"])
    assert (tmp_path / "a.csv").read_bytes() == CONTENTS["csv"]


def test_a_link_to_a_file_of_another_kind_is_no_way_round(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_bytes(CONTENTS["toml"])
    (tmp_path / "a.csv").symlink_to("mine.toml")
    with pytest.raises(FileWriteError, match="is no CSV file"):
        write_atomically(tmp_path / "a.csv", CONTENTS["csv"])
    assert (tmp_path / "mine.toml").read_bytes() == CONTENTS["toml"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
@pytest.mark.parametrize("overwrite", [False, True])
def test_a_named_pipe_gets_the_content_and_stays(tmp_path: Path, overwrite: bool) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    read: list[bytes] = []
    # A reader that finds an ordinary file reads that, so that the test ends either way.
    reader = threading.Thread(target=lambda: read.append(pipe.read_bytes()), daemon=True)
    reader.start()
    write_atomically(pipe, CONTENTS["csv"], overwrite=overwrite)
    reader.join(10)
    assert read == [CONTENTS["csv"]]
    assert pipe.is_fifo()


@pytest.mark.skipif(not hasattr(os, "openpty"), reason="needs terminals")
def test_a_character_device_gets_the_content_and_stays() -> None:
    controller, terminal = os.openpty()
    path = Path(os.ttyname(terminal))
    write_atomically(path, b"to a terminal")
    assert os.read(controller, 100) == b"to a terminal"
    assert path.is_char_device()
    os.close(terminal)
    os.close(controller)


def test_a_socket_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)  # the path of a socket must be short
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind("socket")
        for overwrite in (False, True):
            with pytest.raises(FileWriteError, match="socket is neither a file nor a stream"):
                write_atomically(tmp_path / "socket", "text", overwrite=overwrite)
    assert (tmp_path / "socket").is_socket()


WRITE_AND_PRINT = """
from pathlib import Path
from trimmer.files import write_atomically
print("before")
write_atomically(Path("/dev/stdout"), "content\\n")
print("after")
"""


@pytest.mark.skipif(not Path("/dev/stdout").exists(), reason="needs /dev/stdout")
def test_standard_output_is_a_stream_whatever_it_is(tmp_path: Path, project_folder: Path) -> None:
    command = [sys.executable, "-c", WRITE_AND_PRINT]
    piped = subprocess.run(command, capture_output=True, text=True, cwd=project_folder, check=True)
    assert piped.stdout == "before\ncontent\nafter\n"
    with (tmp_path / "a.txt").open("wb") as file:
        subprocess.run(command, stdout=file, cwd=project_folder, check=True)
    assert (tmp_path / "a.txt").read_text() == "before\ncontent\nafter\n"
