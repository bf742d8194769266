"""Limit cycles of the thesis's loop with friction-controlled play, of many trimmers at once."""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import real_values, require_instance
from trimmer.arrays import ArrayRecord, Complexes, Flags, Integers, Places, Reals
from trimmer.balance import LimitCycle, limit_cycles
from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD, Displacement
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.ensembles.crossings import crossings
from trimmer.ensembles.grid import frequencies_near
from trimmer.ensembles.other_poles import unstable_others
from trimmer.ensembles.polishing import polished
from trimmer.ensembles.polynomials import roots
from trimmer.ensembles.responses import Responses, responses_of
from trimmer.errors import UndecidedWarning
from trimmer.linear.model import InputChannels, pin_model
from trimmer.messages import near_or_all
from trimmer.parameter_kinds import Parameter, ParameterKind, reason_against
from trimmer.parameters import ParameterError, TrimmerParameters, parameter_table
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Table, arrays
from trimmer.ties import levels

BLOCK = 2048
"""Trimmers that are computed together: enough to make calls cheap, few enough to need little memory."""
NEAR_TANGENCY = np.sin(np.radians(2.0))
"""Sine of the angle between the curves below which a sample is searched once more, with a certificate."""


@dataclass(frozen=True, eq=False, repr=False)
class SampledLimitCycles(Tabular):
    """Limit cycles of n trimmers, a row each, in order of frequency, then of amplitude; NaN fills rows up.

    Attributes:
        amplitude: Half of peak to peak at the input of the play, m, shape (n, most).
        omega: Angular frequency, rad/s, shape (n, most).
        stable: Whether a small change dies out, shape (n, most); false where there is none.
        count: Limit cycles of each trimmer, shape (n,).
        searched_again: Trimmers whose limit cycles are those of ``limit_cycles``, one by one, because the
            curves nearly touch or the search of all was too coarse, shape (n,).
        undecided: Those of them about which that search leaves a doubt too, shape (n,).
    """

    amplitude: Reals
    omega: Reals
    stable: Flags
    count: Integers
    searched_again: Flags
    undecided: Flags

    @property
    def frequency(self) -> Reals:
        """Frequency, Hz, shape (n, most)."""
        return self.omega / (2.0 * np.pi)

    @property
    def exists(self) -> Flags:
        """Whether a trimmer has a stable limit cycle, shape (n,)."""
        return np.asarray(self.stable.any(axis=1))

    @property
    def message(self) -> str:
        """What was searched, in sentences."""
        total, again = len(self.count), int(self.searched_again.sum())
        doubt = int(self.undecided.sum())
        told = (
            f"{total} trimmers were searched on frequencies that follow their poles, without a certificate; "
            f"{again} of them, where the curves nearly touch, once more with one."
        )
        return told + (f" For {doubt} nothing is certain." if doubt else "")

    def _told(self) -> str:
        return f"{int(self.count.sum())} limit cycles of {counted(len(self.count), 'trimmer')}"

    def _table(self) -> Table:
        rows, places = np.nonzero(np.isfinite(self.amplitude))
        columns = arrays(
            sample=("", rows),
            amplitude=("m", self.amplitude[rows, places]),
            omega=("rad/s", self.omega[rows, places]),
            frequency=("Hz", self.frequency[rows, places]),
            stable=("", self.stable[rows, places]),
        )
        return Table("Limit cycles; samples are numbered from 0", range(len(rows)), columns)


@dataclass(frozen=True, eq=False)
class _Cycles(ArrayRecord):
    """Limit cycles, each with the number of its trimmer."""

    rows: Places
    amplitude: Reals
    omega: Reals
    stable: Flags


def sampled_limit_cycles(
    samples: Mapping[str, ArrayLike],
    *,
    gap: ArrayLike,
    base: TrimmerParameters | None = None,
    output: Displacement | str = CUTTER_RELATIVE_TO_GUARD,
    channels: InputChannels | str = InputChannels.DISPLACEMENT_AND_VELOCITY,
) -> SampledLimitCycles:
    """Find the limit cycles that harmonic balance predicts for many trimmers with friction-controlled play.

    It is ``limit_cycles(pin_model(parameters, output, channels), FrictionBacklash(gap))`` for each, some
    hundred times as fast. What is lost is the certificate: the curves are followed on a grid.

    Args:
        samples: Parameters by their symbols, such as ``m2``, in SI units, each a number or of shape (n,).
        gap: Total clearance, m, > 0, a number or of shape (n,).
        base: Parameters that ``samples`` does not name; those of the thesis by default.
        output: The displacement at the input of the play.
        channels: Whether the pin acts by its displacement alone, as in the thesis, or by its velocity too.

    Raises:
        ParameterError: if there is no such parameter, or a value cannot be one; it is named.
        ValueError: if lengths differ, or a gap is not positive and finite.
        ChoiceError, DisplacementError: as ``pin_model`` does.
    """
    base = TrimmerParameters.thesis() if base is None else base
    values, gaps = _arranged(samples, gap, base)
    near = _near_poles(base)
    chosen = Displacement.parse(output), InputChannels.chosen(channels, "channels")
    again = np.empty(len(gaps), dtype=bool)
    found = [_Cycles(np.empty(0, np.intp), np.empty(0), np.empty(0), np.empty(0, dtype=bool))]
    for start in range(0, len(gaps), BLOCK):
        block = slice(start, start + BLOCK)
        cycles, again[block] = _found(responses_of(values[block], *chosen), gaps[block], near)
        certain = cycles[~again[block][cycles.rows]]
        found.append(replace(certain, rows=certain.rows + start))
    undecided = np.zeros(len(gaps), dtype=bool)
    for row in np.flatnonzero(again):
        proven, undecided[row] = _searched_again(values[row], gaps[row], *chosen)
        amplitude = np.array([cycle.amplitude for cycle in proven], dtype=float)
        omega = np.array([cycle.omega for cycle in proven], dtype=float)
        stable = np.array([cycle.stable for cycle in proven], dtype=bool)
        found.append(_Cycles(np.full(len(proven), row), amplitude, omega, stable))
    return _in_rows(_Cycles.joined(found), again, undecided)


