"""Names that no table holds are refused, and what is long does not widen a page."""

from pathlib import Path

import pytest

from tests.hostile.commands import called

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
