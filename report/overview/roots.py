"""What changes a conclusion, by its root: three mistakes with what grows from each, and what stands alone.

Each card of that grade stands in exactly one of them.
"""

from typing import Final

from report.document.extras import Root

ROOTS: Final = (
    Root(
        r"A threshold of $2\times10^{-8}$ m",
        "A figure whose curves begin too late is read as a smallest gap. There is none: the amplitude is in "
        "proportion to the gap.",
        (
            "txt-5.2.1-threshold",
            "fig-5.6",
            "fig-5.7",
            "txt-5.2.1-touching",
            "txt-5.2.1-impulse-1e-8",
            "txt-6-threshold",
        ),
    ),
    Root(
        "A limit cycle is looked for in a driven loop",
        "A limit cycle needs a loop that feeds the output back. In the open loop, as in the experiment, the "
        "motor moves the pin, and what is seen are harmonics of the drive.",
        (
            "txt-5.2.1-open-loop-peak",
            "fig-5.12",
            "txt-5.2.1-drive-amplitude",
            "fig-E.2",
            "txt-7-input-amplitude",
            "txt-7-subharmonics",
            "txt-3.3-peak-366",
            "txt-7-coulomb-evidence",
        ),
    ),
    Root(
        "The friction term of equation 5.14 and Listing A.6",
        "It has the wrong sign, so that friction feeds the oscillation. The 737.514 Hz that are printed for "
        "0.6 N come from it; with the right sign there is no limit cycle to put in their place.",
        (
            "txt-5.2.5-coulomb-term",
            "eq-5.14",
            "lst-A.6",
            "fig-5.21",
            "fig-5.23",
            "txt-5.2.5-prediction",
            "txt-5.2.5-amplitude",
        ),
    ),
    Root(
        "Alone",
        "",
        ("txt-3.3-open-loop-odd", "txt-3.3-peak-350", "txt-6.3-friction-dominates", "txt-7-play-stability"),
    ),
)
"""The trees in the order of the thesis, the root of each first; last those that stand alone."""
