import json
from pathlib import Path

from report.document.document import Document
from report.pages.formats import Format
from report.rendering.json import to_json
from tests.json_document import documented, keys


def test_all_claims_are_there_in_thesis_order_with_the_keys_of_the_document(document: Document) -> None:
    content = json.loads(to_json(document))
    assert content["schema"] == 2
    assert [claim["id"] for claim in content["claims"]] == [finding.id for finding in document.findings]
    assert set(keys(content)) == documented("claims.json of trimmer report")


def test_the_file_is_utf_8_and_ends_with_a_line_end(rendered, document) -> None:
    text = Path(rendered[Format.JSON]).read_bytes().decode("utf-8")
    assert text == to_json(document)
    assert text.endswith("}\n")
    assert "−60" in text
