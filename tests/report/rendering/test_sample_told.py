"""The sample's report tells what it told; ``python -m tests.report.rendering.test_sample_told`` renews it."""

from importlib.metadata import version
from pathlib import Path

from report.rendering.json import to_json
from report.rendering.markdown import to_markdown
from tests.report.markdown_lines import markdown_lines
from tests.report.rendering.sample import sample

TOLD = Path(__file__).with_name("sample_told.txt")


def told() -> str:
    """Return its Markdown and its file of claims."""
    document = sample()
    return (markdown_lines(to_markdown(document)) + to_json(document)).replace(version("trimmer"), "VERSION")


def test_the_sample_tells_what_it_told() -> None:
    assert told().splitlines() == TOLD.read_text("utf-8").splitlines()


if __name__ == "__main__":
    TOLD.write_text(told(), "utf-8")
