"""What is proven by ball arithmetic and kept in ``examples/proofs``, held against the numbers of cards.

A card may say so only in a sentence from here: each fails where the kept proof is of other numbers than the
card's. That the proofs hold is checked again by ``trimmer check``, which the tests run.
"""

import json
import math
import re
from collections.abc import Sequence
from typing import Any

import control
import numpy as np

from trimmer import LimitCycle, PeriodicOrbit
from trimmer.examples import example_proof

ALIKE = 1e-9  # Relative difference up to which a number of a card is that of a proof
PLACES = 1j * np.array([10.0, 700.0, 3478.0, 4609.0, 9000.0])
"""Where two plants are held against each other, 1/s."""
SAME_PLANT = 1e-7
"""Relative difference there that rounding of a transfer function makes of matrices, and more."""
COMPUTED = 1e-3  # The same of a frequency that was counted in a simulated motion


class OtherNumbersError(ValueError):
    """A kept proof is none of what a card says; the message names both."""


def solutions_are_proven(
    name: str, plant: control.TransferFunction, gap: float, cycles: Sequence[LimitCycle]
) -> str:
    """Return the sentence that a list of limit cycles of a loop with play is complete.

    The proof is of a gap, m; plant and cycles are of the card, these for a gap of one metre.

    Raises:
        OtherNumbersError: if the proof is of another plant, gap or list.
    """
    data = _kept(name)["data"]
    proven = control.ss(*(data["plant"][each] for each in "ABCD"))
    same = np.allclose(proven(PLACES), plant(PLACES), rtol=SAME_PLANT, atol=0.0)
    told = [number for each in data["limit_cycles"] for number in (each["amplitude"], each["omega"])]
    found = [number for each in cycles for number in (gap * each.amplitude, each.omega)]
    _require(name, same and data["omega_range"] is None, "another loop")
    _require(name, [each["gap"] for each in data["element"]] == [gap], f"another gap than {gap} m")
    alike = len(told) == len(found) and np.allclose(sorted(told), sorted(found), rtol=ALIKE, atol=0.0)
    _require(name, alike, f"another list than {found}")
    count = {0: "no solution", 1: "one solution"}.get(len(cycles), f"{len(cycles)} solutions and no other")
    return (
        f"Proven by ball arithmetic: from frequency 0 to infinity $1 + NG = 0$ has {count} ({_file(name)})."
    )


def orbit_is_proven(name: str, orbit: PeriodicOrbit) -> str:
    """Return the sentence that an exact limit cycle is there, and its largest multiplier.

    Raises:
        OtherNumbersError: if the proof is of another period or stability.
    """
    lower, upper = _multiplier(name)
    largest = float(abs(orbit.nontrivial_multipliers).max())
    _require(name, abs(_period(name) / orbit.period - 1) < ALIKE, f"another period than {orbit.period} s")
    inside = math.isclose(np.clip(largest, lower, upper), largest, rel_tol=1e-6)
    _require(name, inside, f"another multiplier than {largest}")
    word = "stable" if orbit.stable else "unstable"
    return (
        f"Proven by ball arithmetic: this exact motion exists and is {word}, with a largest multiplier "
        f"between {lower} and {upper} ({_file(name)})."
    )


def cycle_is_proven(name: str, force: float, gap: float, frequency: float, none_at: float) -> str:
    """Return the sentence that a limit cycle with friction is there, and that none with more is computed.

    Frictions are in N, the gap in m, the frequency in Hz, as counted in a simulated motion.

    Raises:
        OtherNumbersError: if the proof is of another friction, gap or frequency.
    """
    about = str(_kept(name)["data"]["motion"]["about"])
    _require(name, f"force={force})" in about and f"gap={gap})" in about, f"another loop: {about}")
    _require(name, abs(_period(name) * frequency - 1) < COMPUTED, f"another frequency than {frequency} Hz")
    return (
        f"Proven by ball arithmetic: with {force} N the exact limit cycle is there and stable "
        f"({_file(name)}); that none is left with {none_at} N is computed, not proven."
    )


def _kept(name: str) -> dict[str, Any]:
    told: dict[str, Any] = json.loads(example_proof(name))
    _require(name, told["verdict"] == "proven", "nothing, since it is not proven")
    return told


def _period(name: str) -> float:
    segments = _kept(name)["data"]["motion"]["segments"]
    return math.fsum(each["duration"] for each in segments)


def _multiplier(name: str) -> tuple[float, float]:
    found = re.search(r"is between (\S+) and (\S+)\.$", _kept(name)["theorem"])
    assert found is not None
    return float(found[1]), float(found[2])


def _file(name: str) -> str:
    return f"`examples/proofs/{name}.json`"


def _require(name: str, holds: object, other: str) -> None:
    if not holds:
        raise OtherNumbersError(f"{_file(name)} proves {other}; prove what the card says, and keep that")
