"""An interrupt that comes while compiled code is at work ends it as any other, and not the process."""

import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = """
import signal, sys
from trimmer import Mechanism, simulate

# Numbers that overflow keep one call of the compiled code busy until it has used up its steps.
stiff = Mechanism.from_toml(sys.argv[1]).with_value("links.spring.stiffness", 1e308)
simulate(stiff, 1e-3)
signal.signal(signal.SIGALRM, signal.default_int_handler)
for pause in (0.02, 0.05, 0.1):
    signal.setitimer(signal.ITIMER_REAL, pause)
    try:
        while True:
            simulate(stiff, 1e3)
    except KeyboardInterrupt:
        print("interrupted")
"""


@pytest.mark.slow
def test_an_interrupt_within_compiled_code_is_an_interrupt(project_folder: Path) -> None:
    words = [sys.executable, "-c", SCRIPT, str(project_folder / "examples" / "oscillator-stop.toml")]
    ended = subprocess.run(words, cwd=project_folder, capture_output=True, text=True, timeout=120)
    assert (ended.returncode, ended.stdout.split()) == (0, 3 * ["interrupted"]), ended.stderr[-500:]
