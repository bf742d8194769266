"""Symbols of all that a mechanism's printed equations hold: those that parts carry, and others like them.

A symbol is text that is LaTeX as it stands, or a name of SymPy such as ``k_2``. No two are the same.
"""

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import count
from keyword import iskeyword
from types import MappingProxyType
from typing import Any

from trimmer.errors import MechanismError
from trimmer.in_symbols.structure_symbols import symbols_of
from trimmer.mechanism import Link, Mechanism, Structure, number_rows
from trimmer.mechanism.kinds import Kind, number_of_weight
from trimmer.mechanism.outputs import UNITS
from trimmer.mechanism.place_text import place_text

Place = tuple[str, str, str]  # Section, part, and what is meant of it

TAKEN = frozenset(
    (
        *("t", "d", "x", "w", "omega", "T", "U", "R", "M", "C", "K", "A", "B"),
        *("F_u", "F_v", "F_p", "F_T", "F_f", "f_0", "P_g", "P_t"),
    )
)
"""Symbols that the printed derivation uses itself."""

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η",
    "theta": "θ", "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π",
    "rho": "ρ", "sigma": "σ", "tau": "τ", "upsilon": "υ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω",
    "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ",
    "Upsilon": "Υ", "Phi": "Φ", "Psi": "Ψ", "Omega": "Ω",
}  # fmt: skip
LAST_LATIN_LETTER = "\u017f"  # LaTeX prints letters up to this one without further packages
PUNCTUATION = " !#%&'()*+,-./:;=?@[]_"
"""What an index may hold beside letters and digits; all that sets formulas sets this alike."""
LONGEST_INDEX = 24
"""A part with a longer name has a number as its index, since a formula has to fit on a page."""


@dataclass(frozen=True)
class Stem:
    """How the symbol of something about a part begins, and what it stands for."""

    of: str  # A field of the part, or a word for a function of time
    form: str  # The letter; ``%s`` stands for the letter of the symbol that the part carries
    meaning: str  # What it is; ``%s`` stands for the name of the part
    unit: str  # Its SI unit


@dataclass(frozen=True)
class PrintedSymbol:
    """A symbol of printed equations: LaTeX or a name of SymPy, its meaning, and its SI unit."""

    symbol: str
    meaning: str
    unit: str


_LINK = (Stem("stiffness", "k", "stiffness of %s", "N/m"), Stem("damping", "c", "damping of %s", "N s/m"))
_CONTACT = (
    *_LINK,
    Stem("gap", "g", "gap of %s", "m"),
    Stem("distance", "s", "distance of the ends of %s", "m"),
    Stem("stretch", "z", "stretch of the spring of %s", "m"),
    Stem("tension", "T", "tension of %s", "N"),
)
STEMS: Mapping[str, tuple[Stem, ...]] = MappingProxyType(
    {
        "bodies": (Stem("mass", "m", "mass of %s", "kg"), Stem("coordinate", "q", "displacement of %s", "m")),
        "pins": (
            Stem("displacement", "u", "displacement of %s relative to its carrier", "m"),
            Stem("amplitude", r"\hat{%s}", "amplitude of %s", "m"),
            Stem("phase", r"\varphi", "phase of %s", "rad"),
            Stem("offset", r"\bar{%s}", "offset of %s", "m"),
            Stem("velocity", r"\bar{v}", "constant velocity of %s", "m/s"),
            Stem("waveform", "w", "waveform of %s", "m"),
        ),
        "links": (
            *_LINK,
            Stem("elongation", "e", "elongation of %s", "m"),
            Stem("tension", "T", "tension of the curve of %s", "N"),
        ),
        "plays": (*_CONTACT, Stem("side", "sigma", "side of the contact of %s", "1")),
        "stops": _CONTACT,
        "walls": (
            Stem("restitution", "r", "restitution of %s", "1"),
            Stem("gap", "g", "gap of %s", "m"),
            Stem("distance", "s", "distance of the ends of %s", "m"),
            Stem("tension", "T", "force of %s", "N"),
        ),
        "frictions": (
            Stem("force", "F", "kinetic force of %s", "N"),
            Stem("static", r"%s^{\mathrm{s}}", "static force of %s", "N"),
            Stem("viscous", "d", "viscous coefficient of %s", "N s/m"),
            Stem("rate", "v", "relative velocity of the ends of %s", "m/s"),
            Stem("dry", "f", "dry force of %s", "N"),
        ),
        "forces": (
            Stem("value", "P", "force of %s", "N"),
            Stem("constant", r"\bar{%s}", "constant share of %s", "N"),
            Stem("amplitude", r"\hat{%s}", "amplitude of %s", "N"),
            Stem("phase", r"\psi", "phase of %s", "rad"),
            Stem("unbalance", "epsilon", "unbalance of %s", "kg m"),
            Stem("waveform", "W", "waveform of %s", "N"),
            Stem("profile", "Q", "profile of %s over time", "N"),
        ),
        "controllers": (Stem("value", "u", "force of the controller %s", "N"),),
        "points": (Stem("displacement", "p", "displacement of %s", "m"),),
        "drives": (Stem("omega", "omega", "angular frequency of the drive %s", "rad/s"),),
        "outputs": (Stem("value", "y", "output %s", "m"),),
    }
)
"""What has a symbol of its own, by section; the first is what the symbol that a part carries stands for."""
WEIGHT = "weight of "  # Before the name of a coordinate it is what a point weighs that one with
_TURNING = (
    Stem("inertia", "J", "moment of inertia of %s", "kg m²"),
    Stem("coordinate", "theta", "angle of %s", "rad"),
)
_WORDS = (("displacement", "angle"), ("distance", "angle"), ("force", "moment"), ("tension", "moment"))
"""What is said of a rotation in place of what is said of a translation."""

_SYMBOL = re.compile(r"(?P<letters>[^\W\d_]+)(?P<digits>[0-9]*)(?:_\{?(?P<index>[^{}]+)\}?)?")


def printed_symbols(mechanism: Mechanism) -> Mapping[Place, PrintedSymbol]:
    """Return the symbol of everything that the equations of a mechanism may hold.

    What a part carries no symbol for takes its usual letter, with the index of the symbol that it does
    carry, or else with the name of the part.
    """
    carried = _carried_symbols(mechanism)
    found = dict(carried)
    for section, name, part in _parts(mechanism):
        first, *others = stems_of(mechanism, section, name)
        letters, index = (first.form, None) if (own := _symbol(part)) is None else _split(own)
        parts = list(getattr(mechanism, section))
        alone = section in ("pins", "forces", "outputs") and len(parts) == 1
        preferred = index if own is not None or alone else name
        for stem in others if own is not None else (first, *others):
            if not _occurs(part, stem):
                continue
            form = stem.form % letters if "%s" in stem.form else stem.form
            indices = _indices(preferred, name, 1 + parts.index(name))
            found[section, name, stem.of] = _first_free(form, indices, {*TAKEN, *found.values()})
    printed = {
        (section, name, stem.of): PrintedSymbol(found[section, name, stem.of], stem.meaning % name, stem.unit)
        for section, name, _ in _parts(mechanism)
        for stem in stems_of(mechanism, section, name)
        if (section, name, stem.of) in found
    }
    return printed | dict(_of_structures(mechanism, {*TAKEN, *found.values()}))


def _of_structures(mechanism: Mechanism, used: set[str]) -> Iterator[tuple[Place, PrintedSymbol]]:
    for number, name in enumerate(mechanism.structures, 1):
        for each in symbols_of(mechanism, name):
            indices = _indices(f"{name}{each.index}", f"{number}{each.index}", 1)
            symbol = _first_free(each.letter, indices, used)
            used.add(symbol)
            yield ("structures", name, each.of), PrintedSymbol(symbol, each.meaning, each.unit)


def _of_harmonics(section: str, part: Any) -> Iterator[Stem]:
    """Yield amplitude and phase of each harmonic of a part."""
    for number, _ in enumerate(getattr(part, "harmonics", None) or (), start=1):
        for stem in STEMS[section]:
            if stem.of in ("amplitude", "phase"):
                meaning = f"{stem.of} of harmonic {number} of %s"
                yield replace(stem, of=f"harmonics.{number}.{stem.of}", meaning=meaning)


def _occurs(part: Any, stem: Stem) -> bool:
    """Say whether a part has what a stem stands for; only a curve has a tension beside a link."""
    if stem.of in ("waveform", "profile"):
        return bool(getattr(part, stem.of))
    return not (isinstance(part, Link) and stem.of in ("elongation", "tension")) or part.curve is not None


def stems_of(mechanism: Mechanism, section: str, name: str) -> tuple[Stem, ...]:
    """Return what has a symbol of its own of a part, in the words and units of its kind."""
    if section == "drives":
        return STEMS[section]
    kind = mechanism.kind_of(section, name)
    stems = (*STEMS[section], *_of_harmonics(section, getattr(mechanism, section)[name]))
    if section == "outputs":
        stems = tuple(replace(each, unit=UNITS[mechanism.outputs[name].kind]) for each in stems)
    if kind is Kind.ROTATION:
        stems = _TURNING if section == "bodies" else tuple(map(_turned, stems))
    return (*stems, *(_weights(mechanism, name) if section == "points" else ()))


def _turned(stem: Stem) -> Stem:
    meaning = stem.meaning
    for word, turned in _WORDS:
        meaning = meaning.replace(f"{word} ", f"{turned} ")
    return replace(stem, meaning=meaning, unit=Kind.ROTATION.unit(stem.unit))


