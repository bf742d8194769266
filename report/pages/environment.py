"""The environment of all templates that give Markdown: what they print is escaped unless it is Markdown."""

from collections.abc import Iterable
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined, nodes
from markupsafe import Markup

from report.pages import escaping
from report.pages.escaping import Markdown
from report.pages.pieces import TEMPLATES


class MarkdownEnvironment(Environment):
    """Jinja's escaping by type, with that of Markdown in the place of that of HTML."""

    def __init__(self) -> None:
        super().__init__(
            loader=FileSystemLoader(TEMPLATES),
            undefined=StrictUndefined,
            autoescape=True,
            finalize=lambda value: Markup(escaping.escaped(value)),
            trim_blocks=True,
            lstrip_blocks=True,
            comment_start_string="((*",
            comment_end_string="*))",
        )
        self.filters.update(
            plain=escaping.plain,
            plain_with_mathematics=escaping.plain_with_mathematics,
            prose=escaping.prose,
            attribute=escaping.attribute,
            code=escaping.code,
            identifier=escaping.identifier,
            mathematics=escaping.inline_mathematics,
            digits=escaping.digits,
            join=lambda values, between="": joined(values, between),
        )

    def joined(self, *parts: object) -> str:
        """Do what ``~`` does, so that Jinja's own ``~``, which escapes for HTML, has nothing left to do."""
        found = joined(parts)
        return Markup(found) if isinstance(found, Markdown) else found

    def _generate(self, source: nodes.Template, *arguments: Any, **keywords: Any) -> str:
        """Compile a template whose ``~`` is ``joined``: Jinja's own escapes for HTML."""
        for each in source.find_all(nodes.Concat):
            call = nodes.Call(nodes.EnvironmentAttribute("joined"), each.nodes, [], None, None)
            each.nodes = [call]
        return super()._generate(source, *arguments, **keywords)


def joined(parts: Iterable[object], between: str = "") -> str:
    """Return parts in a row, as plain text if all are, otherwise as Markdown with the others escaped."""
    parts = tuple(parts)
    if any(isinstance(part, Markdown | Markup) for part in parts):
        return escaping.escaped(between).join(map(escaping.escaped, parts))
    return between.join(map(str, parts))
