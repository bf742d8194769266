"""The summary of the linear model as text for people and as JSON for machines."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.table import table
from trimmer.displacement import TrimmerBody
from trimmer.linear import InputChannels, Mode
from trimmer.linear.summary import CRITICAL_POINT, LinearSummary

_CHANNELS = {
    InputChannels.DISPLACEMENT_ONLY: "displacement only",
    InputChannels.DISPLACEMENT_AND_VELOCITY: "displacement and velocity",
}

Rows = Iterable[tuple[str, ...]]


def as_text(summary: LinearSummary) -> str:
    """Return the summary as short tables in Hz, rad/s and dB."""
    sections = (
        [
            f"Linear trimmer: output {summary.output.label}, pin acts by {_CHANNELS[summary.channels]}, "
            f"{'stable' if _is_stable(summary) else 'not asymptotically stable'}"
        ],
        _table(
            "Modes",
            (
                "Hz",
                "rad/s",
                "damping ratio",
                "eigenvalue, 1/s",
                *(f"|{body.coordinate}|" for body in TrimmerBody),
            ),
            _mode_rows(summary.modes),
        ),
        _table("Poles and zeros, rad/s", ("poles", "zeros"), _root_rows(summary)),
        _table("Gain", ("quantity", "value"), _gain_rows(summary)),
        _table("Extrema of |G|", ("kind", "rad/s", "Hz", "|G|", "dB"), _extremum_rows(summary)),
        _table(
            "Crossings of the real axis",
            ("rad/s", "Hz", "G"),
            (
                (_number(c.omega), _number(_hertz(c.omega)), _number(c.value))
                for c in summary.real_axis_crossings
            ),
        ),
    )
    return "\n\n".join("\n".join(lines) for lines in sections)


def as_json(summary: LinearSummary) -> str:
    """Return the summary as JSON: full precision, SI units."""
    modes = ("eigenvalue", "omega_natural", "omega_damped", "frequency", "damping_ratio", "shape")
    content = {
        "parameters": asdict(summary.parameters),
        "output": summary.output.label,
        "channels": summary.channels.value,
        "stable": _is_stable(summary),
        "modes": [picked(mode, *modes) for mode in summary.modes],
        **picked(summary.factored, "poles", "zeros", "static_gain"),
        "gain_crossings": summary.gain_crossings,
        "real_axis_crossings": [picked(each, "omega", "value") for each in summary.real_axis_crossings],
        "bandwidth": summary.low_pass.bandwidth if summary.low_pass else None,
        "bandwidth_crossings": summary.low_pass.crossings if summary.low_pass else None,
        "peaks": [picked(each, "omega", "magnitude") for each in summary.peaks],
        "dips": [picked(each, "omega", "magnitude") for each in summary.antiresonances],
        **picked(summary, "roll_off", "encirclements"),
    }
    return document(content)


def _mode_rows(modes: Sequence[Mode]) -> Rows:
    for mode in modes:
        numbers = (mode.frequency, mode.omega_natural, mode.damping_ratio)
        shape = (f"{abs(entry):.3g}" for entry in mode.shape)
        yield (*map(_number, numbers), _complex(mode.eigenvalue), *shape)


def _root_rows(summary: LinearSummary) -> Rows:
    poles, zeros = (
        [_complex(root) for root in roots if root.imag >= 0]
        for roots in (summary.factored.poles, summary.factored.zeros)
    )
    for row in range(max(len(poles), len(zeros))):
        yield tuple(column[row] if row < len(column) else "" for column in (poles, zeros))


def _gain_rows(summary: LinearSummary) -> Rows:
    yield "G(0)", _number(summary.factored.static_gain)
    yield "|G| = 1 (0 dB) at", _frequencies(summary.gain_crossings)
    if summary.low_pass is None:
        yield "bandwidth", "not defined: G(0) is zero or infinite"
    else:
        yield "bandwidth (-3 dB from G(0))", _frequencies((summary.low_pass.bandwidth,))
        yield "-3 dB from G(0) at", _frequencies(summary.low_pass.crossings)
    yield "roll-off", f"{_number(summary.roll_off)} dB per decade"
    count = "not defined: on the locus" if summary.encirclements is None else str(summary.encirclements)
    yield f"clockwise encirclements of {CRITICAL_POINT:g}", count


def _extremum_rows(summary: LinearSummary) -> Rows:
    for extremum in sorted(summary.peaks + summary.antiresonances, key=lambda extremum: extremum.omega):
        kind = "peak" if extremum in summary.peaks else "dip"
        values = (extremum.omega, _hertz(extremum.omega), extremum.magnitude, _decibels(extremum.magnitude))
        yield (kind, *map(_number, values))


def _table(title: str, heads: tuple[str, ...], rows: Rows) -> list[str]:
    return [title, *table(heads, list(rows))]


def _frequencies(omegas: Sequence[float]) -> str:
    return ", ".join(map(_number, omegas)) + " rad/s" if omegas else "no frequency"


def _number(value: float) -> str:
    return f"{value:.6g}"


def _complex(value: complex) -> str:
    return f"{value.real:.6g}" if value.imag == 0 else f"{value.real:.6g} ± {value.imag:.6g}j"


def _hertz(omega: float) -> float:
    return omega / (2 * math.pi)


def _decibels(magnitude: float) -> float:
    return 20 * math.log10(magnitude) if magnitude > 0 else -math.inf


def _is_stable(summary: LinearSummary) -> bool:
    return all(mode.eigenvalue.real < 0 for mode in summary.modes)
