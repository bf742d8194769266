from __future__ import annotations

import json
from pathlib import Path

import pytest

from trimmer.balance.solve import limit_cycles
from trimmer.command_line.main import main
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.linear.model import InputChannels, pin_model
from trimmer.parameters import TrimmerParameters

FRICTION = ["limit-cycles", "--element", "friction", "--gap", "4e-5"]


def test_json_holds_the_limit_cycles_in_full_precision(capsys) -> None:
    assert main([*FRICTION, "--channels", "displacement", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    G = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
    expected = limit_cycles(G, FrictionBacklash(4e-5))
    assert [cycle["amplitude"] for cycle in printed["limit_cycles"]] == [
        cycle.amplitude for cycle in expected
    ]
    assert [cycle["frequency"] for cycle in printed["limit_cycles"]] == [
        cycle.frequency for cycle in expected
    ]
    assert [cycle["stable"] for cycle in printed["limit_cycles"]] == [False, True]
    assert printed["certificate"]["complete"] is True


def test_text_is_a_table_and_says_what_is_certain(capsys) -> None:
    assert main([*FRICTION, "--channels", "displacement"]) == 0
    printed = capsys.readouterr().out
    for shown in ("0.000332608", "733.631", "553.59", "none is missing there; none exist outside"):
        assert shown in printed
    assert max(map(len, printed.splitlines())) <= 110


def test_no_limit_cycle_is_reported(capsys) -> None:
    assert main(["limit-cycles", "--element", "coulomb", "--force", "0.15"]) == 0
    assert "\n  none\n" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "start", "element"),
    [
        ("loop.svg", b"<?xml", ["viscous", "--time-constant", "1e-3"]),
        ("loop.png", b"\x89PNG", ["friction"]),
        ("loop.pdf", b"%PDF", ["friction"]),
    ],
    ids=["svg", "png", "pdf"],
)
def test_the_picture_is_the_same_bytes_each_time(
    tmp_path: Path, name: str, start: bytes, element: list[str]
) -> None:
    words = ["limit-cycles", "--gap", "4e-5", "--element", *element, "--plot"]
    contents = []
    for folder in ("one", "two"):
        assert main([*words, str(tmp_path / folder / name)]) == 0
        contents.append((tmp_path / folder / name).read_bytes())
    assert contents[0].startswith(start)
    assert contents[0] == contents[1]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--element", "friction"], "--element friction needs --gap"),
        (["--element", "viscous", "--gap", "1"], "--element viscous needs --time-constant"),
        (["--element", "relay", "--force", "1", "--gap", "1"], "--element relay does not use --gap"),
        (["--element", "relay", "--force", "1", "--slope", "1"], "--element relay does not use --slope"),
        (["--element", "relay", "--force", "1", "--hysteresis", "-1"], "must be zero or positive (m)"),
        (["--element", "relay", "--force", "1", "--dead-zone", "inf"], "--dead-zone inf: must be finite"),
        (["--element", "saturation"], "--element saturation needs --threshold"),
        (["--element", "saturation", "--threshold", "1", "--slope", "0"], "slope must be positive"),
        (["--element", "dead-zone", "--threshold", "0"], "threshold must be positive"),
        (["--element", "preload", "--force", "1", "--threshold", "1"], "does not use --threshold"),
        (["--element", "friction", "--gap", "-1"], "gap must be positive"),
        (["--element", "friction", "--gap", "nan"], "gap must be positive"),
        (["--element", "friction", "--gap", "1", "--omega-range", "2", "1"], "0 < lowest < highest"),
        (["--element", "friction", "--gap", "1", "--plot", "a.jpg"], "the name must end in .svg"),
        (["--element", "friction", "--gap", "1", "--output", "q9"], "q9"),
    ],
)
def test_what_the_user_got_wrong_is_one_line_and_exit_code_2(capsys, words, message: str) -> None:
    assert main(["limit-cycles", *words]) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert message in printed.err
    assert printed.err.startswith("trimmer: ")
    assert printed.err.count("\n") == 1


def test_identify_gives_the_time_constant_or_says_that_there_is_none(capsys) -> None:
    words = ["identify", "--gap", "4e-5", "--channels", "displacement", "--frequency"]
    assert main([*words, "740"]) == 0
    assert "0.000229291" in capsys.readouterr().out
    assert main([*words, "900"]) == 0
    assert "no M/D gives a limit cycle" in capsys.readouterr().out
    assert main([*words, "900", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["time_constants"], told["intervals"]) == ([], [])
    assert told["nearest"]["time_constant"] is None  # inertia alone has the highest frequency of all loads
    assert told["nearest"]["limit_cycle"]["frequency"] == told["bands"][-1]["frequencies"][1]
    assert main([*words, "900", "--uncertainty", "1"]) == 0
    assert "no M/D gives a limit cycle within 900 +- 1 Hz" in capsys.readouterr().out
    assert main([*words, "740", "--uncertainty", "1"]) == 0
    assert "M/D within 740 +- 1 Hz: " in capsys.readouterr().out
    assert main([*words, "740", "--uncertainty", "800"]) == 2
    assert "--uncertainty 800: must be zero or positive, less than --frequency" in capsys.readouterr().err
    assert main([*words, "-1"]) == 2
    assert "frequency must be positive" in capsys.readouterr().err
