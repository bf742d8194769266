"""The thesis as a text that is judged."""

from typing import Final

from report.document.subject import Subject, usual_meanings
from report.judging.verdict import Grade

THESIS: Final = Subject(
    title="The trimmer’s thesis, derived again",
    called="thesis",
    command="trimmer report",
    chapters={
        "1": "Introduction",
        "2": "Theory",
        "3": "Experiment and simulation",
        "4": "Nonlinearities in the simulation",
        "5": "Simulation and results",
        "6": "Discussion",
        "7": "Conclusion",
        "A": "Listings",
        "B": "Fourier coefficients",
        "D": "Equations of motion",
        "E": "Further simulations",
    },
    claims="report.chapters",
    records="report/chapters",
    inventory="report/data/further_statements.csv",
    meanings=usual_meanings("thesis")
    | {Grade.CONCLUSION: "is wrong, and a conclusion of the thesis or a designer's choice changes with it"},
    cites=True,
    by_machine=True,
)
