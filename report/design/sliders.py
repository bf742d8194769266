"""The sliders of the report: numbers of the mechanism, and the motions that were solved for as they move."""

import json
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from report.design.quantities import Scale, place_words, scale_for
from report.design.words.phrases import bound_words, capital, count, counted_in, measure_words
from report.design.words.sentences import left_out
from report.pages.explorable import Panel, Slider
from trimmer.design import Design, DesignFile, Measure, Target
from trimmer.design.parameter_studies.solved_grid import GridMotion, SolvedGrid
from trimmer.messages import listed
from trimmer.response.periodic.pace import DRIVE_PERIOD, period_word
from trimmer.response.results.response import MotionKind

LEVELS = 999  # Steps between the least and the largest value of a curve: finer than a line is wide
DIGITS = 4  # Digits to which values are kept
NOT_HERE = "No motion could be followed here."
ENDLESS = "The motion grows without bound here."


@dataclass(frozen=True)
class Sliders:
    """What a reader can move."""

    script: str  # The motions, as a constant of a script
    sliders: tuple[Slider, ...]  # The numbers
    panels: tuple[Panel, ...]  # What is drawn of each motion


def sliders(design: Design) -> Sliders:
    """Return the sliders of a design that has motions on a grid."""
    grid = design.grid
    assert grid is not None
    moved = tuple(_slider(grid, at) for at in range(len(grid.numbers)))
    return Sliders(f"const solvedMotions = {_told(design, grid)};\n", moved, _panels(design, grid))


def _slider(grid: SolvedGrid, at: int) -> Slider:
    number, values = grid.numbers[at], grid.values[at]
    scale = scale_for(values, number.unit)
    label = capital(place_words(number.place))
    ends = min(values), max(values)
    return Slider(f"number{at}", label, *ends, number.value, False, 1 / scale.factor, scale.unit)


def _panels(design: Design, grid: SolvedGrid) -> tuple[Panel, ...]:
    own, found = "dotted: with the numbers of the file", []
    time = _time_scale(grid)
    for name, scale in _signals(grid):
        of = capital(f"{name}, {scale.unit}" if scale.unit else name)
        found.append(Panel(f"{of}, over time in {time.unit}; {own}.", (0, 1, 0, 1), f"{name} over time"))
        if not design.file.switched:
            title = f"Its lines in dB, over the frequency in Hz; 0 dB is the largest of the file; {own}."
            found.append(Panel(title, (0, 1, 0, 1), f"Lines of {name} over frequency"))
    return tuple(found)


def _signals(grid: SolvedGrid) -> list[tuple[str, Scale]]:
    """Return name and unit of each signal, by what it is in the middle one of all motions."""
    sizes = [abs(each.curves).max(axis=1) for each in grid.motions if each.kind is not None]
    usual = np.median(np.array(sizes), axis=0) if sizes else np.ones(len(grid.signals))
    return [
        (name, scale_for([float(size)], unit)) for (name, unit), size in zip(grid.signals, usual, strict=True)
    ]


def _time_scale(grid: SolvedGrid) -> Scale:
    return scale_for([float(np.median([each.duration for each in grid.motions if each.kind]))], "s")


def _told(design: Design, grid: SolvedGrid) -> str:
    signals = _signals(grid)
    places = [each.place for each in grid.numbers]
    table: dict[str, Any] = {
        "numbers": list(map(place_words, places)),
        "values": [list(each) for each in grid.values],
        "own": [each.value for each in grid.numbers],
        "levels": LEVELS,
        "time": 1 / _time_scale(grid).factor,
        "frequency": design.file.mechanism.frequency or 0.0,
        "frequencyAt": places.index("frequency") if "frequency" in places else None,
        "spectra": not design.file.switched,
        "scales": [1 / scale.factor for _, scale in signals],
        "targets": [_target(each) for each in grid.targets],
        "motions": [_motion(grid, each, design.file) for each in grid.motions],
    }
    # In a script "<" might begin the end of it.
    return json.dumps(table, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")


def _target(target: Target) -> dict[str, Any]:
    scale = scale_for([target.bound], target.unit or target.measure.unit)
    return {
        "name": capital(measure_words(target.measure, target.part)),
        "wanted": bound_words(target),
        "factor": 1 / scale.factor,
        "unit": None if target.measure is Measure.PERIOD else scale.unit,
    }


def _motion(grid: SolvedGrid, motion: GridMotion, file: DesignFile) -> list[Any]:
    """Return what the script shows of a motion, as a list without names, since there are hundreds."""
    met = [target.met_by(value) for target, value in zip(grid.targets, motion.measures, strict=True)]
    if motion.kind is None:
        return [NOT_HERE]
    if motion.kind is MotionKind.DIVERGING or not np.isfinite(motion.curves).all():
        return [ENDLESS]
    return [
        _kind(motion, file),
        [_kept(each) for each in motion.measures],
        [int(each) for each in met],
        _kept(motion.duration),
        [_curve(each.tolist()) for each in motion.curves],
        [[[p, k, _kept(size)] for p, k, size in lines] for lines in motion.lines],
    ]


def _kind(motion: GridMotion, file: DesignFile) -> str:
    if file.switched:
        return "it comes to rest" if motion.kind is MotionKind.REST else "it was not seen to rest"
    word = period_word(file.mechanism)
    if motion.period_count:
        return f"it repeats after {counted_in(word, motion.period_count)}"
    lines = f"lines are those at multiples of the {'drive' if word == DRIVE_PERIOD else 'sampling'}"
    return {
        MotionKind.TORUS: f"it beats and never quite repeats; {lines}",
        MotionKind.REST: "nothing moves",
        MotionKind.CHAOTIC: f"it is chaotic; {lines}",
    }.get(motion.kind or MotionKind.UNDECIDED, "it had not settled when the wait was over")


def _kept(value: float) -> float | None:
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None


def _curve(values: list[float]) -> list[Any]:
    """Return least and largest value of a curve, and its points in steps between them."""
    least, largest = min(values), max(values)
    step = (largest - least) / LEVELS or 1.0
    return [float(f"{least:.6g}"), float(f"{largest:.6g}"), [round((each - least) / step) for each in values]]


def slider_sentences(design: Design) -> str:
    """Say what moves, and what is behind it."""
    grid = design.grid
    assert grid is not None
    which = listed([place_words(each.place) for each in grid.numbers])
    failed = sum(each.kind is None for each in grid.motions)
    lost = f" At {count(failed, 'point')} no motion could be followed." if failed else ""
    coarse = " There was no time left for a finer grid." if left_out(design, "SLIDERS") else ""
    size = " × ".join(str(len(each)) for each in grid.values)
    return (
        f"In the HTML report sliders move the {which}. Behind them lie {len(grid.motions)} motions, {size}, "
        "each solved for from the file’s own start. What is shown is always the one whose numbers are "
        f"nearest to the sliders; nothing between them is guessed.{lost}{coarse}"
    )
