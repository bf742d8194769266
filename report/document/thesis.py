"""The chapters of the thesis with what was found in them, and what the report was made from."""

from dataclasses import dataclass

from report.judging.finding import Finding


@dataclass(frozen=True)
class Chapter:
    """A chapter or appendix of the thesis with the findings in it, in thesis order."""

    id: str
    number: str
    title: str
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class Program:
    """A corrected program of appendix A: file name, id of the claim on what it corrects (or empty), text.

    ``title`` says what it computes, ``faults`` what was wrong in the thesis's listing; both are plain text.
    """

    name: str
    claim: str
    title: str
    faults: tuple[str, ...]
    text: str
