"""What strangers named acts neither on a terminal nor on a reader."""

from pathlib import Path

import pytest

from tests.hostile.commands import called

ACTING = "a\x1b[31mb\u202ec\u200bd\u2028e"
SHOWN = r"a\x1b[31mb\u202ec\u200bd\u2028e"


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_nothing_in_the_name_of_a_file_acts(capsys) -> None:
    lines = "".join(f"{place / 1000},{place % 7}\n" for place in range(500))
    Path(f"{ACTING}.csv").write_text(f"time [s],x [m]\n{lines}", "utf-8")
    code, out, _ = called(capsys, "spectrum", f"{ACTING}.csv")
    assert code == 0
    assert f"x [m] of {SHOWN}.csv" in out
    assert called(capsys, "spectrum", f"{ACTING}2.csv")[2].startswith(f"trimmer: {SHOWN}2.csv: no such file")


def test_names_that_are_refused_are_shown_as_they_are(capsys) -> None:
    name = r"out\u202e\u200b\u2028put"
    Path("a.toml").write_text(f'[bodies]\n"{name}" = {{ mass = 1.0 }}\n', "utf-8")
    code, _, told = called(capsys, "respond", "a.toml")
    assert code == 2
    assert f'bodies."{name}": a name must be text on one line' in told


@pytest.mark.parametrize(
    "words",
    [
        ("respond", "NAME"),
        ("simulate", "NAME"),
        ("spectrum", "NAME"),
        ("init", "NAME"),
        ("linear", "--plot", "NAME"),
        ("design", "a.toml", "--directory", "NAME"),
        ("report", "--directory", "NAME"),
    ],
)
def test_a_name_of_several_lines_is_refused(capsys, words: tuple[str, ...]) -> None:
    name = "a.toml: all is well\ntrimmer: b.svg"
    code, out, told = called(capsys, *(name if word == "NAME" else word for word in words))
    assert (code, out, told.count("\n")) == (2, "", 1)
    assert "has a line end in it; give it another name" in told
    assert list(Path().iterdir()) == []
