import dataclasses

import pytest

from report.document.document import Document
from report.pages.links import BrokenLinkError
from report.rendering.markdown import to_markdown
from report.rendering.selection import select
from report.rendering.sources import sources


def test_a_part_of_the_report_has_the_files_of_its_findings_only(document: Document) -> None:
    assert [source.path for source in sources(select(document, ["appA"]))] == ["derivations/mechanism.py"]


@pytest.mark.parametrize("path", ["derivations/no_such_file.py", "derivations", ""])
def test_a_source_that_is_not_a_file_is_an_error_that_names_the_claim(document: Document, path: str) -> None:
    part = select(document, ["appA"])
    (chapter,) = part.chapters
    findings = tuple(dataclasses.replace(finding, source=path) for finding in chapter.findings)
    changed = dataclasses.replace(part, chapters=(dataclasses.replace(chapter, findings=findings),))
    with pytest.raises(BrokenLinkError, match=rf"lst-A\.1 is derived in '{path}'"):
        to_markdown(changed)
