"""One design, looked at coarsely and rendered once for all tests."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from report.cache.stage_store import StageStore
from report.design.building import files_of, looked_at, report_on
from report.design.report import DesignReport
from report.pages.formats import Format, Paper
from tests.report.made_once import MadeOnce
from trimmer import SerialRunner
from trimmer.design import Design, DesignSettings
from trimmer.design.specification.design_file import design_file_of_text

TEXT = """
title = "Trimmer on the desk"
frequency = 60.0
held = "motor"

[bodies]
motor = { mass = "35 g" }
cutter = { mass = "3 g" }

[pins]
pin = { on = "motor", amplitude = "1 mm" }

[links]
mount = { between = ["ground", "motor"], stiffness = "200 N/mm", damping = 30.0 }

[plays]
bridge = { between = ["cutter", "pin"], stiffness = "30 N/mm", damping = 4.0, gap = "20 um..60 um" }

[frictions]
blade = { between = ["ground", "cutter"], force = 0.8 }

[outputs]
stroke = { cutter = 1 }

[targets]
stroke_at_least = { stroke = "1.931 mm" }
rms_acceleration_at_most = { motor = "30 m/s²" }
impact_speed_at_most = "0.15 m/s"
only_drive_period = true
"""
"""Two bodies with play and friction, an open gap, and a held body."""
COARSE = DesignSettings(
    starts=2, cells=4, cell_periods=60, neighbours=3, trials=3, most_points=12, range_points=5, grid=2
)


@pytest.fixture(scope="session")
def store(made_once: MadeOnce, tmp_path_factory: pytest.TempPathFactory) -> StageStore:
    """Where its steps are kept, for all processes, and for later runs of the same sources."""
    return StageStore(made_once.lasting / "design" if made_once.lasting else tmp_path_factory.mktemp("kept"))


@pytest.fixture(scope="session")
def design(store: StageStore, made_once: MadeOnce) -> Design:
    """A small trimmer whose gap is open; who comes while it is looked at waits."""
    if made_once.folder is not None:
        made_once.get("design", lambda: bool(look(store)))
    return look(store)


def look(store: StageStore) -> Design:
    """Look at it; what another process has kept is not computed again."""
    return looked_at(design_file_of_text(TEXT, "desk.toml"), COARSE, SerialRunner(), store, lambda *_: None)


@pytest.fixture(scope="session")
def report(design: Design, store: StageStore, made_once: MadeOnce) -> DesignReport:
    """The report on it."""
    return made_once.of_sources("report", lambda: report_on(design, store, "2026-03-01"), __file__)


@pytest.fixture(scope="session")
def files(report: DesignReport, made_once: MadeOnce) -> Mapping[Format, str | bytes]:
    """Its files."""
    forms = frozenset({Format.HTML, Format.PDF})
    return made_once.of_sources("files", lambda: files_of(report, forms, Paper.A4), __file__)


@pytest.fixture(scope="session")
def pdf(files: Mapping[Format, str | bytes], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The PDF as a file."""
    path = tmp_path_factory.mktemp("pdf") / "desk.pdf"
    content = files[Format.PDF]
    assert isinstance(content, bytes)
    path.write_bytes(content)
    return path
