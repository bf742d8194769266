"""Whether points fit: sums of coordinates that are there, with weights of one kind, that move."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from trimmer.mechanism.kinds import Kind, is_length, key_of_ends, place_of_weights, weights_of
from trimmer.mechanism.parts import COUPLINGS, GROUND, Pin, Point
from trimmer.mechanism.problems import Problem
from trimmer.mechanism.structures.ends import coordinates_in, no_such_end, weights_in

SAME = 1e-12  # Difference of two weights, as a share of the largest one, that is taken for rounding


def problems_of_points(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find points that are no sums of coordinates."""
    points: Mapping[str, Point] = content["points"]
    for name, point in points.items():
        if not point.weights:
            yield Problem(("points", name), "has no weights; write them, as in { arm = 0.05, housing = 1 }")
        for of, weight in point.weights.items():
            place = ("points", name, of)
            if of in points:
                reason = "is a point itself; write its coordinates, each with the product of both weights"
                yield Problem(place, reason, weight)
            elif of in content["pins"]:
                reason = "a pin moves as prescribed; a point is a sum of bodies, and a pin may sit on it"
                yield Problem(place, reason, weight)
            elif of == GROUND:
                yield Problem(place, "the ground does not move; leave it out", weight)
            elif of not in (known := coordinates_in(content)):
                yield Problem(place, no_such_end(content, "body", of, known), weight)


def problems_of_weights(content: Mapping[str, Any], kinds: Mapping[str, Kind]) -> Iterator[Problem]:
    """Find weights of points and outputs that are neither ratios nor lengths where they stand."""
    for section in ("points", "outputs"):
        sums = content.get(section)
        for name, part in sums.items() if isinstance(sums, Mapping) else ():
            weights = weights_of(part)
            turning = [of for of in weights if kinds.get(of) is Kind.ROTATION]
            lengths = [of for of, weight in weights.items() if is_length(weight)]
            place = (section, name, *place_of_weights(part))
            for of in lengths:
                if kinds.get(of) is Kind.TRANSLATION:
                    reason = f"{of!r} is a translation, so that its weight is a plain number"
                    yield Problem((*place, of), reason, weights[of])
            if lengths and len(turning) == len(weights):
                yield from _of_rotations(place, weights, lengths)
            if isinstance(part, Point) and part.by_length and not turning:
                reason = "by_length is of weights of rotations, and none of its coordinates turns"
                yield Problem((section, name), f"{reason}; leave it out")


def _of_rotations(
    place: tuple[str, ...], weights: Mapping[str, object], lengths: list[str]
) -> Iterator[Problem]:
    """Find what is neither a ratio nor a length in a sum of rotations, some of whose weights are lengths."""
    if place[0] == "outputs":
        reason = "an output of rotations is an angle; give a point this length, and ask for the point"
        yield Problem((*place, lengths[0]), reason, weights[lengths[0]])
        return
    for of, weight in weights.items():
        if of not in lengths:
            reason = f"the weight of {lengths[0]!r} is a length; write this one with its unit too, or neither"
            yield Problem((*place, of), reason, weight)


def problems_of_moving(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find points that nothing moves, and parts between points that nothing between them can move."""
    for name, point in content["points"].items():
        if not any(point.weights.values()):
            yield Problem(("points", name), "all its weights are 0, so that it never moves; give one another")
    known = weights_in(content)
    for section in (*COUPLINGS, "controllers"):
        key = key_of_ends(section)
        for name, part in content[section].items():
            ends = getattr(part, key)
            if all(end in known for end in ends):
                weights = [known[end] for end in ends]
                yield from _of_ends((section, name, key), ends, weights, content["pins"])


def _of_ends(
    place: tuple[str, ...],
    between: tuple[str, str],
    weights: Sequence[Mapping[str, float]],
    pins: Mapping[str, Pin],
) -> Iterator[Problem]:
    """Find two ends that no force between them can move."""
    first, second = weights
    names = {**first, **second}
    largest = max((abs(weight) for weights in (first, second) for weight in weights.values()), default=0.0)
    apart = (abs(first.get(name, 0.0) - second.get(name, 0.0)) for name in names)
    if between[0] == between[1]:
        yield Problem(place, "both ends are the same; name two different ones", list(between))
    elif not names:
        reason = "both ends move as prescribed, so there is nothing to act on; one end must be a body"
        yield Problem(place, reason, list(between))
    elif all(each <= SAME * largest for each in apart):
        carriers = {pins[end].on if end in pins else end for end in between}
        where = f"are on {next(iter(carriers))!r}" if len(carriers) == 1 else "have the same weights"
        reason = f"both ends {where}, so that nothing between them can move it; name another body"
        yield Problem(place, reason, list(between))


def ends_in(content: Mapping[str, Any]) -> str:
    """Return what may be an end, for a message on a name that is none."""
    return "body, pin or point" if content["points"] else "body or pin"
