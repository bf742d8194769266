"""What all tests share: repeatable property tests, and tools that only some tests need."""

from __future__ import annotations

import functools
import gc
import os
import shutil
import signal
import subprocess
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import settings
from hypothesis.internal.conjecture import providers
from hypothesis.internal.conjecture.providers import Constants, HypothesisProvider

from tests.digits import rests_on_digits
from tests.kernels import warm_up
from tests.quick import examples

if TYPE_CHECKING:
    from playwright.sync_api import Browser
    from xdist.remote import Producer
    from xdist.scheduler import LoadFileScheduling

    from tests.report.rendering.page_checks import Visit

# The same examples in every run and on every computer; how long one takes depends on the computer.
settings.register_profile(
    "repeatable", derandomize=True, deadline=None, database=None, max_examples=examples(25, 60)
)
settings.load_profile("repeatable")
# Without this, numbers from the sources of whatever modules a process has loaded would be among them, and the
# examples would depend on which tests ran before.
HypothesisProvider._local_constants = Constants()
# Its plugin would read all these sources all the same, for a second in each process.
providers.is_local_module_file = lambda _: False
# A shell that runs the tests in the background lets them ignore interrupts, and so would what they start.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

ON_EVIDENCE = "claims figures future_work judging numbers octave overview robustness test_claims twin"
SHARING = (
    [f"tests/report/{each}" for each in ON_EVIDENCE.split()],
    ["tests/trimmer/drawing/"],
    ["tests/derivations/", "tests/report/derivation/", "tests/trimmer/test_code_generation.py"],
    ["tests/report/rendering/", "tests/report/design/test_sliders", "tests/report/design/test_hostile_names"],
    ["tests/report/design/"],
)
"""Places whose tests look at the same evidence, pictures, derivations or browser, made once in a process."""
CHROMIUM = ("chromium", "chromium-browser", "google-chrome")
POPPLER = ("pdftotext", "pdfinfo", "pdftoppm")
OCTAVE = ("octave-cli", "octave")


def find_chromium() -> str | None:
    """Return the path of the first Chromium on PATH, None if there is none."""
    return next((path for name in CHROMIUM if (path := shutil.which(name))), None)


@functools.cache
def find_octave() -> str | None:
    """Return the path of the first GNU Octave on PATH that has the package control, None if there is none."""
    check = ["--quiet", "--norc", "--eval", "exit(double(isempty(pkg('list', 'control'))))"]
    found = (path for name in OCTAVE if (path := shutil.which(name)))
    return next(
        (path for path in found if subprocess.run([path, *check], capture_output=True).returncode == 0), None
    )


def missing_tool(marker: str) -> str | None:
    """Return what a marker's tests lack on this machine, None if nothing."""
    if marker == "browser" and find_chromium() is None:
        return "Chromium is not installed (package chromium)"
    if marker == "poppler" and not all(shutil.which(name) for name in POPPLER):
        return f"{', '.join(POPPLER)} are not all installed (package poppler-utils)"
    if marker == "octave" and find_octave() is None:
        return "GNU Octave with its package control is not installed (package octave-control)"
    return None


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[None]:
    """Look for no garbage while tests are collected: all that is made stays, and the search takes seconds.

    For the same reason it is not searched again, and what the tests leave is searched less often than usual.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(20_000, 20, 20)
        gc.enable()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """Take one process more than there are processors: one of them waits for a browser for long."""
    return (os.cpu_count() or 1) + 1


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> LoadFileScheduling | None:
    """Give the tests of a file, or of a group of SHARING, to one process, as ``--dist loadfile`` does."""
    if config.getvalue("dist") != "loadfile":
        return None
    from xdist.scheduler import LoadFileScheduling

    class LoadSharing(LoadFileScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return next(
                (each[0] for each in SHARING if nodeid.startswith(tuple(each))), nodeid.partition("::")[0]
            )

    return LoadSharing(config, log)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the tests that rest on digits, before any are chosen by their marks."""
    for item in items:
        if rests_on_digits(item.path):
            item.add_marker("digits")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_finish(session: pytest.Session) -> None:
    """Compile a share of what all processes need, before the first of them begins with its tests."""
    warm_up(len(session.items))


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Skip a test whose tool is missing and say why; in CI let it fail."""
    for marker in ("browser", "poppler", "octave"):
        if item.get_closest_marker(marker) is None or (missing := missing_tool(marker)) is None:
            continue
        if os.environ.get("CI") == "true":
            pytest.fail(f"needed in CI: {missing}", pytrace=False)
        pytest.skip(missing)


@pytest.fixture(scope="session")
def chromium() -> str:
    """Path of Chromium, for tests marked ``browser``."""
    path = find_chromium()
    assert path is not None, "mark tests that use this fixture with pytest.mark.browser"
    return path


@pytest.fixture(scope="session")
def browser(chromium: str) -> Iterator[Browser]:
    """One Chromium for all tests of a process: Playwright cannot run twice in one."""
    from tests.report.rendering.page_checks import chromium_browser

    with chromium_browser(chromium) as browser:
        yield browser


@pytest.fixture(scope="session")
def window(browser: Browser) -> Iterator[Callable[..., Visit]]:
    """Pages of a process, by whether scripts run and by name: to lead one on costs less than to open it."""
    from tests.report.rendering.page_checks import opened

    with ExitStack() as pages:
        yield functools.cache(lambda scripts=True, _name="": pages.enter_context(opened(browser, scripts)))


@pytest.fixture(scope="session")
def octave() -> str:
    """Path of GNU Octave, for tests marked ``octave``."""
    path = find_octave()
    assert path is not None, "mark tests that use this fixture with pytest.mark.octave"
    return path


@pytest.fixture(scope="session")
def project_folder() -> Path:
    """Folder of pyproject.toml."""
    return Path(__file__).parent.parent
