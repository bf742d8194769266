"""Modes and frequency responses of a mechanism, as text for people and as JSON for machines."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.parser import OptionError
from trimmer.command_line.table import table
from trimmer.mechanism.kinds import Kind
from trimmer.messages import listed
from trimmer.motion.units import with_unit
from trimmer.showing.shown import counted

if TYPE_CHECKING:
    from trimmer.contact.control_loops import ControlLoops
    from trimmer.design.analysis.linear import LinearState, TransferFunction
    from trimmer.linear.margins import Margins
    from trimmer.mechanism.mechanism import Mechanism

TURNED = 10.0  # Degrees by which a share of a mode may be out of phase and yet be shown with a sign alone
STILL = 5e-4  # Share of the largest displacement of a mode that is shown as 0


def chosen_states(mechanism: Mechanism, texts: Sequence[str]) -> tuple[LinearState, ...]:
    """Return the linear mechanism in states of its contacts, such as ``closed`` and ``bridge=open``."""
    from trimmer.design.analysis.linear import all_drives, linear_state, linear_states

    drives = all_drives(mechanism)
    if not texts:
        return linear_states(mechanism, drives)
    whole: list[str | Mapping[str, str]] = [text for text in texts if "=" not in text]
    named: dict[str, str] = {}
    for name, _, state in (text.rpartition("=") for text in texts if "=" in text):
        contact = name.strip().strip("\"'")
        if contact in named:
            raise OptionError(f"--contacts {contact}={state}: {contact} was given before; give it once")
        named[contact] = state.strip()
    try:
        return tuple(linear_state(mechanism, each, drives) for each in [*whole, *([named] if named else [])])
    except ValueError as error:
        raise OptionError(f"--contacts {' '.join(texts)}: {error}") from error


def as_text(mechanism: Mechanism, states: Sequence[LinearState]) -> str:
    """Return tables of the modes and of the frequency responses in each state of the contacts."""
    parts = ([*_state(mechanism, state), *_loops(mechanism, state)] for state in states)
    left_out = [("Dry friction is", mechanism.frictions), ("Rigid walls are", mechanism.walls)]
    friction = [f"{what} left out." for what, there in left_out if there]
    return "\n".join(["\n\n".join("\n".join(lines) for lines in parts), *friction])


def as_json(mechanism: Mechanism, states: Sequence[LinearState]) -> str:
    """Return the same as JSON: full precision, SI units."""
    return document(
        {
            "coordinates": states[0].bodies,
            "states": [
                {
                    "contacts": state.contacts.value,
                    "open": state.open,
                    "modes": [picked(mode, "frequency", "damping_ratio", "shape") for mode in state.modes],
                    **picked(state, "rigid", "decaying"),
                    "responses": [_response(each) for each in state.transfer],
                    "loops": _loops_json(mechanism, state),
                }
                for state in states
            ],
        }
    )


def _response(function: TransferFunction) -> dict[str, Any]:
    return {
        "input": function.drive,
        **picked(function, "output", "at_drive"),
        "frequencies": function.frequency,
        "magnitudes": abs(function.response),
        "phases": [cmath.phase(each) for each in function.response.tolist()],
    }


def _contacts(mechanism: Mechanism, state: LinearState) -> str:
    count = len(mechanism.plays) + len(mechanism.stops)
    if not count:
        return "No contacts"
    some = 0 < len(state.open) < count
    return f"{listed(state.open)} open, other contacts closed" if some else f"Contacts {state.contacts.value}"


def _state(mechanism: Mechanism, state: LinearState) -> Iterator[str]:
    others = [
        f"{number} motion{'s' if number > 1 else ''} that {told}" for number, told in _others(state) if number
    ]
    yield f"{_contacts(mechanism, state)}: {counted(len(state.modes), 'mode')}" + "".join(
        f", {each}" for each in others
    )
    units = {name: kind.unit("m") for name, kind in mechanism.kinds.items()}
    mixed = Kind.ROTATION in mechanism.kinds.values()
    heads = ("Hz", "damping ratio", *(with_unit(n, units[n]) if mixed else n for n in state.bodies))
    yield from table(
        heads, [_mode(mode.frequency, mode.damping_ratio, mode.shape.tolist()) for mode in state.modes]
    )
    if state.transfer:
        heads = ("from", "to", "at the drive", "phase", "largest", "at Hz")
        yield from table(heads, [_peak(each, mixed) for each in state.transfer])


def _loops(mechanism: Mechanism, state: LinearState) -> Iterator[str]:
    from trimmer.contact.control_loops import loops_of

    sampled = [name for name, each in mechanism.controllers.items() if each.sample is not None]
    for found in loops_of(mechanism, state.open):
        if found is None:
            yield (
                f"Sampled controllers ({listed(map(repr, sampled))}) are left out, since their samples "
                "differ; with pade = n in place of sample each has margins, if approximate ones"
            )
            continue
        alone = found.sample is None and sampled
        beside = (
            f", while {listed(map(repr, sampled))} hold{'s' if len(sampled) == 1 else ''}" if alone else ""
        )
        exactly = f", sampled at {1.0 / found.sample:.6g} Hz" if found.sample else ""
        yield f"With controllers{exactly}{beside}: {_standing(found)}"
        heads = ("loop of", "lower gain margin", "at Hz", "upper", "at Hz", "phase margin", "at Hz")
        rows = [
            (
                *(name, _factor(each.lower_gain.value), _hertz(each.lower_gain.omega)),
                *(_factor(each.upper_gain.value), _hertz(each.upper_gain.omega)),
                *(_degrees(each.phase.value), _hertz(each.phase.omega)),
                *(_factor(each.modulus.value), _hertz(each.modulus.omega)),
            )
            for name, each in found.loops.items()
        ]
        yield from table((*heads, "modulus margin", "at Hz"), rows)
        if found.stable:
            yield from (_stable_gains(name, each) for name, each in found.loops.items())


def _standing(found: ControlLoops) -> str:
    if found.grows:
        return f"unstable: it grows by e in {1.0 / found.grows:.4g} s"
    return f"marginal: {found.marginal}" if found.marginal else "stable"


def _stable_gains(name: str, margins: Margins) -> str:
    """Say between which gains a loop that is stable stays so."""
    lower, upper = margins.lower_gain.value, margins.upper_gain.value
    if not lower and math.isinf(upper):
        return f"stable at any gain of {name!r}"
    if math.isinf(upper):
        return f"stable while the gain of {name!r} is more than {lower:.5g} times what it is"
    between = f"between {lower:.5g} and {upper:.5g}" if lower else f"less than {upper:.5g}"
    return f"stable while the gain of {name!r} is {between} times what it is"


def _factor(value: float) -> str:
    return f"{value:.5g}" if 0 < value < math.inf else "none"


def _degrees(value: float) -> str:
    return f"{math.degrees(value):.5g}°" if math.isfinite(value) else "none"


def _hertz(omega: float) -> str:
    return f"{omega / math.tau:.5g}" if math.isfinite(omega) else ""


def _loops_json(mechanism: Mechanism, state: LinearState) -> list[dict[str, Any]]:
    from trimmer.contact.control_loops import loops_of

    return [
        {
            "controller": name,
            **picked(found, "sample", "stable", "marginal"),
            "gain_margin": each.gain.value,
            "lower_gain_margin": each.lower_gain.value or None,
            "upper_gain_margin": each.upper_gain.value,
            "phase_margin": each.phase.value,
            "modulus_margin": each.modulus.value,
            "phase_crossing": each.gain.omega / math.tau,
            "lower_crossing": each.lower_gain.omega / math.tau,
            "upper_crossing": each.upper_gain.omega / math.tau,
            "gain_crossing": each.phase.omega / math.tau,
            "nearest": each.modulus.omega / math.tau,
        }
        for found in loops_of(mechanism, state.open)
        if found is not None
        for name, each in found.loops.items()
    ]


def _others(state: LinearState) -> tuple[tuple[int, str], ...]:
    only = "only decays" if state.decaying == 1 else "only decay"
    return (state.rigid, "no spring resists"), (state.decaying, only)


def _mode(frequency: float, damping_ratio: float, shape: Sequence[complex]) -> tuple[str, ...]:
    ratio = f"{damping_ratio:.4g}" if abs(damping_ratio) > 1e-12 else "0"
    return f"{frequency:.6g}", ratio, *map(_share, shape)


def _share(entry: complex) -> str:
    """Return a share of a mode: with a sign, or with its phase where it is out of phase."""
    if abs(entry) < STILL:
        return "0"
    degrees = math.degrees(cmath.phase(entry))
    if min(abs(degrees), 180.0 - abs(degrees)) <= TURNED:
        return f"{math.copysign(abs(entry), entry.real):.3g}"
    return f"{abs(entry):.3g} at {degrees:.0f}°"


def _peak(function: TransferFunction, mixed: bool) -> tuple[str, ...]:
    drive, output = function.drive, function.output
    if mixed:
        drive, output = with_unit(drive, function.unit), with_unit(output, function.output_unit)
    sizes = abs(function.response)
    at = int(sizes.argmax())
    there = function.at_drive
    if not sizes[at]:
        return drive, output, "0", "-", "0", "-"
    own = (
        ("-", "-")
        if there is None
        else (f"{abs(there):.5g}", f"{round(math.degrees(cmath.phase(there)), 1) + 0.0:.1f}°")
    )
    return drive, output, *own, f"{sizes[at]:.5g}", f"{function.frequency[at]:.6g}"
