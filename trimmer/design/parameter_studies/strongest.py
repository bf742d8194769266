"""Over which numbers each target is drawn: the two that move it most."""

import itertools
from collections.abc import Iterator

from trimmer.design.specification.targets import Measure, Target
from trimmer.design.trials.remedies import Remedies
from trimmer.design.trials.sensitivity import Sensitivities
from trimmer.design.trials.trial import MeasureOfPart
from trimmer.design.varied_places import NumberRole, VariedNumber
from trimmer.errors import TrimmerError
from trimmer.mechanism.mechanism import Mechanism

RANGE = 0.25, 1.75  # Range of a number over which is drawn, as shares of that of the file
MAPS = 3  # Pairs of numbers over which is drawn at most

Pair = tuple[VariedNumber, VariedNumber]


def pairs_of_targets(
    mechanism: Mechanism,
    targets: tuple[Target, ...],
    varied: tuple[VariedNumber, ...],
    sensitivities: Sensitivities | None,
    remedies: Remedies | None,
) -> dict[Pair, tuple[Target, ...]]:
    """Return pairs of numbers, each with the targets that are drawn over it.

    Gap, speed and friction keep their own ranges. What missed targets changed most with over wide ranges
    comes first, then what a motion that repeats changes most with.
    """
    known = {each.place: each for each in varied}
    found: dict[Pair, tuple[Target, ...]] = {}
    for target in targets:
        places = dict.fromkeys(_ranked(target, sensitivities, remedies))
        numbers = (known.get(place) or number_drawn(mechanism, place) for place in places)
        strongest = list(itertools.islice((each for each in numbers if each is not None), 2))
        if len(strongest) == 2:
            first, second = sorted(strongest, key=lambda each: each.place)
            found[first, second] = (*found.get((first, second), ()), target)
    return dict(list(found.items())[:MAPS])


def _ranked(target: Target, sensitivities: Sensitivities | None, remedies: Remedies | None) -> Iterator[str]:
    for mend in remedies.mends if remedies else ():
        if mend.target == target:
            yield from mend.strongest
    if sensitivities is not None and target.measure is not Measure.PERIOD:
        asked = MeasureOfPart(target.measure, target.part)
        yield from (each.place for each in sensitivities.ranked(asked))


def number_drawn(mechanism: Mechanism, place: str) -> VariedNumber | None:
    """Return a number with the range over which is drawn; None if the mechanism cannot have all of it."""
    value = mechanism.value(place)
    lowest, highest = sorted(share * value for share in RANGE)
    try:
        mechanism.with_value(place, lowest), mechanism.with_value(place, highest)
    except TrimmerError:
        return None
    return VariedNumber(NumberRole.OTHER, place, "", mechanism.places[place], value, lowest, highest)
