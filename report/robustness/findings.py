"""Which findings survive when all parameters change at once: proofs hold, numbers may not."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Final, final

from report.judging.text import filled
from report.robustness.predictions import Predictions

PRINTED_INERTIA: Final = 814.9
PRINTED_BAND: Final = 82.0
PRINTED_FREQUENCY: Final = 733.3
HALF_UNIT: Final = 0.05
"""Of the last printed digit of that frequency, Hz."""


@final
@dataclass(frozen=True)
class Survival:
    """A finding, the claim it is about, and in how many samples it holds.

    ``holds`` is None where a proof covers all parameters; ``because`` then says on what it rests.
    """

    claim: str
    finding: str
    holds: int | None
    because: str


def survivals(samples: tuple[Predictions, ...]) -> Iterable[Survival]:
    """Return the findings that somebody builds on: those that are proven first, then the others."""
    for claim, finding, because in _PROVEN:
        yield Survival(claim, filled(finding), None, filled(because))
    for claim, finding, holds, reach in _COUNTED:
        yield Survival(claim, filled(finding), sum(map(holds, samples)), reach.shown(samples))


@final
@dataclass(frozen=True)
class _Range:
    """The least and the largest value in all samples of something, in words."""

    words: str
    of: Callable[[Predictions], float]

    def shown(self, samples: tuple[Predictions, ...]) -> str:
        """Return the words with those of the two values that they ask for."""
        values = [self.of(sample) for sample in samples]
        ends = {"low": min(values), "high": max(values)}
        return filled(self.words, **{name: end for name, end in ends.items() if f"[[ {name} " in self.words})


_PROVEN: Final = (
    (
        "txt-5.2.1-open-loop-peak",
        "A driven trimmer whose play only passes a displacement on has no limit cycle.",
        "its linear part is stable for any positive damping that reaches all modes; what enters it repeats",
    ),
    (
        "txt-5.2.1-proportional",
        "Where there is a limit cycle its amplitude is in proportion to the gap, without a smallest gap.",
        "scaling: backlash has no length but its gap",
    ),
    (
        "txt-5.1.2-roll-off",
        "From the pin's displacement to the output the linear part falls by 40 dB per decade.",
        "two powers more below than above the line, as long as masses and bridge are there",
    ),
    (
        "eq-3.2",
        "Friction with the printed sign feeds the motion.",
        "the sign of its power does not depend on any parameter",
    ),
)

_COUNTED: Final[tuple[tuple[str, str, Callable[[Predictions], bool], _Range], ...]] = (
    (
        "txt-5.2.1-stable",
        "The thesis's closed loop has one stable limit cycle.",
        lambda found: found.friction.stable_count == 1,
        _Range(
            "between [[ low | f0 ]] and [[ high | f0 ]] Hz", lambda found: found.friction.stable.frequency
        ),
    ),
    (
        "txt-5.2.1-second-limit-cycle",
        "It has one unstable limit cycle besides.",
        lambda found: found.friction.count == found.friction.stable_count + 1,
        _Range(
            "up to [[ high | f0 ]] limit cycles, stable and unstable",
            lambda found: float(found.friction.count),
        ),
    ),
    (
        "txt-3.1-output-sign",
        "With the output of section 3.1, the sign turned, there is no limit cycle.",
        lambda found: found.turned == 0,
        _Range("up to [[ high | f0 ]] elsewhere", lambda found: float(found.turned)),
    ),
    (
        "lst-A.1",
        "The pin's velocity lowers the amplitude by more than 40 %.",
        lambda found: found.velocity.stable.amplitude < 0.6 * found.friction.stable.amplitude,
        _Range(
            "[[ low | f2 ]] to [[ high | f2 ]] of that without it",
            lambda found: found.velocity.stable.amplitude / found.friction.stable.amplitude,
        ),
    ),
    (
        "txt-5.2.2-prediction",
        "The inertia-controlled limit cycle lies below the printed 814.9 Hz.",
        lambda found: found.inertia.stable.frequency < PRINTED_INERTIA,
        _Range("[[ low | f0 ]] to [[ high | f0 ]] Hz", lambda found: found.inertia.stable.frequency),
    ),
    (
        "txt-5.2.3-band",
        "The band of frequencies is narrower than the printed 82 Hz.",
        lambda found: found.band < PRINTED_BAND,
        _Range("[[ low | f1 ]] to [[ high | f1 ]] Hz wide", lambda found: found.band),
    ),
    (
        "txt-5.1.3-first-resonance",
        "The linear part passes the fifth harmonic of 100 Hz better than 100 Hz itself.",
        lambda found: found.fifth > 1.0,
        _Range("[[ low | f1 ]] to [[ high | f1 ]] times", lambda found: found.fifth),
    ),
    (
        "txt-5.2.1-prediction",
        "The frequency of the stable limit cycle rounds to the printed 733.3 Hz.",
        lambda found: abs(found.friction.stable.frequency - PRINTED_FREQUENCY) <= HALF_UNIT,
        _Range(
            "[[ low | f0 ]] to [[ high | f0 ]] Hz, which is wider than the corrected band",
            lambda found: found.friction.stable.frequency,
        ),
    ),
)
