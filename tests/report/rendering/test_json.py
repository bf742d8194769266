import json
from collections.abc import Mapping
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


def test_a_claim_with_one_part_speaks_for_it(document: Document) -> None:
    claims = {claim["id"]: claim for claim in json.loads(to_json(document))["claims"]}
    claim = claims["txt-5.1.2-roll-off"]
    assert (claim["printed"], claim["derived"]) == ("-60 dB/decade", "-40 dB/decade")
    assert claim["verdict"] == "erratum"
    assert claim["parts"][0]["printed"] == "-60 dB/decade"


def test_a_claim_with_several_parts_joins_them_behind_their_labels(document: Document) -> None:
    claims = {claim["id"]: claim for claim in json.loads(to_json(document))["claims"]}
    claim = claims["eq-2.37"]
    assert (
        claim["printed"]
        == r"first line: \frac{A}{4}; second line: \frac{b^{2} - 2 A b}{A}; third line: -1.05e-3 m"
    )
    assert claim["slip"].startswith("second line: ")
    assert [part["verdict"] for part in claim["parts"]] == ["reproduced", "erratum", "explained"]


def test_the_file_is_utf_8_and_ends_with_a_line_end(
    rendered: Mapping[Format, Path], document: Document
) -> None:
    text = Path(rendered[Format.JSON]).read_bytes().decode("utf-8")
    assert text == to_json(document)
    assert text.endswith("}\n")
    assert "−60" in text
