"""How equations change with a number of which they are polynomials, as with the frequency of a drive.

Three values give a polynomial of second degree, and a fourth one tells whether it is one. So the derivative
is known without another mechanism beside each value.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.branches.period_maps.value_flow import Slopes, changing
from trimmer.hybrid.tables import Modes
from trimmer.kept_property import cached_property
from trimmer.motion.flow import Flow

CURVED = 2.0**-44  # Share of its modulus by which an entry may miss the polynomial
_Statuses = tuple[int, ...]


@dataclass(eq=False)
class Curved:
    """What moves at four values of a number."""

    values: Reals  # Three values, and one between them, (4,)
    flows: tuple[Flow, ...]
    _of_mode: dict[_Statuses, tuple[Reals, ...] | None] = field(default_factory=dict, init=False)
    _of_modes: dict[tuple[_Statuses, ...], tuple[list[Reals], Integers] | None] = field(
        default_factory=dict, init=False
    )

    @classmethod
    def of(cls, values: Reals, flows: tuple[Flow, ...]) -> Curved | None:
        """Return what moves at four values; None where more than such equations changes with the number."""
        first, systems = flows[0], [each.modes.system for each in flows]
        forced = [each.layout.phasors for each in systems]
        if first.modes.tables.rows is not None or systems[0].clockwork is not None:
            return None
        if not all(map(first.is_alike, flows)) or any((each != forced[0]).any() for each in forced):
            return None
        if len(set(values.tolist())) < len(values):
            return None
        return cls(values, flows)

    def holds(self, value: float) -> bool:
        """Say whether a value is among them."""
        return bool((self.values[0] - value) * (self.values[2] - value) <= 0.0)

    def slopes(self, value: float, modes: Modes[Any]) -> Slopes | None:
        """Return the derivatives of the equations of modes, by their numbers there; None if not known."""
        key = tuple(modes.statuses)
        if key not in self._of_modes:
            self._of_modes[key] = self._stacked(modes)
        known = self._of_modes[key]
        if known is None:
            return None
        flow, hold, functions, decayed = (np.tensordot(self._rates(value), each, 1) for each in known[0])
        return Slopes(flow, known[1], hold, functions, decayed, modes.tables.resets)

    def pace(self, value: float) -> float:
        """Return the derivative of the logarithm of the drive's period, per unit."""
        if not self.flows[0].period:
            return 0.0
        frequencies = np.array([1.0 / each.period for each in self.flows[:3]])
        return -float(self._rates(value) @ frequencies / (self._shares(value) @ frequencies))

    def _stacked(self, modes: Modes[Any]) -> tuple[list[Reals], Integers] | None:
        """Return the equations of modes at three values, and how each flow changes; None if not such."""
        every = [self._equations(each) for each in modes.statuses]
        found = [each for each in every if each is not None]
        if len(found) < len(every):
            return None
        (flows, holds, rows, rates), most = zip(*found, strict=True), modes.tables.owner.shape[1]
        size = flows[0].shape[-1]
        functions = np.zeros((3, len(rows), most, size))
        for mode, each in enumerate(rows):
            functions[:, mode, : each.shape[1]] = each[:3]
        decayed = np.zeros((3, len(rates), modes.tables.decayed.shape[1]))
        for mode, each in enumerate(rates):
            for (place, _), rate in zip(modes[mode].decayed, each.T, strict=True):
                decayed[:, mode, modes.tables.decaying_state == place] = rate[:3, None]
        changes = [changing(each[0], abs(each[1:3] - each[0]).sum(axis=0)) for each in flows]
        flow, hold = (np.stack([each[:3] for each in column], axis=1) for column in (flows, holds))
        return [flow, hold, functions, decayed], np.array(changes, dtype=np.int64)

    def _equations(self, statuses: _Statuses) -> tuple[Reals, ...] | None:
        """Return flow, hold, transposed, event functions and rates of decay of a mode at four values.

        None if they are no polynomials of second degree.
        """
        if statuses not in self._of_mode:
            modes = [each.modes[each.modes.number(statuses)] for each in self.flows]
            size, names = (
                len(modes[0].flow),
                [[(f.owner, f.action) for f in each.functions] for each in modes],
            )
            system = self.flows[0].modes.system
            resets = any(system.reset(modes[0], f) is not None for f in modes[0].functions)
            found = (
                np.array([each.flow for each in modes]),
                np.array([each.hold.T for each in modes]),
                np.array([[f.row for f in each.functions] for each in modes]).reshape(4, -1, size),
                np.array([[rate for _, rate in each.decayed] for each in modes]),
            )
            are_curved = all(each == names[0] for each in names) and all(map(self._is_curved, found))
            self._of_mode[statuses] = found if are_curved and not resets else None
        return self._of_mode[statuses]

    def _is_curved(self, arrays: Reals) -> bool:
        missed = abs(np.tensordot(self._shares(float(self.values[3])), arrays[:3], 1) - arrays[3])
        return bool((missed <= CURVED * abs(arrays).max(axis=0)).all())

    def _shares(self, value: float) -> Reals:
        """Return what weighs three values in a polynomial of second degree through them, (3,)."""
        x = value / self.values[1]
        shares: Reals = np.linalg.solve(self._powers, [1.0, x, x * x])
        return shares

    def _rates(self, value: float) -> Reals:
        """Return what weighs them in its derivative, per unit."""
        unit = float(self.values[1])
        return np.asarray(np.linalg.solve(self._powers, [0.0, 1.0, 2.0 * value / unit]) / unit)

    @cached_property
    def _powers(self) -> Reals:
        return np.vander(self.values[:3] / self.values[1], increasing=True).T
