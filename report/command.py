"""``trimmer report``: derive, solve, judge and write the report."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command

if TYPE_CHECKING:
    from report.build import Built

DIRECTORY = Path("build") / "report"


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--directory",
        type=Path,
        metavar="DIR",
        default=DIRECTORY,
        help="folder for report.html, report.pdf, claims.json and build.log (default: %(default)s)",
    )


def _run(arguments: Namespace) -> int:
    from report.build import build

    print(_summary(build(arguments.directory)))
    return 0


def _summary(built: Built) -> str:
    from report.claim import Verdict

    verdicts = [finding.verdict for finding in built.document.findings]
    counts = ", ".join(f"{verdicts.count(verdict)} {verdict.value}" for verdict in Verdict)
    paths = (built.files.html, built.files.pdf, built.files.claims, built.log)
    return "\n".join(
        (
            f"{len(verdicts)} claims judged in {built.seconds:.1f} s: {counts}",
            *(f"  {path}" for path in paths),
        )
    )


COMMAND = Command(
    "report", "build the report: derive, solve, judge, draw, write HTML, PDF and JSON", _configure, _run
)
