"""What MkDocs calls: adds generated pages and files that stand elsewhere, and turns formulas into MathML."""

import io
import re
import zipfile
from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path, PurePosixPath
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.exceptions import BuildError
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

from benchmarks.problems import publish
from report.pages.policy import with_policy_of_site
from scripts.site.built import loaded_from_elsewhere
from scripts.site.command_pages import command_pages
from scripts.site.example_scripts import ExampleScript, ScriptError, example_scripts, run_script
from scripts.site.gallery import gallery_pages
from scripts.site.library_pages import library_pages
from scripts.site.mathematics import with_mathml
from scripts.site.notebooks import notebooks, write_page
from scripts.site.output_lines import with_wrapped_sentences
from scripts.site.pictures import kept, own_pictures
from scripts.site.running import PageError, run_page
from scripts.site.schema_tables import mechanism_keys, parameter_page

PROJECT = Path(__file__).resolve().parents[2]
LIBRARY, COMMANDS = "reference/library", "reference/command-line"
GALLERY, NOTEBOOKS = "gallery", "notebooks"
MACHINES = "examples/mechanisms.md"
MECHANISM, PARAMETERS = "mechanism.md", "reference/parameters.md"
PROBLEMS = "problems.md"
COPIED = {
    "report/fonts/stix-two-math.woff2": "fonts/stix-two-math.woff2",
    "report/fonts/STIX-Two-Math-LICENSE.txt": "fonts/STIX-Two-Math-LICENSE.txt",
    "examples/README.md": MACHINES,
}
"""Files that stand elsewhere, and where they are in the site."""
DOWNLOADS = {".toml", ".csv", ".py", ".ipynb", ".json"}
"""Endings of the files in ``examples`` that the site offers."""
ARCHIVE = "examples.zip"
"""All of them in one file."""
NEEDS_EXAMPLES = re.compile(r"^(?!from|import).*(?<![/\w])examples/[\w-]+\.toml", re.MULTILINE)
OUTSIDE = re.compile(r"\]\((?:\.\./)+(examples/|docs/)")

Pages = Mapping[str, tuple[str, str]]
"""Title and Markdown by the name of the page."""


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Add the generated pages to the navigation."""
    pages = _generated()
    reference = _section(config, "Reference")
    reference.append({"Command line": _entries(COMMANDS, pages[COMMANDS])})
    reference.append({"Library": _entries(LIBRARY, pages[LIBRARY])})
    _section(config, "Examples").insert(0, {"Gallery": _entries(GALLERY, pages[GALLERY])})
    return config


def on_files(files: Files, *, config: MkDocsConfig) -> Files:
    """Add the generated pages, the pictures, and the files that stand elsewhere."""
    for folder, pages in _generated().items():
        for name, (_, content) in pages.items():
            files.append(File.generated(config, f"{folder}/{name}.md", content=content))
    files.append(File.generated(config, PARAMETERS, content=parameter_page()))
    for source, target in {**COPIED, **_downloads()}.items():
        files.append(File.generated(config, target, abs_src_path=str(PROJECT / source)))
    files.append(File.generated(config, ARCHIVE, content=_archive()))
    for name, content in {
        PROBLEMS: publish.page,
        "problems.json": publish.as_json,
        "digits.csv": publish.as_csv,
    }.items():
        files.append(File.generated(config, name, content=content()))
    for target, path in [*_pictures(files), *_gallery(), *_notebooks()]:
        files.append(File.generated(config, target, abs_src_path=str(path)))
    return files


def on_page_markdown(markdown: str, *, page: Page, **_: Any) -> str:
    """Let links between ``docs`` and ``examples`` lead to where these are in the site, and add tables."""
    if page.file.src_uri == MECHANISM:
        markdown = f"{markdown}\n{mechanism_keys()}"
    if NEEDS_EXAMPLES.search(markdown):
        title, _, rest = markdown.partition("\n\n")
        there = f"{_up(page)}{ARCHIVE}"
        told = (
            f"*The files in `examples/` are in [{ARCHIVE}]({there}); unpack it in the folder where you work.*"
        )
        markdown = f"{title}\n\n{told}\n\n{rest}"
    inside = OUTSIDE.sub(lambda match: f"]({_inside(match[1], page)}", markdown)
    return inside.replace("examples/README.md", MACHINES)


def on_page_content(html: str, **_: Any) -> str:
    """Turn formulas into MathML, and wrap the sentences of what is printed."""
    return with_wrapped_sentences(with_mathml(html))


def on_post_page(output: str, **_: Any) -> str:
    """Let a page load nothing but the site's own files."""
    return with_policy_of_site(output)


