"""The one script that runs all listings, as the README says, from another folder."""

import re
import shlex
import subprocess

import pytest

from report.octave.archive import files, write_files

pytestmark = [pytest.mark.octave, pytest.mark.slow]  # test_against_python asks for more numbers


@pytest.fixture(scope="module")
def printed(octave, programs, tmp_path_factory):
    folder = tmp_path_factory.mktemp("with a space") / "octave"
    write_files(programs, folder)
    (line,) = re.findall(r"^    (octave-cli .*)$", files(programs)["README.md"], re.MULTILINE)
    _, script = shlex.split(line)
    command = [octave, "--quiet", "--norc", str(folder / script)]
    ran = subprocess.run(command, cwd=folder.parent, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    assert ran.returncode == 0, ran.stderr
    assert "warning" not in ran.stderr
    return ran.stdout


def test_each_listing_is_there(printed):
    assert set(re.findall(r"^(A\.\d+) ", printed, re.MULTILINE)) == {f"A.{index}" for index in range(1, 11)}
