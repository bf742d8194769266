from pathlib import Path

import pytest

from tests.trimmer.signals.reading import message_for
from trimmer.signals import CsvLayout, DecimalSign, Delimiter, read_signal

TWO = [0.25, -1500.0]


@pytest.mark.parametrize(
    "content",
    [
        "0.25\n-1500\n",
        "0.25\r\n-1500\r\n",
        "0.25\r-1500",
        "\n\n .25 \n-1.5E3\n\n\n",
        "0,25\n-1500,0\n\n",
        "# made by hand, 2024\ny\n0.25\n# in between\n-1.5e+3\n# the end\n",
        '"0.25"\n"-1500"\n',
        "y [µm]\n+0.25\n-1500.\n",
        "y [µm]\n0.25\n-1500\n".encode("latin-1"),
        "y\n0.25\n-1500\n".encode("utf-8-sig"),
        "a title\n\ny\n0.25\n-1500\n",
    ],
)
def test_one_column_needs_no_choice(file, content) -> None:
    layout = CsvLayout(decimal=DecimalSign.COMMA) if b"0,25" in file(content).read_bytes() else CsvLayout()
    signal = read_signal(file(content), sample_rate=10, layout=layout)
    assert signal.values.tolist() == TWO
    assert signal.sample_rate == 10.0


@pytest.mark.parametrize(
    ("content", "options", "message"),
    [
        ("0.0|1.0\n0.1|2.0\n", {}, ", line 1: '0.0|1.0' is several numbers; separate columns by comma"),
        (
            "t,y\n0.0,1.5\n0.1,2.5\n",
            {"layout": CsvLayout(Delimiter.SEMICOLON)},
            ", line 2: '0.0,1.5' has a point and a comma; choose the delimiter that fits",
        ),
        ("y\n1\n2 mm\n", {}, ", line 3: '2 mm' is not a number; put # before lines"),
        ("y\n1\n1_000\n", {}, ", line 3: '1_000' is not a number"),
        ("y\n1\n١\n", {}, ", line 3: '١' is not a number"),
        ("y\n1\n__import__('os')\n", {}, ", line 3: \"__import__('os')\" is not a number"),
        ("y\n1\ninf\n", {}, ", line 3: 'inf' is not finite; was the sensor overloaded?"),
        ("a,b\n1,2\n3\n", {"column": "b"}, ", line 3: 1 cell separated by comma, where line 2 has 2: '3'"),
        ("only words\n", {}, ": holds no number"),
        ("# 1\n", {}, ": holds no number"),
        ("", {}, ": is empty"),
        (" \n\n", {}, ": is empty"),
        (b"PK\x03\x04...", {}, ": is a spreadsheet or another zip file; export"),
        (b"RIFF....WAVE", {}, ": is a RIFF file, such as WAV"),
        ("y\n1\n".encode("utf-16"), {}, ": is UTF-16 text; save it as UTF-8"),
        ("y\n1\n".encode("utf-16-le"), {}, ", line 1: byte 0x00 does not occur in CSV text"),
    ],
)
def test_a_fault_of_the_content_is_reported_with_its_line(file, content, options, message: str) -> None:
    error = message_for(file(content), sample_rate=10, **options)
    assert error.startswith(message)
    assert len(error) < 250


def test_a_file_that_cannot_be_read_is_reported(tmp_path: Path) -> None:
    advice = ": no such file; name a file of samples"
    assert message_for(tmp_path / "none.csv", sample_rate=1) == advice
    near = tmp_path / "noned.csv"
    near.write_text("1\n2\n")
    assert message_for(tmp_path / "none.csv", sample_rate=1) == f": no such file; did you mean {near}?"
    assert "is a folder" in message_for(tmp_path, sample_rate=1)
