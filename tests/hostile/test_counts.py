"""One of a thing is told in the singular."""

import re
from pathlib import Path

import pytest

from tests.hostile.commands import called

EXAMPLES = Path(__file__).parents[2] / "examples"
PLURAL = re.compile(
    r"(?<![\d.])1 "  # not the end of a larger number, such as that of samples per second
    r"(starts|motions|orbits|periods|trials|cells|samples|numbers|values|points|spectra|states|rounds)\b"
)


@pytest.mark.parametrize(
    "words",
    [
        ("map", "den-hartog.toml", "--vary", "frequency=0.1:0.2:1", "--periods", "5", "--jobs", "1"),
        ("map", "den-hartog.toml", "--vary", "frequency=0.1:0.2:1", "--starts", "2", "--periods", "5"),
        ("sample", "scatter.toml", "--count", "1", "--periods", "2", "--jobs", "1"),
        ("respond", "den-hartog.toml", "--starts", "1", "--periods", "5"),
    ],
    ids=" ".join,
)
def test_one_is_singular(capsys, words: tuple[str, ...]) -> None:
    code, out, told = called(capsys, words[0], str(EXAMPLES / words[1]), *words[2:])
    if code == 0:
        assert PLURAL.search(re.sub(r"\s+", " ", out)) is None
    else:
        assert told.count("\n") == 1


def test_a_missing_sample_is_one(tmp_path: Path, capsys) -> None:
    lines = [f"{place / 1000},{place % 7}\n" for place in range(500)]
    lines[40] = "0.04,\n"
    path = tmp_path / "a.csv"
    path.write_text(f"time [s],x [m]\n{''.join(lines)}", "utf-8")
    code, out, _ = called(capsys, "spectrum", str(path), "--missing", "interpolate")
    assert code == 0
    assert "1 sample was missing and is interpolated" in out
