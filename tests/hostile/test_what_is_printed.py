"""What strangers named acts neither on a terminal nor on a reader; what is too long is refused."""

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


BODY = '[bodies]\n"NAME" = { mass = 1.0 }\n[links]\ns = { between = ["ground", "NAME"], stiffness = 1.0 }\n'
CONTROL = """[outputs]
x = { NAME = 1 }
[controllers]
LONG = { kind = "pid", measure = "x", acts = ["ground", "NAME"], kp = 1.0 }
"""


@pytest.mark.parametrize("command", ["respond", "design"])
@pytest.mark.parametrize(
    ("text", "told"),
    [
        (BODY.replace("NAME", "m" * 20000), "a name of 20000 characters is too long; use at most 300"),
        (BODY + CONTROL.replace("LONG", "c" * 400), "a name of 400 characters is too long; use at most 300"),
        (f'title = "{"t" * 20000}"\n{BODY}', "title = 'ttt"),
    ],
)
def test_long_names_are_refused(tmp_path: Path, capsys, command: str, text: str, told: str) -> None:
    path = tmp_path / "a.toml"
    path.write_text(f"frequency = 1.0\n{text}", "utf-8")
    code, out, error = called(capsys, command, str(path))
    assert (code, out) == (2, "")
    assert told in error
    assert len(error) < 500


def test_a_long_author_is_refused(tmp_path: Path, capsys) -> None:
    path = tmp_path / "a.toml"
    path.write_text(f'author = "{"q" * 5000}"\n{BODY}', "utf-8")
    code, _, error = called(capsys, "design", str(path))
    assert code == 2
    assert "text on one line, of at most 1000 characters" in error


OSCILLATOR = Path(__file__).parents[2] / "examples" / "den-hartog.toml"


def test_letters_without_a_font_are_told(tmp_path: Path, capsys) -> None:
    strange = "\N{CUNEIFORM SIGN A}"  # printable, and in no font of Matplotlib
    path = tmp_path / "a.toml"
    words = ("simulate", str(path), "--duration", "30", "--plot", str(tmp_path / "a.svg"))
    for name in ("stroke", strange):
        text = OSCILLATOR.read_text("utf-8").replace("block = { block = 1 }", f'"{name}" = {{ block = 1 }}')
        path.write_text(text, "utf-8")
        code, _, told = called(capsys, *words)
        assert code == 0
        sentence = f"boxes stand in pictures for letters that none of their fonts has: '{strange}'"
        assert (sentence in told) is (name == strange)
    assert "boxes" not in called(capsys, *words, "--quiet")[2]
