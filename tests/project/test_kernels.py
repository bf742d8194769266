"""The runs on other kernels: each is listed or left out with its reason, and what differs fails."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from scripts.kernels.__main__ import Result, Run, told
from scripts.kernels.processor import KERNELS, processor_flags
from scripts.kernels.pythons import VERSIONS, interpreter
from tests.digits import TESTS, WITHOUT_DIGITS, rests_on_digits


def kernels(*options: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "scripts.kernels", *options]
    return subprocess.run(command, capture_output=True, text=True, cwd=TESTS.parent, check=False)


@pytest.mark.slow
def test_each_kernel_and_each_python_is_run_or_left_out_with_the_reason() -> None:
    ended = kernels("--list")
    assert ended.returncode == 0
    run = {line.split()[0] for line in ended.stdout.splitlines() if not line.startswith("left out: ")}
    reasons = dict(re.findall(r"^left out: ([\w. ]+): (.+)$", ended.stdout, re.MULTILINE))
    others = [version for version in VERSIONS if version != "{}.{}".format(*sys.version_info)]
    for name in KERNELS:
        assert (name in run) != (name in reasons)
    for version in others:
        assert (f"python-{version}" in run) == (interpreter(version) is not None)
        assert (f"Python {version}" in reasons) == (interpreter(version) is None)


def test_a_run_that_is_not_there_is_refused() -> None:
    ended = kernels("--only", "Piledriver")
    assert ended.returncode == 2
    assert "'Piledriver'" in ended.stderr


@pytest.mark.parametrize(
    ("flags", "possible"),
    [
        ("sse2", ["Prescott"]),
        ("sse2 sse4_2 avx", ["Prescott", "Nehalem"]),
        ("sse2 sse4_2 avx2 fma", ["Prescott", "Nehalem", "Haswell"]),
        ("sse2 sse4_2 avx2 fma avx512f avx512cd", ["Prescott", "Nehalem", "Haswell"]),
        ("sse2 sse4_2 avx2 fma avx512f avx512cd avx512bw avx512dq avx512vl", list(KERNELS)),
    ],
)
def test_a_processor_runs_what_its_flags_allow(flags: str, possible: list[str], tmp_path: Path) -> None:
    listing = tmp_path / "cpuinfo"
    listing.write_text(f"processor\t: 0\nflags\t\t: {flags}\nbugs\t\t: none\n")
    found = processor_flags(listing)
    assert [name for name, kernel in KERNELS.items() if not kernel.missing(found)] == possible
    assert processor_flags(tmp_path / "none") == frozenset()


def test_a_digit_of_a_claim_that_differs_fails(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def result(name: str, derived: str | None) -> Result:
        path = tmp_path / name
        path.write_text(json.dumps({"derived": derived}, indent=1))
        return Result(Run(name, None, 1), 3, 0, 1, path if derived else None, 1.0)

    assert told([result("one", "2.5"), result("two", "2.5")], []) == 0
    assert capsys.readouterr().out.endswith("\n6 passed, 0 failed\n")
    assert told([result("one", "2.5"), result("two", "2.6")], []) == 1
    shown = capsys.readouterr().out
    assert '-  "derived": "2.5"'.replace("  ", " ") in shown
    assert shown.endswith("\n6 passed, 1 failed\n")
    assert told([result("one", "2.5"), result("two", None)], []) == 1


def test_what_is_listed_as_without_digits_is_there() -> None:
    assert [each for each in WITHOUT_DIGITS if not (TESTS / each).exists()] == []
    assert rests_on_digits(TESTS / "trimmer" / "linear" / "test_model.py")
    assert not rests_on_digits(TESTS / "report" / "rendering" / "test_pdf.py")
