"""What the first pages say, made from what was solved."""

from report.document.extras import Overview
from report.numbers.evidence import Evidence
from report.overview.answers import answers
from report.overview.balance import balance
from report.overview.corrected_results import corrected_results
from report.overview.opening import opening
from report.overview.roots import ROOTS
from report.overview.short import short


def overview(known: Evidence) -> Overview:
    """Return what these pages show."""
    return Overview(
        opening(known), answers(known), corrected_results(known), ROOTS, balance(known), short(known)
    )
