"""`trimmer judge`: a text of one's own is judged by the same build; what is wrong in its folder is told."""

import base64
import json
import tomllib
from collections import Counter
from importlib.metadata import version
from pathlib import Path

import pytest

from report.building.folder import read_folder
from report.building.folder_content import folder_content
from report.building.progress import Progress
from report.cache.stage_store import StageStore
from report.document.document import Document
from report.judging.verdict import Certainty, Grade, grade
from report.rendering.markdown import to_markdown
from trimmer.command_line.main import main

FILES = {
    "judge.toml": 'title = "Sums & <b>more</b>"\ncalled = "paper"\ntext = "text.md"\n[sections]\n1 = "One"\n',
    "inventory.csv": "id,kind,section,subject,severity\neq-1,equation,1,a sum,result\n"
    "fig-1,figure,1,a line,slip\n",
    "text.md": "1 + 1 = 2\n",
    "claims.py": """
from matplotlib.figure import Figure
from report.judging.figure import figure
from report.judging.parts import close, digits
from report.judging.record import claim, text
from .evidence import TWO

@claim("eq-1")
def total(known):
    yield digits("sum", "2", known, second=close("the exact orbit", TWO, known))
    yield text("It is two.")

@claim("fig-1")
def line(known):
    yield digits("end", "4", known)
    yield text("It ends at two.")

@figure("fig-1", title="Line", caption="A line.", alternative_text="A line.")
def drawn(known):
    return Figure()
""",
    "evidence.py": "TWO = 2.0\ndef gather():\n    return 1.0 + 1.0\n",
}


@pytest.fixture(autouse=True)
def commands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, project_folder: Path) -> None:
    """The commands that this checkout names, whatever was installed when."""
    project = tomllib.loads((project_folder / "pyproject.toml").read_text("utf-8"))["project"]
    named = project["entry-points"]["trimmer.commands"].items()
    number = version("trimmer")
    installed = tmp_path / "installed" / f"trimmer-{number}.dist-info"
    installed.mkdir(parents=True)
    (installed / "METADATA").write_text(f"Metadata-Version: 2.1\nName: trimmer\nVersion: {number}\n", "utf-8")
    lines = "\n".join(f"{name} = {target}" for name, target in named)
    (installed / "entry_points.txt").write_text(f"[trimmer.commands]\n{lines}\n", "utf-8")
    monkeypatch.syspath_prepend(installed.parent)
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "mine"
    folder.mkdir()
    for name, content in FILES.items():
        (folder / name).write_text(content, "utf-8")


def document(folder: Path, tmp_path: Path) -> Document:
    return folder_content(read_folder(folder), Progress(), StageStore(tmp_path / "kept"))


def test_a_text_of_ones_own_is_judged(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["judge", "mine", "--format", "html", "json", "--quiet"]) == 0
    written = {f"  build/judge/{each}" for each in ("report.html", "claims.json", "build.log")}
    assert set(capsys.readouterr().out.splitlines()[1:]) == written
    claims = json.loads((tmp_path / "build/judge/claims.json").read_text("utf-8"))["claims"]
    assert [(c["id"], c["verdict"]) for c in claims] == [("eq-1", "reproduced"), ("fig-1", "erratum")]
    assert claims[0]["source"] == "claims.py" and "confirmed by the exact orbit" in claims[0]["method"]
    page = (tmp_path / "build/judge/report.html").read_text("utf-8")
    assert all(each in page for each in ("Sums &amp; &lt;b&gt;more", "Paper, our wording", "known, second="))
    assert main(["judge", "mine", "--format", "json", "--compare", "build/judge/claims.json", "--quiet"]) == 0


def test_nothing_tells_of_the_thesis(tmp_path: Path) -> None:
    told = " ".join(to_markdown(document(tmp_path / "mine", tmp_path)).values()).lower()
    assert not [
        word
        for word in ("thesis", "designer", "leine", "trimmer report", "drawing was not seen")
        if word in told
    ]


PNG = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg=="
)
"""A picture of one pixel."""
PICTURES = {"bad.svg": b"", "web.svg": b"<html/>", "bad.png": b"no picture", "cut.png": PNG[:45]}
CLAIMS, LIST, WORDS = "claims.py", "inventory.csv", "judge.toml"
REFUSED = [
    (WORDS, None, "", "mine/judge.toml: is not there; write it, with title, called, text and sections"),
    (WORDS, "called", "caled", "mine/judge.toml: 'caled' is no key of it; did you mean called?"),
    (WORDS, "title =", "title", "mine/judge.toml: cannot be read: "),
    (WORDS, 'called = "paper"\n', "", "mine/judge.toml: lacks called; add it"),
    (WORDS, '"paper"', "3", 'mine/judge.toml: called = 3: write a line of text, such as called = "…"'),
    (WORDS, '1 = "One"', "", "mine/judge.toml: sections = {}: write [sections], a line 1 = \"Title\" each"),
    (WORDS, "1 =", '"1 a" =', "mine/judge.toml: sections: '1 a' is no number; write 2"),
    ("text.md", None, "", "mine/judge.toml: text = 'text.md': mine/text.md: cannot be read: No such file"),
    (LIST, None, "", "mine/inventory.csv: is not there; write it, with the columns id, kind, section and su"),
    (LIST, "kind", "sort", "inventory.csv, line 1: lacks kind; it names the columns"),
    (LIST, "figure", "poem", "inventory.csv, line 3: unknown kind 'poem'; there are equation, figure, table"),
    (LIST, "a sum", "a, sum", "inventory.csv, line 2: not as many columns as line 1 names; quote a comma"),
    (LIST, "result", "grave", "inventory.csv, line 2: severity 'grave' is not known; there are conclusion"),
    (LIST, "eq-1", "eq 1", "mine/inventory.csv, line 2: the id 'eq 1': write letters, digits and -_.: alone"),
    (LIST, "equation,1", "equation,2.1", 'eq-1: section \'2.1\' has no title; add "2.1" = "…" below [sectio'),
    (LIST, "severity\n", "source\n", "mine/inventory.csv, line 2: eq-1: source 'result' is no file"),
    (LIST, "severity\n", "sevrity\n", "inventory.csv, line 1: 'sevrity' is no column of it; did you mean"),
    (LIST, "severity\n", "id\n", "inventory.csv, line 1: names the column id twice; keep one"),
    (LIST, "1,a sum", "1, ", "inventory.csv, line 2: subject must not be empty"),
    (LIST, "severity\n", "paragraph\n", "inventory.csv, line 2: paragraph 'result' is no number of a"),
    (LIST, ",slip", ",none", "fig-1, end: it is wrong, and has no severity; write conclusion, result"),
    ("text.md", "1 + 1 = 2", "![](sum.svg)", "mine/text.md, line 1: shows the picture 'sum.svg', which is"),
    ("text.md", "1 + 1 = 2", "![](bad.svg)", "line 1: shows the picture 'bad.svg', which is damaged: no"),
    ("text.md", "1 + 1 = 2", "![](web.svg)", "'web.svg', which is damaged: its outermost element is html"),
    ("text.md", "1 + 1 = 2", "![](bad.png)", "which is damaged: cannot identify image file"),
    ("text.md", "1 + 1 = 2", "![](cut.png)", "'cut.png', which is damaged: "),
    (LIST, "fig-1,figure,1,a line,slip\n", "", "mine/claims.py: fig-1 is not in the inventory; add a line t"),
    (LIST, "slip\n", "slip\neq-2,equation,1,b,\n", "eq-2: in the inventory, but without a record; write one"),
    (LIST, ",slip", ",", "fig-1, end: it is wrong, and has no severity; wr"),
    (CLAIMS, '@claim("fig-1")', '@claim("eq-1")', "eq-1 stands twice, in mine/claims.py and mine/claims.py;"),
    (CLAIMS, "\nfrom", "\n1 / 0\nfrom", "mine/claims.py, line 2: importing the modules ended with ZeroDivis"),
    (CLAIMS, "\nfrom", "\nexit(3)\nfrom", "mine/claims.py, line 2: importing the modules ended with SystemE"),
    (CLAIMS, "total(known):", "total(known)", "mine/claims.py, line 9: importing the modules ended with Syn"),
    (CLAIMS, 'digits("sum"', 'known / 0, digits("sum"', "mine/claims.py, line 10: the claim eq-1 ended with"),
    (CLAIMS, 'yield text("It is two.")', "", "mine/claims.py: claim eq-1 has 0 texts; it needs one"),
    (CLAIMS, 'yield text("It is two.")', 'yield "two"', "claim eq-1 yields 'two', which is no part"),
    (CLAIMS, '"2", known', '"2", known * float("nan")', "part 'sum': nan is no number to hold against '2'"),
    (CLAIMS, "return Figure()", "return None", "mine/claims.py: figure fig-1: what draws it returns no"),
    (CLAIMS, '"2", known', '"two", known', "'two' is no string of digits such as '8.28' or '2.1e-8'"),
    (CLAIMS, "TWO, known", "3, known", "by the exact orbit disagree (relative difference at most 1e-09)"),
    (CLAIMS, "It is two.", "See [it](#eq-9).", "mine/claims.py: the claim eq-1 links to #eq-9, a place that"),
    (CLAIMS, "It ends", r"$\\frac{1 x$ ends", "mine/claims.py: the claim fig-1 has a formula that cannot be"),
    (CLAIMS, '="A line.", alt', r'="$\\frac{1 x$.", alt', "mine/claims.py: the claim fig-1 has a formula"),
    (CLAIMS, "\nfrom", "\nimport os; os._exit(0)\nfrom", "mine: importing the modules ended the whole pr"),
    (CLAIMS, 'yield text("It is', 'import os; os._exit(0); yield text("It is', "the claim eq-1 ended the"),
    (CLAIMS, "return Figure()", "import os; os._exit(2)", "claims.py: the figure fig-1 ended the whole proc"),
    (CLAIMS, "return Figure()", "return 1 / 0", "mine/claims.py, line 20: the figure fig-1 ended with ZeroD"),
    ("evidence.py", "1.0 + 1.0", "1 / 0", "mine/evidence.py, line 3: gather() ended with ZeroDivisionError:"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "old", "new", "sentence"), REFUSED, ids=[each[3][:50] for each in REFUSED])
