"""Tables of the keys of TOML files, from the code that checks them."""

from collections.abc import Iterator
from dataclasses import MISSING, Field, fields

from trimmer.mechanism.parts import ContactLaw
from trimmer.mechanism.quantities import PARTS, QUANTITIES, Range
from trimmer.parameters import TrimmerParameters, parameter_table

WORDS = {
    "between": "two names",
    "on": "a name",
    "symbol": "a symbol, such as `k_2`",
    **dict.fromkeys(("mass", "stiffness", "damping"), "a Matrix Market file"),
    "coordinates": "names",
    "rotations": "names of coordinates",
    "modes": "a CSV file",
    "harmonics": "rows of order, amplitude and phase",
    "waveform": "a CSV file",
    "orders": "a whole number",
    "drive": "a name",
    "curve": "rows of two numbers",
    "profile": "rows of time and force",
}
"""What keys may hold that are no numbers."""


def mechanism_keys() -> str:
    """Return a section with all keys of a mechanism file: what is allowed, and the default."""
    lines = [
        "## All keys\n",
        "| section | key | unit | allowed | default |",
        "| --- | --- | --- | --- | --- |",
    ]
    for section, kind in PARTS.items():
        for number, each in enumerate(fields(kind)):
            if each.name == "files":  # of Python alone
                continue
            first = f"`[{section}]`" if number == 0 else ""
            lines.append(" | ".join(["|" + first, *_told(kind, each)]) + " |")
    return "\n".join(lines) + "\n"


def parameter_page() -> str:
    """Return the page on the parameter file."""
    thesis = TrimmerParameters.thesis()
    rows = [
        f"| `{each.symbol}` | {each.meaning} | {each.unit} | {getattr(thesis, each.symbol):g} |"
        for each in parameter_table()
    ]
    return "\n".join(
        [
            "# Parameter file\n",
            "The thirteen parameters of the thesis's linear trimmer, one line each, as in `m1 = 0.035`.",
            "[`trimmer parameters`](command-line/parameters.md) writes such a file with the thesis's values;"
            " [`trimmer linear`](command-line/linear.md) and others read it (`--parameters FILE`).\n",
            "| key | meaning | unit | thesis |\n| --- | --- | --- | --- |",
            *rows,
            "\nAll are needed. Masses are positive, stiffness and damping not negative. What is wrong is"
            " named with file, key, value and reason.\n",
        ]
    )


def _told(kind: type, key: Field[object]) -> Iterator[str]:
    quantity = QUANTITIES[kind].get(key.name)
    yield f"`{key.name}`"
    if quantity is not None:
        yield quantity.unit
        yield "any number" if quantity.range is Range.ANY else quantity.range.value
    else:
        yield ""
        yield _words(key.name)
    yield "needed" if key.default is MISSING else _default(key)


def _words(name: str) -> str:
    if name == "law":
        return ", ".join(f'`"{law.word}"`' for law in ContactLaw)
    return WORDS[name]


def _default(key: Field[object]) -> str:
    if isinstance(key.default, ContactLaw):
        return f'`"{key.default.word}"`'
    if key.default in (None, ()):
        return "that of `force`" if key.name == "static" else "none"
    return f"{key.default:g}"
