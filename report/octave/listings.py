"""Appendix A as corrected MATLAB/Octave programs."""

from dataclasses import dataclass
from typing import Any

import sympy
from jinja2 import Environment

from derivations.elements import backlash
from derivations.elements.friction import FORCE
from derivations.elements.waveform import THETA
from derivations.linear_trimmer import LinearTrimmer
from derivations.state_space import output_row
from derivations.symbols import PARAMETERS, A
from report.document.thesis import Program
from report.numbers.thesis import (
    DRIVE_AMPLITUDE,
    DRIVE_FREQUENCY,
    LARGE_GAP,
    RELAY_LEVEL,
    TIME_CONSTANT,
    TIMED_GAP,
)
from report.octave import formulas
from report.octave.archive import environment
from report.octave.contents import contents
from report.octave.printer import CodePrinter, comment
from trimmer import TrimmerParameters
from trimmer.thesis import parameter_table

NAMES: dict[sympy.Expr, str] = {
    **{quantity.symbol: str(quantity.symbol).replace("_", "") for quantity in PARAMETERS},
    A: "amplitude",
    backlash.GAP: "gap",
    formulas.RATIO: "ratio",
    backlash.CONTACT: "contact",
    backlash.SEPARATION: "separation",
    formulas.FLIGHT: "flight",
    backlash.GAMMA: "load_gamma",
    THETA: "phase",
    FORCE: "force",
    formulas.STIFFNESS: "stiffness",
    formulas.PIN: "pin_now",
    formulas.LOAD: "load_now",
}
"""Variables of the programs."""


RUNNERS = (
    ("main_numbers.m", "Numbers of all listings, as a struct or as JSON."),
    ("run_all.m", "Runs all listings and prints what they give."),
)
"""Programs that call the listings: file name and title."""


@dataclass(frozen=True)
class ExampleNumbers:
    """Where ``main_numbers`` evaluates the listings, in SI units.

    ``gap`` is that of Listing A.9, ``time_constant`` the M/D of section 4.2.3, ``force`` that of figure 5.18;
    the drive is that of Listing A.8. ``amplitudes`` are in units of the gap; ``gamma`` is omega M/D of
    Listing A.5.
    """

    gap: float = LARGE_GAP
    time_constant: float = TIME_CONSTANT
    force: float = RELAY_LEVEL
    drive_gap: float = TIMED_GAP
    drive_amplitude: float = DRIVE_AMPLITUDE
    drive_frequency: float = DRIVE_FREQUENCY
    amplitudes: tuple[float, ...] = (0.6, 1, 3, 10)
    gamma: float = 1.25


@dataclass(frozen=True)
class SearchGrid:
    """Number of gap/amplitude and of frequencies on which Listing A.9 looks for limit cycles."""

    ratios: int = 100
    omegas: int = 1500


@dataclass(frozen=True)
class ParameterLine:
    """A parameter as a program states it: name, digits, unit and meaning."""

    symbol: str
    value: str
    unit: str
    meaning: str


def corrected_programs(derivation: LinearTrimmer, parameters: TrimmerParameters) -> tuple[Program, ...]:
    """Write the corrected listings A.1 to A.10, and what runs them all.

    ``main_numbers.m`` returns their numbers, ``run_all.m`` prints them for a reader.

    Returns:
        Finished programs in thesis order; their texts are ASCII and depend on the arguments alone.

    Raises:
        UnnamedSymbolError: if a formula holds a symbol that the programs have no variable for.
    """
    template = _environment().get_template
    shared = {"bridge_stiffness": _digits(parameters.k2)}
    particular = _contexts(derivation, parameters)
    listings = tuple(
        Program(
            name=f"{content.function}.m",
            claim=content.claim,
            title=content.title,
            faults=content.faults,
            text=template(f"{content.function}.m.j2").render(
                content=content, **shared, **particular.get(content.number, {})
            ),
        )
        for content in contents()
    )
    runners = tuple(
        Program(name, "", title, (), template(f"{name}.j2").render(example=ExampleNumbers(), **shared))
        for name, title in RUNNERS
    )
    return (*listings, *runners)


def _contexts(derivation: LinearTrimmer, parameters: TrimmerParameters) -> dict[str, dict[str, Any]]:
    """Return what each listing's template needs, by the listing's number."""
    return {
        "A.1": _linear_context(derivation, parameters),
        "A.2": {"gain": formulas.friction_gain()},
        "A.4": {"reached": backlash.inertia_contact_ratio(), "gain": formulas.inertia_gain()},
        "A.5": {
            "separation": backlash.separation_angle(),
            "reached": formulas.general_ratio(),
            "gain": formulas.general_gain(),
        },
        "A.6": {"friction": formulas.friction_term()},
        "A.7": {"step": formulas.friction_step()},
        "A.8": {"motion": formulas.inertia_motion()},
        "A.9": {"grid": SearchGrid()},
    }


def _linear_context(derivation: LinearTrimmer, parameters: TrimmerParameters) -> dict[str, Any]:
    output = output_row(1, 3, 4)
    lines = [
        ParameterLine(parameter.symbol, _digits(value), parameter.unit, parameter.meaning)
        for parameter, value in zip(parameter_table(), parameters.values(), strict=True)
    ]
    return {
        "parameters": lines,
        "symbols": ", ".join(line.symbol for line in lines),
        "linear": derivation.space,
        "output": output,
        "pin_input": formulas.pin_input(derivation),
        "coefficients": formulas.transfer_coefficients(derivation, tuple(output[:4])),
    }


def _environment() -> Environment:
    made = environment()
    printer = CodePrinter(NAMES)
    made.globals.update(
        assign=printer.assignment,
        matrix=printer.matrix,
        polynomials=printer.polynomials,
        generated=_generated,
    )
    made.filters.update(comment=comment, commented=_commented, digits=_digits)
    return made


def _generated(template: str, source: str = "") -> str:
    formulas_from = f", formulas from {source} by SymPy's Octave printer" if source else ""
    return comment(
        f"Generated from templates/octave/{template}{formulas_from}; do not edit. SI units throughout."
    )


def _commented(lines: str) -> str:
    """Return lines as comment lines, broken as they are."""
    return "\n".join(f"%   {line}".rstrip() for line in lines.strip("\n").split("\n"))


def _digits(value: float) -> str:
    """Return the shortest digits that read back as the same number."""
    return repr(value).removesuffix(".0")
