"""What the report says of how far the corrected results hold: computed, drawn and put into words."""

from decimal import Decimal
from types import MappingProxyType
from typing import Final

from report.document.extras import Digits, EffectRow, Robustness
from report.numbers.evidence import Evidence
from report.pages.drawing.drawn import drawn
from report.pages.figure import Figure
from report.robustness.findings import survivals
from report.robustness.picture import BARS, bars
from report.robustness.variation import SAMPLES, SHARE, PredictionSensitivity, Variation, vary

PRINTED: Final = MappingProxyType(
    {
        **{"m1": "0.035", "m2": "0.003", "m3": "0.005", "m4": "0.030"},
        **{"k1": "200e3", "k2": "30e3", "k3": "150e3", "k4": "100e3", "k5": "1e3"},
        **{"c1": "3.5", "c2": "0.4", "c3": "1.0", "c4": "4.0"},
    }
)
"""Lines 4 to 18 of Listing A.1, SI units."""
FIGURE = "robustness"
TITLE = "Corrected predictions with other parameters"


def robustness(known: Evidence, samples: int = SAMPLES) -> Robustness:
    """Vary the parameters of the thesis, and return what follows for the corrected results."""
    found = vary(known.numbers.parameters, samples)
    return Robustness(
        percent=round(100 * SHARE),
        samples=samples,
        left_out=found.left_out,
        digits=tuple(_digits()),
        effects=tuple(_row(each) for each in found.sensitivities),
        survivals=tuple(survivals(found.samples, samples)),
        figure=_figure(found),
    )


def _digits() -> list[Digits]:
    counted: dict[int, list[str]] = {}
    for symbol, printed in PRINTED.items():
        counted.setdefault(significant_digits(printed), []).append(symbol)
    return [
        Digits(
            {1: "one digit", 2: "two digits", 3: "three digits"}[number],
            tuple(f"{symbol[0]}_{{{symbol[1]}}}" for symbol in symbols),
            f"{100 * max(left_open(PRINTED[symbol]) for symbol in symbols):.0f}",
        )
        for number, symbols in sorted(counted.items())
    ]


def significant_digits(printed: str) -> int:
    """Return how many digits a printed number certainly has.

    Zeros at the end of a number without a point may only hold the place, and are not counted.
    """
    mantissa = printed.split("e")[0]
    digits = mantissa.replace(".", "").lstrip("0")
    return len(digits if "." in mantissa else digits.rstrip("0"))


def left_open(printed: str) -> float:
    """Return half a unit of the last certain digit as a share of the number."""
    value = Decimal(printed)
    last = value.adjusted() - significant_digits(printed) + 1
    return float(Decimal(5).scaleb(last - 1) / value)


def _row(sensitivity: PredictionSensitivity) -> EffectRow:
    def shown(value: float) -> str:
        return f"{value:.{sensitivity.quantity.decimals}f}"

    largest = sensitivity.effects[0]
    return EffectRow(
        sensitivity.quantity.name,
        sensitivity.quantity.unit,
        shown(sensitivity.nominal),
        f"{largest.parameter[0]}_{{{largest.parameter[1]}}}",
        f"{shown(largest.lowered)} to {shown(largest.raised)}",
        f"{shown(sensitivity.band[0])} to {shown(sensitivity.band[1])}",
    )


def _figure(found: Variation) -> Figure:
    words = (
        f"Bars for {len(found.sensitivities)} predictions; in most of them the longest are those of the "
        "bridge's stiffness, the cutter's mass or the bridge's damping, and most parameters hardly count."
    )
    caption = (
        f"Each corrected prediction with one parameter {SHARE:.0%} lower and higher, for the {BARS} "
        "parameters with the largest effect, and with all parameters at random (nine tenths of the samples)."
    ).replace("%", r"\ %")
    return drawn(FIGURE, TITLE, caption, words, lambda: bars(found.sensitivities))
