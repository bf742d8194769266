"""The table of the peers: what a row says of an error, of a failure, and that ours is asked alike."""

import json
import sys

import pytest

from benchmarks.peers import run, telling
from benchmarks.problems import ask
from benchmarks.problems.read import problems

PROBLEM = next(each for each in problems() if each.name == "ball-to-rest")
DIGIT = PROBLEM.digits[0]
HEAD = {"peer": "P", "setting": "s", "problem": PROBLEM.name, "digit": DIGIT.name}


@pytest.mark.parametrize(
    ("told", "end"),
    [
        ({"value": DIGIT.value, "seconds": 0.0123}, "| 12.3 ms | below 1e-12 |\n"),
        ({"value": DIGIT.value * 1.002, "seconds": 1.5}, "| 1.5e+03 ms | 2e-03 |\n"),
        ({"failed": "ValueError: no impact"}, "| | ValueError: no impact |\n"),
    ],
)
def test_a_row_tells_time_and_error(told: dict[str, object], end: str) -> None:
    assert run.row({**HEAD, **told}, DIGIT) == f"| `ball-to-rest` | first impact | P | s {end}"


def test_ours_is_the_digit_by_one_command() -> None:
    assert ask.one(PROBLEM, DIGIT) == pytest.approx(DIGIT.value, rel=DIGIT.agreement)


def test_a_peer_that_fails_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    telling.tell("P", "s", "a", "b", lambda: 1 / 0)
    telling.tell("P", "s", "a", "b", lambda: 2)
    first, second = (json.loads(line) for line in capsys.readouterr().out.splitlines())
    assert first["failed"] == "ZeroDivisionError: division by zero"
    assert second["value"] == 2.0 and second["seconds"] >= 0.0


def test_the_kept_table_names_every_peer() -> None:
    table = (run.PROJECT / "benchmarks" / "peers" / "table.md").read_text("utf-8")
    assert all(f"| {name}" in table for name in (peer.name for peer in run.PEERS))
    assert "calibration loop" in table.lower()


def test_who_was_faster_and_who_is_missing_is_said() -> None:
    slow, own = (
        {**HEAD, "value": 1.0, "seconds": 0.3},
        {**HEAD, "peer": "trimmer", "seconds": 0.2, "value": 1.0},
    )
    fast = {**slow, "peer": "Q", "seconds": 0.1}
    table = run.written(
        [(slow, DIGIT), (fast, DIGIT), (own, DIGIT)],
        {"SciPy": "not run here: pip install scipy"},
        "Loop: 24 ms",
    )
    assert "Faster than ours: Q (s) on `ball-to-rest`." in table
    assert "None was faster than ours." in run.written([(slow, DIGIT), (own, DIGIT)], {}, "")
    assert "| | | SciPy | not run here: pip install scipy | | |" in table


@pytest.mark.parametrize(
    ("python", "longest", "why"),
    [
        ("no-such-python", 60.0, "not run here: ask apt"),
        (sys.executable, 60.0, "not run here: ask apt"),
        (sys.executable, 1e-3, "not ended after 0.001 s"),
    ],
)
def test_why_a_peer_told_nothing_is_said(python: str, longest: float, why: str) -> None:
    assert run.told_by(run.Peer("P", "no_such_peer", python, "ask apt"), longest) == ([], why)