def _weights(mechanism: Mechanism, name: str) -> Iterator[Stem]:
    """Yield the weights of a point that are no plain sign, each as an arm or a ratio."""
    for of, weight in mechanism.points[name].weights.items():
        unit = number_of_weight(mechanism.kinds, mechanism.kind_of("points", name), of).unit
        if weight != 0 and (abs(weight) != 1.0 or unit == "m"):
            letter, word = ("r", "arm") if unit == "m" else ("n", "ratio")
            yield Stem(f"{WEIGHT}{of}", letter, f"{word} of {of.replace('%', '%%')} at %s", unit)


def plain_name(symbol: str) -> str:
    """Return a symbol as a name of Python: ``k_2`` as ``k2``; words of an index are joined by underscores.

    Other letters than those from a to z are left out, since Python takes some of them for others.
    """
    words = re.sub(r"\\[a-z]+\{|[\\{}]", " ", symbol)
    name = re.sub(r"_(?=\d+$)", "", "_".join(re.findall("[A-Za-z0-9]+", words)))
    return f"{name}_" if iskeyword(name) else name


def natural_order(name: str) -> list[tuple[int, str]]:
    """Return a key by which q_2 stands before q_10."""
    return [(int(digits or 0), other) for other, digits in re.findall(r"(\D*)(\d*)", name)]


def value_of(mechanism: Mechanism, place: Place) -> float | None:
    """Return the number that a symbol stands for, in SI units; None for a function of time."""
    section, name, of = place
    part = getattr(mechanism, section)[name]
    if isinstance(part, Structure):
        return next(each.value for each in symbols_of(mechanism, name) if each.of == of)
    if section == "drives":
        return math.tau * part
    if of == "static":
        return float(part.static_force)
    if of.startswith("harmonics."):
        return number_rows.value_at(part, *of.split("."))
    if of in ("waveform", "profile"):
        return None
    value = part.weights[of.removeprefix(WEIGHT)] if of.startswith(WEIGHT) else getattr(part, of, None)
    return None if value is None else float(value)


def _carried_symbols(mechanism: Mechanism) -> dict[Place, str]:
    found: dict[Place, str] = {}
    for section, name, part in _parts(mechanism):
        if (own := _symbol(part)) is None:
            continue
        printed = _with_index(*_split(own))
        where = f'{place_text((section, name, "symbol"))} = "{own}"'
        if printed in TAKEN:
            raise MechanismError(
                f'{where}: the derivation uses this symbol itself; add an index, as in "{own}_1"'
            )
        if printed in found.values():
            raise MechanismError(f"{where}: several parts carry this symbol; give each its own")
        found[section, name, stems_of(mechanism, section, name)[0].of] = printed
    return found


def _symbol(part: Any) -> str | None:
    return getattr(part, "symbol", None)


def _parts(mechanism: Mechanism) -> Iterator[tuple[str, str, Any]]:
    for section in STEMS:
        for name, part in getattr(mechanism, section).items():
            yield section, name, part


def _indices(preferred: str | None, name: str, number: int) -> Iterator[str | None]:
    """Yield the indices to try: the preferred one, where None is none at all, the name, and numbers."""
    yield preferred
    yield name
    yield from map(str, count(number))


def _first_free(letters: str, indices: Iterator[str | None], used: set[str]) -> str:
    printable = (index for index in indices if index is None or _is_printable(index))
    return next(symbol for index in printable if (symbol := _with_index(letters, index)) not in used)


def _is_printable(index: str) -> bool:
    return len(index) <= LONGEST_INDEX and all(
        each in PUNCTUATION or (each.isalnum() and each <= LAST_LATIN_LETTER) for each in index
    )


def _split(symbol: str) -> tuple[str, str | None]:
    """Return the letters and the index of a symbol that a part carries."""
    found = _SYMBOL.fullmatch(symbol)
    if found is None:
        raise MechanismError(f'the symbol "{symbol}" is none: write a letter and an index, as in "k_2"')
    letters = _names_of_greek_letters(found["letters"])
    index = ",".join(each for each in (found["digits"], found["index"]) if each)
    letters = letters if len(letters) == 1 or letters in GREEK else rf"\text{{{letters}}}"
    return letters, _names_of_greek_letters(index) or None


def _names_of_greek_letters(text: str) -> str:
    by_letter = {letter: name for name, letter in GREEK.items()}
    return by_letter.get(text, text)


def _with_index(letters: str, index: str | None) -> str:
    if index is None:
        return letters
    if index in GREEK or (index.isascii() and (index.isdecimal() or (len(index) == 1 and index.isalpha()))):
        return f"{letters}_{index}" if "{" not in letters + index else f"{letters}_{{{index}}}"
    command = f"\\{letters}" if letters in GREEK else letters
    return f"{command}_{{\\text{{{_escaped(index)}}}}}"


def _escaped(words: str) -> str:
    return "".join(f"\\{each}" if each in "{}$&#_%" else each for each in words)
