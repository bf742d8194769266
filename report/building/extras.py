"""The chapters beside those of the thesis, and what makes each."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, final

from report.document.extras import ExtraChapter
from report.explorable.make import explorable
from report.future_work.chapter import future_work
from report.numbers.evidence import Evidence
from report.overview.page import overview
from report.robustness.page import robustness
from report.twin.chapter import twin_chapter


@final
@dataclass(frozen=True)
class Extra:
    """How an extra chapter is made."""

    name: str  # Of its field in the document
    module: str  # Whose sources it depends on, beside those of the evidence
    # Makes it of what was solved, and of a seed where something is drawn at random
    make: Callable[[Evidence, int], ExtraChapter]


EXTRAS: Final = (
    Extra("twin", "report.twin.chapter", twin_chapter),
    Extra("future_work", "report.future_work.chapter", lambda known, _: future_work(known)),
    Extra("robustness", "report.robustness.page", lambda known, _: robustness(known)),
    Extra("explorable", "report.explorable.make", lambda known, _: explorable(known)),
    Extra("overview", "report.overview.page", lambda known, _: overview(known)),
)
"""Those that take longest first."""
