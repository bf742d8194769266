"""Whether the parts of a mechanism go together: ends that are there, bodies that something touches, and more.

It is asked only of what ``checks`` has nothing against, so values have their types here.
"""

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from trimmer.mechanism.controls.checks import problems_of_control, problems_of_control_numbers
from trimmer.mechanism.kinds import kind_of_part, kinds_of, problems_of_kinds
from trimmer.mechanism.number_rows import problems_of_order
from trimmer.mechanism.outputs import problems_of_outputs
from trimmer.mechanism.parts import COUPLINGS, GROUND, Body, Contact, ContactLaw, Friction, Link
from trimmer.mechanism.points import ends_in, problems_of_moving, problems_of_points, problems_of_weights
from trimmer.mechanism.problems import Problem, no_such
from trimmer.mechanism.structures.ends import (
    coordinates_in,
    modes_in,
    no_such_end,
    points_in,
    problems_of_names,
    weights_in,
)
from trimmer.mechanism.waves import is_driven

NO_MASS = 'missing; add mass = 0.035, or for a body that turns inertia = "2e-6 kg m^2"'


def problems_of_sense(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find what does not go together."""
    if not content["bodies"] and not content["structures"]:
        yield Problem(("bodies",), "there is none; write one, as in motor = { mass = 0.035 } below [bodies]")
        return
    if clashes := [
        *_names(content),
        *problems_of_names(content),
        *_masses(content["bodies"]),
        *problems_of_points(content),
    ]:
        yield from clashes
        return
    problems = list(_problems_of_parts(content))
    # What is written in place of a wrong name may touch every body.
    yield from problems or _untouched(content)


def problems_of_numbers(content: Mapping[str, Any], *, weighs: bool = True) -> Iterator[Problem]:
    """Find numbers that do not go together; whether each can stand in its place is not asked."""
    yield from _contacts(content)
    yield from _frictions(content)
    for section in ("links", "frictions", "forces"):
        for name, part in content[section].items():
            yield from problems_of_order((section, name), part)
    yield from _drive(content)
    if weighs:
        yield from problems_of_moving(content)
    yield from problems_of_control_numbers(content)


def _problems_of_parts(content: Mapping[str, Any]) -> Iterator[Problem]:
    yield from _carriers(content)
    ends = [*coordinates_in(content), *content["pins"], *content["points"], *points_in(content)]
    yield from _ends(content, [*ends, GROUND])
    kinds = kinds_of(content)
    yield from (*problems_of_kinds(content, kinds), *problems_of_weights(content, kinds))
    yield from problems_of_numbers(content)
    yield from problems_of_outputs(content, [*ends, *modes_in(content)])
    yield from problems_of_control(content)
    yield from _start(content)
    yield from _symbols(content)


def _names(content: Mapping[str, Any]) -> Iterator[Problem]:
    taken: dict[str, str] = {}
    for section, kind in (("bodies", "body"), ("pins", "pin"), ("points", "point")):
        if GROUND in content[section]:
            yield Problem((section, GROUND), "this name stands for the fixed frame; choose another one")
        for name in content[section]:
            if name in taken:
                reason = (
                    f"a {taken[name]} has this name already; names are unique over bodies, pins and points"
                )
                yield Problem((section, name), reason)
            taken.setdefault(name, kind)


def _masses(bodies: Mapping[str, Body]) -> Iterator[Problem]:
    for name, body in bodies.items():
        if body.mass is None and body.inertia is None:
            yield Problem(("bodies", name, "mass"), NO_MASS)
        elif body.mass is not None and body.inertia is not None:
            reason = "a body has a mass or, if it turns, an inertia; leave one out, or write two bodies"
            yield Problem(("bodies", name, "inertia"), reason, body.inertia)


def _carriers(content: Mapping[str, Any]) -> Iterator[Problem]:
    pins, points = content["pins"], content["points"]
    bodies = [*coordinates_in(content), *points, *points_in(content)]
    body = "body or point" if points else "body"
    for name, pin in pins.items():
        place = ("pins", name, "on")
        if pin.on in pins:
            yield Problem(
                place, "a pin sits on a body or on the ground, not on a pin (no loops of pins)", pin.on
            )
        elif pin.on not in bodies and pin.on != GROUND:
            yield Problem(place, no_such_end(content, body, pin.on, [*bodies, GROUND]), pin.on)
    for name, force in content["forces"].items():
        place = ("forces", name, "on")
        if force.on in pins:
            yield Problem(place, f"a force acts on a body; this is a pin on {pins[force.on].on!r}", force.on)
        elif force.on == GROUND:
            yield Problem(place, "a force on the ground moves nothing; name a body", force.on)
        elif force.on not in bodies:
            yield Problem(place, no_such_end(content, body, force.on, bodies), force.on)


def _ends(content: Mapping[str, Any], known: list[str]) -> Iterator[Problem]:
    for section in COUPLINGS:
        for name, part in content[section].items():
            for end in dict.fromkeys(part.between):
                if end not in known:
                    reason = no_such_end(content, ends_in(content), end, known)
                    yield Problem((section, name, "between"), reason, list(part.between))


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


def _frictions(content: Mapping[str, Any]) -> Iterator[Problem]:
    frictions: Mapping[str, Friction] = content["frictions"]
    for name, friction in frictions.items():
        if friction.force is not None and friction.curve is not None:
            reason = "the curve gives the kinetic force at the speed 0; leave this out, or the curve"
            yield Problem(("frictions", name, "force"), reason, friction.force)
        elif friction.static is not None and friction.static < friction.kinetic_force:
            unit = kind_of_part(kinds_of(content), "frictions", name, friction).unit("N")
            kinetic = f"{friction.kinetic_force!r} {unit}"
            reason = f"the static force is less than the kinetic one, {kinetic}; it is never less"
            yield Problem(("frictions", name, "static"), reason, friction.static)


def _drive(content: Mapping[str, Any]) -> Iterator[Problem]:
    give = "give one, as in frequency = 110.0 (Hz), before the bodies"
    drives, lacks = content["drives"], content["frequency"] is None
    if lacks:
        for name, value in drives.items():
            yield Problem(
                ("drives", name), f"periods count in those of frequency, which there is not; {give}", value
            )
    for section in ("pins", "forces"):
        for name, part in content[section].items():
            if part.drive is not None and part.drive not in drives:
                yield Problem((section, name, "drive"), no_such("drive", part.drive, drives), part.drive)
            elif lacks and not part.drive and is_driven(part):
                keys = ("amplitude", "unbalance", "harmonics", "waveform")
                key = next(key for key in keys if getattr(part, key, None))
                article = {"harmonics": "are", "waveform": "is a"}.get(key, "is an")
                yield Problem((section, name, key), f"there {article} {key}, but no frequency; {give}")


def _start(content: Mapping[str, Any]) -> Iterator[Problem]:
    for name, state in content["start"].items():
        if name in content["pins"]:
            reason = "a pin starts where its motion puts it; only bodies have a start"
            yield Problem(("start", name), reason, state)
        elif name in content["points"]:
            reason = "a point starts where its coordinates put it; only bodies have a start"
            yield Problem(("start", name), reason, state)
        elif name in points_in(content):
            reason = "a point of modes starts where these put it; give the modes a start"
            yield Problem(("start", name), reason, state)
        elif name not in (known := [*coordinates_in(content), *modes_in(content)]):
            yield Problem(("start", name), no_such("body", name, known), state)


def _untouched(content: Mapping[str, Any]) -> Iterator[Problem]:
    ends = [end for section in COUPLINGS for part in content[section].values() for end in part.between]
    ends += [force.on for force in content["forces"].values()]
    ends += [end for controller in content["controllers"].values() for end in controller.acts]
    weights = weights_in(content)
    touched = {body for end in ends for body in weights[end]}
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