def on_post_build(*, config: MkDocsConfig) -> None:
    """Look whether something would be loaded from elsewhere."""
    if found := list(loaded_from_elsewhere(Path(config.site_dir))):
        raise BuildError("loaded from elsewhere:\n" + "\n".join(found))


def _generated() -> Mapping[str, Pages]:
    """Return the pages that are written by code, by their folder."""
    return {
        COMMANDS: command_pages(),
        LIBRARY: library_pages(PROJECT),
        GALLERY: gallery_pages(example_scripts()),
    }


def _section(config: MkDocsConfig, title: str) -> list[Any]:
    return next(entry[title] for entry in config.nav or [] if title in entry)


def _entries(folder: str, pages: Pages) -> list[Mapping[str, str] | str]:
    index, *others = pages.items()
    return [f"{folder}/{index[0]}.md", *({title: f"{folder}/{name}.md"} for name, (title, _) in others)]


def _downloads() -> dict[str, str]:
    found = (path for path in (PROJECT / "examples").rglob("*") if path.suffix in DOWNLOADS)
    names = sorted(path.relative_to(PROJECT).as_posix() for path in found)
    return {name: name for name in names}


def _archive() -> bytes:
    """Return ``examples`` as a ZIP file, whose bytes depend on the files alone."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in _downloads():
            entry = zipfile.ZipInfo(name)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, (PROJECT / name).read_bytes())
    return content.getvalue()


def _pictures(files: Files) -> Iterator[tuple[str, Path]]:
    """Run the pages that show pictures of their own; yield where these go in the site, and where they are."""
    for page in files.documentation_pages():
        if page.abs_src_path is None:
            continue
        path = Path(page.abs_src_path)
        if names := own_pictures(path.read_text(encoding="utf-8"), path.stem):
            folder = kept(page.src_uri, path, partial(_run_page, path))
            for name in names:
                yield str(PurePosixPath(page.src_uri).with_suffix("") / name), folder / name


def _gallery() -> Iterator[tuple[str, Path]]:
    for script in example_scripts():
        folder = kept(f"{GALLERY}/{script.name}", script.path, partial(_run_script, script))
        yield f"{GALLERY}/{script.name}.svg", folder / f"{script.name}.svg"


def _notebooks() -> Iterator[tuple[str, Path]]:
    for path in notebooks():
        folder = kept(f"{NOTEBOOKS}/{path.stem}", path, partial(write_page, path))
        yield f"{NOTEBOOKS}/{path.stem}.md", folder / "page.md"
        for picture in sorted(folder.glob("*.png")):
            yield f"{NOTEBOOKS}/{picture.name}", picture


def _run_page(page: Path, folder: Path) -> None:
    try:
        run_page(page, folder, slow=True)
    except PageError as error:
        raise BuildError(str(error)) from error


def _run_script(script: ExampleScript, folder: Path) -> None:
    try:
        run_script(script, folder / f"{script.name}.svg")
    except ScriptError as error:
        raise BuildError(str(error)) from error


def _inside(folder: str, page: Page) -> str:
    """Return the way from a page to a folder beside ``docs``, which the site has among its pages."""
    return _up(page) + ("" if folder == "docs/" else folder)


def _up(page: Page) -> str:
    return "../" * page.file.src_uri.count("/")