def test_what_is_wrong_in_a_folder_is_told(tmp_path, capsys, name, old, new, sentence) -> None:
    for picture, stored in PICTURES.items():
        (tmp_path / "mine" / picture).write_bytes(stored)
    file = tmp_path / "mine" / name
    content = file.read_text("utf-8")
    assert old is None or old in content
    file.unlink()
    if old is not None:
        file.write_text(content.replace(old, new, 1), "utf-8")
    assert main(["judge", "mine", "--format", "html", "--quiet"]) == 2
    told = " ".join(capsys.readouterr().err.split())
    assert sentence in told and told.startswith("trimmer: ") and "Traceback" not in told


def test_what_is_no_folder_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["judge", "elsewhere"]) == 2
    assert "elsewhere: is no folder; give one with judge.toml and inventory.csv" in capsys.readouterr().err


def test_the_example_is_short_and_lists_its_equations(project_folder: Path) -> None:
    folder = project_folder / "examples" / "judged-paper"
    judged = read_folder(folder)
    code = "".join(path.read_text("utf-8") for path in folder.glob("*.py"))
    words = "".join((folder / name).read_text("utf-8") for name in (LIST, WORDS))
    assert (code + words).count("\n") <= 200
    assert Counter(entry.kind.value for entry in judged.inventory.values())["equation"] == 8
    assert all(f'@claim("{claim_id}")' in code for claim_id in judged.inventory)
    for claim_id, entry in judged.inventory.items():
        assert entry.lines is not None
        passage = "\n".join(judged.copy.passage(entry.lines))
        assert entry.kind.value != "equation" or rf"\tag{{{claim_id.removeprefix('eq-')}}}" in passage


@pytest.mark.slow
def test_the_planted_faults_of_the_example_are_found(tmp_path: Path, project_folder: Path) -> None:
    found = document(project_folder / "examples" / "judged-paper", tmp_path)
    wrong = {each.id: each for each in found.findings if each.verdict.is_wrong}
    assert {claim_id: grade(each) for claim_id, each in wrong.items()} == {
        "txt-natural-frequency": Grade.SLIP,
        "eq-5": Grade.RESULT,
        "tab-1": Grade.RESULT,
        "fig-2": Grade.RESULT,
        "txt-safe-side": Grade.CONCLUSION,
    }
    assert wrong["eq-5"].certainty is Certainty.PROVEN
    assert [part.label for part in wrong["tab-1"].parts if part.verdict.is_wrong] == ["amplitude at 1.2"]
    assert all("confirmed by" in " ".join(part.method for part in each.parts) for each in wrong.values())
    assert wrong["fig-2"].parts[0].slip == wrong["txt-safe-side"].parts[0].slip != ""
    assert grade(found.findings[0]) is Grade.REPRODUCED
