import dataclasses
from pathlib import Path

import pytest

from report.document.document import Document
from report.pages.links import BrokenLinkError
from report.rendering.markdown import to_markdown
from report.rendering.selection import select
from report.rendering.sources import identifier, sources

MECHANISM, LOW_PASS = "derivations/mechanism.py", "trimmer/linear/low_pass.py"


def test_each_file_that_a_finding_names_is_there_once_with_its_text_and_its_findings(
    document: Document, project_folder: Path
) -> None:
    mechanism, low_pass = sources(document)
    assert (mechanism.path, low_pass.path) == (MECHANISM, LOW_PASS)
    assert low_pass.text == (project_folder / LOW_PASS).read_text(encoding="utf-8")
    assert [finding.id for finding in low_pass.findings] == ["txt-5.1.2-roll-off"]
    assert len(mechanism.findings) == len(document.findings) - 1


def test_a_part_of_the_report_has_the_files_of_its_findings_only(document: Document) -> None:
    assert [source.path for source in sources(select(document, ["appA"]))] == [MECHANISM]


def test_a_place_is_named_after_the_path() -> None:
    assert (
        identifier("trimmer/elements/backlashes/friction_backlash.py")
        == "code-trimmer-elements-backlashes-friction_backlash"
    )


@pytest.mark.parametrize("path", ["derivations/no_such_file.py", "derivations", ""])
def test_a_source_that_is_not_a_file_is_an_error_that_names_the_claim(document: Document, path: str) -> None:
    part = select(document, ["appA"])
    (chapter,) = part.chapters
    findings = tuple(dataclasses.replace(finding, source=path) for finding in chapter.findings)
    changed = dataclasses.replace(part, chapters=(dataclasses.replace(chapter, findings=findings),))
    with pytest.raises(BrokenLinkError, match=rf"lst-A\.1 is derived in '{path}'"):
        to_markdown(changed)
