"""Whether the parts of a mechanism go together: ends that are there, bodies that something touches, and more.

It is asked only of what ``checks`` has nothing against, so values have their types here.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from trimmer.mechanism.curves import problems_of_points
from trimmer.mechanism.outputs import problems_of_outputs
from trimmer.mechanism.parts import (
    GROUND,
    Body,
    Contact,
    ContactLaw,
    Force,
    Friction,
    Link,
    Pin,
)
from trimmer.mechanism.problems import Problem, no_such

COUPLINGS = ("links", "plays", "stops", "frictions")
"""Sections whose parts stand between two ends."""


def problems_of_sense(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find what does not go together."""
    if not content["bodies"]:
        yield Problem(("bodies",), "there is none; write one, as in motor = { mass = 0.035 } below [bodies]")
        return
    if clashes := list(_names(content["bodies"], content["pins"])):
        yield from clashes
        return
    problems = list(_problems_of_parts(content))
    # What is written in place of a wrong name may touch every body.
    yield from problems or _untouched(content)


def problems_of_numbers(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find numbers that do not go together; whether each can stand in its place is not asked."""
    yield from _contacts(content)
    yield from _frictions(content["frictions"])
    for section in ("links", "frictions"):
        for name, part in content[section].items():
            yield from problems_of_points((section, name), part)
    yield from _drive(content)


def _problems_of_parts(content: Mapping[str, Any]) -> Iterator[Problem]:
    yield from _carriers(content)
    for section in COUPLINGS:
        for name, part in content[section].items():
            yield from _ends((section, name, "between"), part.between, content)
    yield from problems_of_numbers(content)
    yield from problems_of_outputs(content, [*content["bodies"], *content["pins"]])
    yield from _start(content)
    yield from _symbols(content)


def _names(bodies: Mapping[str, Body], pins: Mapping[str, Pin]) -> Iterator[Problem]:
    for section, names in (("bodies", bodies), ("pins", pins)):
        if GROUND in names:
            yield Problem((section, GROUND), "this name stands for the fixed frame; choose another one")
    for name in pins:
        if name in bodies:
            yield Problem(
                ("pins", name), "a body has this name already; names are unique over bodies and pins"
            )


def _carriers(content: Mapping[str, Any]) -> Iterator[Problem]:
    bodies, pins = content["bodies"], content["pins"]
    for name, pin in pins.items():
        place = ("pins", name, "on")
        if pin.on in pins:
            yield Problem(
                place, "a pin sits on a body or on the ground, not on a pin (no loops of pins)", pin.on
            )
        elif pin.on not in bodies and pin.on != GROUND:
            yield Problem(place, no_such("body", pin.on, [*bodies, GROUND]), pin.on)
    for name, force in content["forces"].items():
        place = ("forces", name, "on")
        if force.on in pins:
            yield Problem(place, f"a force acts on a body; this is a pin on {pins[force.on].on!r}", force.on)
        elif force.on == GROUND:
            yield Problem(place, "a force on the ground moves nothing; name a body", force.on)
        elif force.on not in bodies:
            yield Problem(place, no_such("body", force.on, bodies), force.on)


def _ends(place: tuple[str, ...], between: tuple[str, str], content: Mapping[str, Any]) -> Iterator[Problem]:
    bodies, pins = content["bodies"], content["pins"]
    unknown = [end for end in between if end not in bodies and end not in pins and end != GROUND]
    if unknown:
        for end in dict.fromkeys(unknown):
            yield Problem(place, no_such("body or pin", end, [*bodies, *pins, GROUND]), list(between))
        return
    first, second = (pins[end].on if end in pins else end for end in between)
    if between[0] == between[1]:
        yield Problem(place, "both ends are the same; name two different ones", list(between))
    elif first == second == GROUND:
        reason = "both ends move as prescribed, so there is nothing to act on; one end must be a body"
        yield Problem(place, reason, list(between))
    elif first == second:
        reason = f"both ends are on {first!r}, so that nothing between them can move it; name another body"
        yield Problem(place, reason, list(between))


def _contacts(content: Mapping[str, Any]) -> Iterator[Problem]:
    for section in ("plays", "stops"):
        contacts: Mapping[str, Contact] = content[section]
        for name, part in contacts.items():
            relaxing = ContactLaw.chosen(part.law, "law") is ContactLaw.RELAXING
            if relaxing and part.stiffness == 0 and part.damping > 0:
                yield Problem(
                    (section, name, "stiffness"),
                    "a relaxing contact with damping needs a stiffness, or it never relaxes; "
                    'give one, or law = "truncated"',
                    part.stiffness,
                )


def _frictions(frictions: Mapping[str, Friction]) -> Iterator[Problem]:
    for name, friction in frictions.items():
        if friction.force is not None and friction.curve is not None:
            reason = "the curve gives the kinetic force at the speed 0; leave this out, or the curve"
            yield Problem(("frictions", name, "force"), reason, friction.force)
        elif friction.static is not None and friction.static < friction.kinetic_force:
            kinetic = friction.kinetic_force
            reason = f"the static force is less than the kinetic one, {kinetic!r} N; it is never less"
            yield Problem(("frictions", name, "static"), reason, friction.static)


def _drive(content: Mapping[str, Any]) -> Iterator[Problem]:
    if content["frequency"] is not None:
        return
    forces: Mapping[str, Force] = content["forces"]
    moving = [
        *((("pins", name), "amplitude") for name, pin in content["pins"].items() if pin.amplitude),
        *((("forces", name), "amplitude") for name, force in forces.items() if force.amplitude),
        *((("forces", name), "unbalance") for name, force in forces.items() if force.unbalance),
    ]
    for place, key in moving:
        reason = (
            f"there is an {key}, but no frequency; give one, as in frequency = 110.0 (Hz), before the bodies"
        )
        yield Problem((*place, key), reason)


def _start(content: Mapping[str, Any]) -> Iterator[Problem]:
    for name, state in content["start"].items():
        if name in content["pins"]:
            reason = "a pin starts where its motion puts it; only bodies have a start"
            yield Problem(("start", name), reason, state)
        elif name not in content["bodies"]:
            yield Problem(("start", name), no_such("body", name, content["bodies"]), state)


def _untouched(content: Mapping[str, Any]) -> Iterator[Problem]:
    pins = content["pins"]
    ends = [end for section in COUPLINGS for part in content[section].values() for end in part.between]
    touched = {pins[end].on if end in pins else end for end in ends}
    touched |= {force.on for force in content["forces"].values()}
    for name in content["bodies"]:
        if name not in touched:
            reason = (
                f"nothing touches body {name!r}; add a link, play, stop, friction or force, or leave it out"
            )
            yield Problem(("bodies", name), reason)


def _symbols(content: Mapping[str, Any]) -> Iterator[Problem]:
    carried = [
        (symbol, (section, name, "symbol"))
        for section in ("bodies", "pins", *COUPLINGS, "forces")
        for name, part in content[section].items()
        for symbol in _symbols_of(part)
    ]
    count = Counter(symbol for symbol, _ in carried)
    for symbol, place in dict.fromkeys(carried):
        if count[symbol] > 1:
            reason = f"the symbol {symbol} is taken twice (a damping takes c and the index of its stiffness)"
            yield Problem(place, f"{reason}; choose another one", symbol)


def _symbols_of(part: Any) -> list[str]:
    """Return the symbol that a part carries, if any, and that of its damping."""
    symbols = (part.symbol, part.damping_symbol) if isinstance(part, Link | Contact) else (part.symbol,)
    return [symbol for symbol in symbols if symbol is not None]
