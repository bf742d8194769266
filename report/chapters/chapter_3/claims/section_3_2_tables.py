"""Claims of section 3.2 on the tabulated peaks and on the drive's frequency (tables 3.1 and 3.2)."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from report.chapters.chapter_3.claims.measured_peaks import (
    BIN,
    DIFFERENCE,
    DRIVE_BIN,
    FRAMES_OF_TABLES,
    QUOTED,
    SAMPLE_RATE,
    TABLE_1,
    TABLE_2,
    common_drive,
    drive_part,
    nearest_bin,
    on_a_bin,
)
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.second_ways import second_way
from report.evidence import Evidence

SOURCE = "report/chapters/chapter_3/claims/measured_peaks.py"
ABOUT = "109"
"""The drive's frequency where it is quoted without decimals, in sections 3.2 and 3.3, Hz."""


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_first_table(), _second_table(), _drive_frequency())


def _first_table() -> Claim:
    fifth = float(TABLE_1[3]) + float(DIFFERENCE)
    cells = tuple(
        Part(
            f"$f_{order}$",
            PrintedDigits(printed, order * DRIVE_BIN * BIN, "Hz"),
            Confirmation(
                "$f_3$ and the difference that the table prints",
                CloseNumbers(fifth, float(order * DRIVE_BIN * BIN), 1e-6),
            )
            if order == 5
            else _by_numpy(order * DRIVE_BIN),
        )
        for order, printed in TABLE_1.items()
    )
    differences = tuple(
        Part(label, PrintedDigits(DIFFERENCE, 2 * DRIVE_BIN * BIN, "Hz"), _by_numpy(2 * DRIVE_BIN))
        for label in ("$f_3 - f_1$", "$f_5 - f_3$")
    )
    return Claim(
        id="tab-3.1",
        parts=(*cells, *differences),
        explanation=(
            f"The peaks are bins 11, 33 and 55 of {float(BIN):.4f} Hz, so $f_5$ is 549.725 Hz; 559.725 is "
            "not a bin, is not five times the first, and contradicts the difference printed beside it. With "
            "that digit put right the three are odd multiples of one frequency."
        ),
        consequence="None on the text, which calls them multiples of the drive's frequency.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _by_numpy(number: int) -> Confirmation:
    """Confirm the frequency of a bin."""
    bins = np.fft.rfftfreq(FRAMES_OF_TABLES, 1 / float(SAMPLE_RATE))
    return Confirmation("NumPy's bins", CloseNumbers(float(bins[number]), float(number * BIN)))


def _second_table() -> Claim:
    cells = tuple(
        _cell(f"{name}, $f_{order}$", printed)
        for name, row in TABLE_2.items()
        for order, printed in enumerate(row, start=1)
    )
    return Claim(
        id="tab-3.2",
        parts=(*cells, _near_multiples()),
        explanation=(
            f"All cells but two are bins of {float(BIN):.4f} Hz to the last digit; 109.450 is 109.945 "
            "misprinted. The text puts unequal differences down to the resolution: with peaks one bin off a "
            "common drive fits all of a measurement, with the nearest bins none does, so peaks were shifted, "
            "by leakage or because the motor did not run evenly."
        ),
        consequence=(
            "The two cells change nothing else. That $f_2$ and $f_4$ are there at all matters more, see "
            "the comparison with the model in section 3.3."
        ),
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _cell(label: str, printed: str) -> Part:
    centre = nearest_bin(printed) * BIN
    confirmation = _by_numpy(nearest_bin(printed))
    if not on_a_bin(printed):
        confirmation = Confirmation(
            "the same peak in measurement 1", CloseNumbers(float(TABLE_2["M1"][0]), float(centre), 1e-6)
        )
    return Part(label, PrintedDigits(printed, centre, "Hz"), confirmation)


def _near_multiples() -> Part:
    rows = {name: _bins(row) for name, row in TABLE_2.items()}
    ranges = {name: common_drive(bins, Fraction(1)) for name, bins in rows.items()}
    closest = [common_drive(bins, Fraction(1, 2)) for bins in rows.values()]
    fitting = sum(low <= high for low, high in closest)
    shown = ", ".join(f"{name} {low:.2f} to {high:.2f} Hz" for name, (low, high) in ranges.items())
    return Part(
        "unequal differences",
        Assertion(
            statement="they stay within the resolution: one bin from multiples of one drive frequency",
            derived=all(low <= high for low, high in ranges.values()),
            evidence=(
                f"the drive would be at {shown}; within half a bin {fitting or 'none'} of the three fits"
            ),
            method="intervals of the drive's frequency, intersected over the five peaks",
        ),
        second_way(
            "a search over drives from 100 to 120 Hz in steps of a millihertz",
            all(_common_drive_by_search(bins) for bins in rows.values()),
        ),
    )


def _common_drive_by_search(bins: dict[int, int]) -> bool:
    """Tell whether the multiples of some drive all lie within a bin of their peaks."""
    drives = np.arange(100_000, 120_000) / 1e3
    distances = [abs(order * drives - number * float(BIN)) for order, number in bins.items()]
    return bool((np.max(distances, axis=0) <= float(BIN)).any())


def _bins(row: tuple[str, ...]) -> dict[int, int]:
    return {order: nearest_bin(printed) for order, printed in enumerate(row, start=1)}


def _drive_frequency() -> Claim:
    odd = {order: order * DRIVE_BIN for order in TABLE_1}
    low, high = common_drive(odd, Fraction(1, 2))
    return Claim(
        id="txt-3.2-drive-frequency",
        parts=(
            drive_part("section 3.2 and tables, first peak", TABLE_1[1]),
            *(drive_part(place, printed) for place, printed in QUOTED.items()),
            drive_part("table 3.2, measurements 2 and 3", TABLE_2["M2"][0]),
            drive_part("sections 3.2 and 3.3, about", ABOUT),
        ),
        explanation=(
            "The tables' peaks are 1, 3 and 5 times 109.945 Hz; 109.845 Hz, of which the text calls them "
            "multiples, and 109.450 Hz fit no bin, and 109 is cut rather than rounded. What the bins of "
            f"experiment 1 say of the drive is that it lies between {low:.2f} and {high:.2f} Hz."
        ),
        consequence=(
            "Section 5.2.1 and appendix A.9 carry 109.845 Hz on. The models of chapters 4 and 5 run at 100 "
            "Hz, so their harmonics meet the natural modes elsewhere than the experiment's."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )
