"""What is printed of a branch does not turn on the processor: no direction has a sign by chance."""

import subprocess
import sys
from pathlib import Path

import pytest

from scripts.kernels.processor import KERNELS, plain_environment, processor_flags

PROJECT = Path(__file__).parents[3]
FOLLOW = ("follow", "examples/oscillator-stop.toml", "--vary", "frequency", "--from", "0.85", "--to", "1.45")


@pytest.mark.slow
def test_a_branch_with_a_period_doubling_is_printed_alike_with_each_kernel() -> None:
    flags = processor_flags()
    usable = [kernel for kernel in KERNELS.values() if "sse2" in flags and not kernel.missing(flags)]
    if len(usable) < 2:
        pytest.skip("this processor leaves no choice of kernels")
    printed = set()
    for number, kernel in enumerate(usable):
        variables = plain_environment() | kernel.environment(1, number % 2 == 1, [])
        ended = subprocess.run(
            [sys.executable, "-m", "trimmer", *FOLLOW],
            cwd=PROJECT,
            env={**variables, "PYTHONPATH": str(PROJECT)},
            capture_output=True,
            text=True,
            check=True,
        )
        printed.add(ended.stdout)
    assert len(printed) == 1
    assert "period-doubling" in printed.pop()
