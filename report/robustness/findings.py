"""Which findings survive when all parameters change at once: proofs hold, numbers may not."""

from collections.abc import Callable, Iterator
from typing import Final

from report.document.extras import SurvivalRow
from report.robustness.predictions import Predictions

PRINTED_INERTIA: Final = 814.9
PRINTED_BAND: Final = 82.0
PRINTED_FREQUENCY: Final = 733.3
HALF_UNIT: Final = 0.05  # Of the last printed digit of that frequency, Hz


def survivals(samples: tuple[Predictions, ...], drawn: int) -> Iterator[SurvivalRow]:
    """Return the findings that somebody builds on: those that are proven first, then the others.

    Of parameters at random so many were drawn, those without a stable limit cycle included.
    """
    for claim, finding, because in _PROVEN:
        yield SurvivalRow(claim, finding, "proven", because)
    for claim, finding, holds, words, of in _COUNTED:
        number, values = sum(map(holds, samples)), [of(sample) for sample in samples]
        share = {drawn: "all", 0: "none"}.get(number, str(number))
        because = words.format(low=min(values), high=max(values))
        yield SurvivalRow(claim, finding, f"{share} of {drawn}", because)


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

_COUNTED: Final[
    tuple[tuple[str, str, Callable[[Predictions], bool], str, Callable[[Predictions], float]], ...]
] = (
    (
        "txt-5.2.1-stable",
        "The thesis's closed loop has one stable limit cycle.",
        lambda found: found.friction.stable_count == 1,
        "between {low:.0f} and {high:.0f} Hz",
        lambda found: found.friction.stable.frequency,
    ),
    (
        "txt-5.2.1-second-limit-cycle",
        "It has one unstable limit cycle besides.",
        lambda found: found.friction.count == found.friction.stable_count + 1,
        "up to {high:.0f} limit cycles, stable and unstable",
        lambda found: float(found.friction.count),
    ),
    (
        "txt-3.1-output-sign",
        "With the output of section 3.1, the sign turned, there is no limit cycle.",
        lambda found: found.turned == 0,
        "up to {high:.0f} elsewhere",
        lambda found: float(found.turned),
    ),
    (
        "lst-A.1",
        "The pin's velocity lowers the amplitude by more than 40 %.",
        lambda found: found.velocity.stable.amplitude < 0.6 * found.friction.stable.amplitude,
        "{low:.2f} to {high:.2f} of that without it",
        lambda found: found.velocity.stable.amplitude / found.friction.stable.amplitude,
    ),
    (
        "txt-5.2.2-prediction",
        "The inertia-controlled limit cycle lies below the printed 814.9 Hz.",
        lambda found: found.inertia.stable.frequency < PRINTED_INERTIA,
        "{low:.0f} to {high:.0f} Hz",
        lambda found: found.inertia.stable.frequency,
    ),
    (
        "txt-5.2.3-band",
        "The band of frequencies is narrower than the printed 82 Hz.",
        lambda found: found.band < PRINTED_BAND,
        "{low:.1f} to {high:.1f} Hz wide",
        lambda found: found.band,
    ),
    (
        "txt-5.1.3-first-resonance",
        "The linear part passes the fifth harmonic of 100 Hz better than 100 Hz itself.",
        lambda found: found.fifth > 1.0,
        "{low:.1f} to {high:.1f} times",
        lambda found: found.fifth,
    ),
    (
        "txt-5.2.1-prediction",
        "The frequency of the stable limit cycle rounds to the printed 733.3 Hz.",
        lambda found: abs(found.friction.stable.frequency - PRINTED_FREQUENCY) <= HALF_UNIT,
        "{low:.0f} to {high:.0f} Hz, which is wider than the corrected band",
        lambda found: found.friction.stable.frequency,
    ),
)
