"""Links inside a report: each has to lead somewhere."""

import re
from collections.abc import Iterable

_INTERNAL_LINK = re.compile(r"\]\(#([^)\s]+)\)")
_LINK_IN_TYPST = re.compile(r"#link\(<([^>]+)>\)")
_LABEL_IN_TYPST = re.compile(r"(?<!\()<([\w.-]+)>")
_IDENTIFIER = re.compile(r"(?<=[{ ])#([^\s}#]+)(?=[^{}\n]*\}\s*$)", re.MULTILINE)


class BrokenLinkError(ValueError):
    """The report links to a place that it does not have, or has the same place twice.

    Attributes:
        places: Those that it links to and does not have, if that is what is wrong.
    """

    def __init__(self, message: str, places: Iterable[str] = ()) -> None:
        super().__init__(message)
        self.places = tuple(places)


def check_links(markdown: str, elsewhere: Iterable[str]) -> None:
    """Check that places, here and elsewhere, have names of their own and that each link leads to one.

    Raises:
        BrokenLinkError: listing the names that stand twice, or the links that lead nowhere.
    """
    identifiers = [*_IDENTIFIER.findall(markdown), *elsewhere]
    twice = sorted({identifier for identifier in identifiers if identifiers.count(identifier) > 1})
    if twice:
        raise BrokenLinkError(
            f"the report has these identifiers twice, rename one of each: {', '.join(twice)}"
        )
    broken = sorted(set(_INTERNAL_LINK.findall(markdown)) - set(identifiers))
    if broken:
        raise BrokenLinkError(
            f"the report links to places it does not have: {', '.join(broken)}; "
            "correct the link or add the claim, step or figure",
            broken,
        )


def leading_elsewhere(source: str, file: str) -> str:
    """Return Typst source whose links to places that it does not have lead to those of a PDF beside it."""
    here = set(_LABEL_IN_TYPST.findall(source))
    return _LINK_IN_TYPST.sub(
        lambda link: link[0] if link[1] in here else f'#link("{file}#nameddest={link[1]}")', source
    )
