"""The one script that runs all listings, as the README says, from another folder."""

from __future__ import annotations

import re
import shlex
import subprocess

import pytest

from report.octave.archive import files, write_files
from trimmer import FrictionBacklash, TrimmerParameters, limit_cycles, modes, transfer_function
from trimmer.linear import InputChannels

pytestmark = [pytest.mark.octave, pytest.mark.slow]  # test_against_python asks for more numbers
THESIS = TrimmerParameters.thesis()
BOTH = InputChannels.DISPLACEMENT_AND_VELOCITY


@pytest.fixture(scope="module")
def printed(octave, programs, tmp_path_factory):
    folder = tmp_path_factory.mktemp("with a space") / "octave"
    write_files(programs, folder)
    (line,) = re.findall(r"^    (octave-cli .*)$", files(programs)["README.md"], re.MULTILINE)
    _, script = shlex.split(line)
    command = [octave, "--quiet", "--norc", str(folder / script)]
    ended = subprocess.run(
        command, cwd=folder.parent, capture_output=True, text=True, stdin=subprocess.DEVNULL
    )
    assert ended.returncode == 0, ended.stderr
    assert "warning" not in ended.stderr
    return ended.stdout


def test_each_listing_is_there(printed):
    assert set(re.findall(r"^(A\.\d+) ", printed, re.MULTILINE)) == {f"A.{index}" for index in range(1, 11)}


def test_frequencies_of_the_modes(printed):
    found = re.search(r"^A\.1 .*: (.*)$", printed, re.MULTILINE)[1].split()
    expected = sorted(mode.eigenvalue.imag / (2 * 3.141592653589793) for mode in modes(THESIS))
    assert found == [f"{frequency:.3f}" for frequency in expected]


def test_describing_functions(printed):
    block = printed.partition("A.2 ")[2].partition("A.3 ")[0]
    numbers = re.findall(r"^ +(\S+) +(\S+)i$", block, re.MULTILINE)
    expected = FrictionBacklash(1.0).describing_function([0.6, 1.0, 3.0, 10.0])
    assert [complex(float(real), float(imaginary)) for real, imaginary in numbers] == pytest.approx(
        expected, abs=6e-8
    )


def test_limit_cycles(printed):
    block = printed.partition("     friction:\n")[2].partition("     friction displacement only")[0]
    found = re.findall(r"amplitude (\S+) m, frequency (\S+) Hz, (\w+)", block)
    expected = [
        (f"{cycle.amplitude:.6g}", f"{cycle.frequency:.3f}", "stable" if cycle.stable else "unstable")
        for cycle in limit_cycles(transfer_function(THESIS, channels=BOTH), FrictionBacklash(4e-5))
    ]
    assert found
    assert found == expected
