"""What the report says of a machine that switches: where it rests, by the balance of forces."""

from pathlib import Path

import numpy as np

from report.design.markdown import to_markdown
from report.design.origin import origin_of
from report.design.report import DesignReport
from tests.report.markdown_lines import markdown_lines
from trimmer import SerialRunner
from trimmer.design import DesignSettings, Study
from trimmer.design.design_file import design_file_of_text

CONTACTOR = Path(__file__).parents[3] / "examples" / "contactor.toml"


def test_a_contactor_that_stays_closed_holds_what_its_coil_pulls() -> None:
    kept_on = CONTACTOR.read_text("utf-8").replace(', ["60 ms", 25.0], ["62 ms", 0.0]]', "]")
    file = design_file_of_text(kept_on[: kept_on.index("[targets]")], "contactor.toml")
    design = Study(file, DesignSettings(cells=2), SerialRunner()).short()
    stiffness = np.array([[600 + 1500 + 1e6, -1500], [-1500, 1500 + 5e5]])
    armature, bridge = np.linalg.solve(stiffness, [25 - 6 - 4 + 1e6 * 3e-3, 4 + 5e5 * 2e-3])
    forces = {
        "return spring": 600 * armature,
        "contact spring": 1500 * (bridge - armature),
        "backstop": 0.0,
        "shoulder": 0.0,
        "core": 1e6 * (armature - 3e-3),
        "contact": 5e5 * (bridge - 2e-3),
    }
    rows = [part for name, force in forces.items() for part in (name, f"{force:.3g} N".replace("-", "−"))]
    report = DesignReport("Contactor", {}, origin_of([file], "2026-01-01"), design, None)
    assert " | ".join(["", "Part", "Force at rest", *rows]) + "\n" in markdown_lines(to_markdown(report))