def _found(responses: Responses, gaps: Reals, near: Complexes) -> tuple[_Cycles, Flags]:
    """Search a block of trimmers, with their poles found from values near them; which need another search?"""
    poles, all_found = roots(responses.denominator, np.repeat(near[None], len(gaps), axis=0))
    enclosures = crossings(responses, frequencies_near(poles))
    here = responses[enclosures.rows]
    solutions = polished(here, enclosures)
    loeb = solutions.sine > 0
    unstable, unknown = np.zeros_like(loeb), np.zeros_like(loeb)
    # A limit cycle from which slow changes lead away needs no further look.
    unstable[loeb], unknown[loeb] = unstable_others(
        here[np.flatnonzero(loeb)], poles[enclosures.rows[loeb]], solutions[loeb]
    )
    again = enclosures.doubtful | ~all_found
    again[enclosures.rows[~solutions.found | unknown | (np.abs(solutions.sine) < NEAR_TANGENCY)]] = True
    amplitude, omega = gaps[enclosures.rows] / solutions.u, solutions.omega * here.reference
    return _Cycles(enclosures.rows, amplitude, omega, loeb & ~unstable), again


def _near_poles(base: TrimmerParameters) -> Complexes:
    """Return values to look for poles from: the same for all, so that no digit depends on others."""
    values = np.array(base.values())[None]
    plain = responses_of(values, CUTTER_RELATIVE_TO_GUARD, InputChannels.DISPLACEMENT_ONLY)
    near = np.roots(plain.denominator[0])
    # Equal ones would never part.
    return np.asarray(near * (1.0 + 1e-4 * np.arange(near.size)), dtype=complex)


def _searched_again(
    values: Reals, gap: float, output: Displacement, channels: InputChannels
) -> tuple[tuple[LimitCycle, ...], bool]:
    """Return the limit cycles of one trimmer by the search that proves, and whether that left a doubt."""
    parameters = TrimmerParameters(**dict(zip(_SYMBOLS, values.tolist(), strict=True)))
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always", UndecidedWarning)
        cycles = limit_cycles(pin_model(parameters, output, channels), FrictionBacklash(float(gap)))
    return cycles, any(issubclass(each.category, UndecidedWarning) for each in told)


def _in_rows(cycles: _Cycles, again: Flags, undecided: Flags) -> SampledLimitCycles:
    """Put the limit cycles of each trimmer into a row."""
    cycles = cycles[np.lexsort((cycles.amplitude, levels(cycles.omega), cycles.rows))]
    count = np.bincount(cycles.rows, minlength=len(again))
    place = np.arange(len(cycles.rows)) - np.repeat(np.cumsum(count) - count, count)
    shape = (len(again), int(count.max(initial=0)))
    table = np.full((2, *shape), np.nan)
    table[:, cycles.rows, place] = cycles.amplitude, cycles.omega
    stays = np.zeros(shape, dtype=bool)
    stays[cycles.rows, place] = cycles.stable
    return SampledLimitCycles(table[0], table[1], stays, count, again, undecided)


_SYMBOLS = tuple(parameter.symbol for parameter in parameter_table())


def _arranged(
    samples: Mapping[str, ArrayLike], gap: ArrayLike, base: TrimmerParameters
) -> tuple[Reals, Reals]:
    """Return parameters, shape (n, 13), and gaps, shape (n,), after all of them were checked."""
    require_instance("samples", samples, Mapping, "a mapping of symbols such as m2 to values")
    require_instance("base", base, TrimmerParameters, "a TrimmerParameters")
    for symbol in samples:
        if symbol not in _SYMBOLS:
            advice = near_or_all(str(symbol), _SYMBOLS)
            raise ParameterError(f"samples: there is no parameter {symbol!r}; {advice}")
    given = {name: real_values(name, each) for name, each in {**samples, "gap": gap}.items()}
    lengths = {name: each.size for name, each in given.items() if each.ndim}
    if any(each.ndim > 1 for each in given.values()) or len(set(lengths.values())) > 1:
        shapes = ", ".join(f"{name} {each.shape}" for name, each in given.items() if each.ndim)
        raise ValueError(f"samples: give numbers, or rows of one length; these are {shapes}")
    count = next(iter(lengths.values()), 1)
    values = np.repeat(np.array(base.values())[None], count, axis=0)
    for parameter in parameter_table():
        if parameter.symbol in given:
            values[:, _SYMBOLS.index(parameter.symbol)] = given[parameter.symbol]
            _check(parameter, np.atleast_1d(given[parameter.symbol]))
    gaps = np.broadcast_to(given["gap"], (count,)).astype(float)
    wrong = np.flatnonzero(~((gaps > 0) & np.isfinite(gaps)))
    if wrong.size:
        raise ValueError(f"gap must be positive and finite, not {gaps[wrong[0]]!r} (sample {wrong[0]})")
    return values, gaps


def _check(parameter: Parameter, values: Reals) -> None:
    least = values > 0 if parameter.quantity is ParameterKind.MASS else values >= 0
    wrong = np.flatnonzero(~(least & np.isfinite(values)))
    if wrong.size:
        value = float(values[wrong[0]])
        reason = reason_against(value, parameter.quantity)
        raise ParameterError(f"{parameter.symbol} = {value!r} (sample {wrong[0]}): {reason}")
