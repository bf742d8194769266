"""What goes on in the process of a test file: it is run, or run and recorded."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from scripts.mutation.collected import ENTERED, PACKAGES

OPTIONS = ("-q", "-p", "no:cacheprovider", "-p", "no:xdist", "--no-header", "--tb=line")


def failure(files: Sequence[str]) -> str:
    """Run test files until one test fails; return its name, or what went wrong, empty if all passed."""
    return next(iter(_failed(files, "-x")), "")


def failures(files: Sequence[str]) -> tuple[str, ...]:
    """Run test files to their end; return the names of all tests that fail, or what went wrong."""
    return _failed(files)


def _failed(files: Sequence[str], *options: str) -> tuple[str, ...]:
    import pytest

    watched = _Watch()
    code = pytest.main([*OPTIONS, *options, *files], plugins=[watched])
    if code in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED):
        return ()
    return tuple(watched.failed) or (f"pytest ended with {code!r}",)


def recorded(file: str) -> tuple[str, Mapping[str, list[int]], list[str]]:
    """Run a test file; return what failed, the lines that it ran by source, and which compiled code.

    What is loaded already runs no lines of a module's level. Compiled functions are not seen line by line;
    instead it is written down which entry of compiled code was called.
    """
    import coverage

    own = [f"{Path.cwd()}/{package}/*" for package in PACKAGES]
    measured = coverage.Coverage(data_file=None, config_file=False, include=own)
    measured.start()
    try:
        failed = failure([file])
    finally:
        measured.stop()
    data, root = measured.get_data(), Path.cwd()
    lines = {
        Path(name).relative_to(root).as_posix(): sorted(data.lines(name) or ())
        for name in data.measured_files()
        if Path(name).is_relative_to(root)
    }
    return failed, lines, sorted(ENTERED)


class _Watch:
    """Keeps the names of the tests and files that fail."""

    def __init__(self) -> None:
        self.failed: list[str] = []

    def pytest_runtest_logreport(self, report: Any) -> None:
        if report.failed and report.nodeid not in self.failed:
            self.failed.append(report.nodeid)

    def pytest_collectreport(self, report: Any) -> None:
        if report.failed:
            self.failed.append(f"{report.nodeid} (not collected)")
