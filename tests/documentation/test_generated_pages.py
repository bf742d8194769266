"""The reference holds every public name, command, option, key and formula."""

import re
from importlib import import_module
from pathlib import Path

import pytest

from scripts.site.built import loaded_from_elsewhere
from scripts.site.command_pages import command_pages
from scripts.site.library_pages import library_pages
from scripts.site.mathematics import FormulaError, with_mathml
from scripts.site.output_lines import with_wrapped_sentences
from scripts.site.schema_tables import mechanism_keys, parameter_page
from tests.public_names import public_names
from trimmer.command_line.main import installed_commands
from trimmer.mechanism.quantities import PARTS, QUANTITIES
from trimmer.thesis import parameter_table


def test_every_public_name_has_its_place(project_folder: Path) -> None:
    pages = library_pages(project_folder)
    found = [
        each for _, page in pages.values() for each in re.findall(r"^::: (trimmer[.\w]*)\.(\w+)$", page, re.M)
    ]
    assert sorted(name for _, name in found) == sorted(public_names())
    assert all(hasattr(import_module(place), name) for place, name in found)


def test_every_command_has_its_page_with_its_examples() -> None:
    pages = command_pages()
    commands = installed_commands()
    assert set(pages) == {"index", *(command.name for command in commands)}
    for command in commands:
        page = pages[command.name][1]
        assert f"`trimmer {command.name}`" in pages["index"][1]
        assert all(example.words in page for example in command.examples)
    assert "<code>--vary PLACE=A:B:N</code>" in pages["map"][1]
    assert "| 130 | interrupted |" in pages["index"][1]


def test_mechanism_page_names_every_section_and_key(project_folder: Path) -> None:
    page = (project_folder / "docs" / "mechanism.md").read_text(encoding="utf-8")
    table = mechanism_keys()
    for section, kind in PARTS.items():
        assert f"`[{section}]`" in page and f"`[{section}]`" in table
        for key in QUANTITIES[kind]:
            assert f"`{key}`" in page and f"`{key}`" in table


def test_parameter_page_names_every_parameter() -> None:
    page = parameter_page()
    assert all(f"| `{each.symbol}` | {each.meaning} |" in page for each in parameter_table())


def test_formulas_become_mathml() -> None:
    inline = r'<p><span class="arithmatex">\(a &lt; \omega\)</span></p>'
    page = with_mathml(inline + r'<div class="arithmatex">\[\frac{1}{2}\]</div>')
    assert page.count("<math") == 2
    assert 'display="inline"' in page and 'display="block"' in page
    assert "arithmatex" not in page and "ω" in page


def test_a_formula_that_cannot_be_read_is_an_error() -> None:
    with pytest.raises(FormulaError, match="frac"):
        with_mathml(r'<span class="arithmatex">\(\frac{1\)</span>')


def test_sentences_of_an_output_wrap_and_columns_do_not() -> None:
    sentence, row = "It " + 20 * "is so " + ".", 20 * "1.5    "
    page = f'<div class="highlight"><pre><span></span><code>{sentence}\n{row}\nshort</code></pre></div>'
    wrapped = with_wrapped_sentences(page)
    assert f'<span class="sentence">{sentence}</span>\n{row}\nshort' in wrapped
    assert wrapped.startswith('<div class="highlight output">')
    code = (
        '<div class="highlight"><pre><span></span><code><span class="kn">import</span> x</code></pre></div>'
    )
    assert with_wrapped_sentences(code) == code


def test_what_is_loaded_from_elsewhere_is_found(tmp_path: Path) -> None:
    (tmp_path / "page.html").write_text(
        '<a href="https://example.org">fine</a><img src="//example.org/a.png"><link href="own.css">', "utf-8"
    )
    (tmp_path / "own.css").write_text("@font-face { src: url(https://example.org/a.woff2) }", "utf-8")
    assert list(loaded_from_elsewhere(tmp_path)) == [
        "own.css: https://example.org/a.woff2",
        "page.html: //example.org/a.png",
    ]
