"""Pages of the gallery: a picture, its script and what it prints for each of ``examples/scripts``."""

from collections.abc import Iterable, Mapping

from scripts.site.example_scripts import ExampleScript

SECTIONS: Mapping[str, tuple[str, ...]] = {
    "Linear models and describing functions": (
        "linear_model",
        "describing_functions",
        "textbook_elements",
        "own_element",
    ),
    "Loops": ("limit_cycles", "certificate", "exact_orbits"),
    "Mechanisms": ("play_map", "branch", "basin", "chaos", "energy"),
    "Classics": ("servo", "den_hartog", "stick_slip"),
    "Measured": ("measured_signal",),
}
"""Scripts by subject, in the order of the gallery."""


def gallery_pages(scripts: Iterable[ExampleScript]) -> dict[str, tuple[str, str]]:
    """Return title and Markdown of each page by its name; ``index`` shows all pictures.

    Raises:
        ValueError: if a script stands in no section, or a section names one that is not there.
    """
    known = {script.name: script for script in scripts}
    named = [name for names in SECTIONS.values() for name in names]
    if sorted(named) != sorted(known):
        raise ValueError(f"gallery.py names {sorted(named)}, examples/scripts holds {sorted(known)}")
    pages = {name: (known[name].title, _page(known[name])) for name in named}
    return {"index": ("Gallery", _overview(known)), **pages}


def _overview(scripts: Mapping[str, ExampleScript]) -> str:
    parts = ["# Gallery", "Each picture is made by a short script, which you can run as it is."]
    for title, names in SECTIONS.items():
        cards = "\n".join(_card(scripts[name]) for name in names)
        parts.append(f'## {title}\n\n<div class="gallery" markdown>\n\n{cards}\n\n</div>')
    return "\n\n".join(parts) + "\n"


def _card(script: ExampleScript) -> str:
    return f"- [![]({script.name}.svg) {script.title}]({script.name}.md)"


def _page(script: ExampleScript) -> str:
    source = f"../examples/scripts/{script.path.name}"
    return "\n\n".join(
        [
            f"# {script.title}",
            f"![{script.title}]({script.name}.svg)",
            script.caption,
            f"[{script.path.name}]({source}):",
            f"```python\n{script.code.rstrip()}\n```",
            f"prints\n\n```text\n{script.printed.rstrip()}\n```\n",
        ]
    )
