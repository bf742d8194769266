"""The modes that a motion has met, as the tables that the compiled integration reads.

Modes of small systems have tables of a whole step. Those of large ones, most of which are met once, are
``trimmer.hybrid.sparse`` rows: then the tables of a step are empty.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import ClassVar, Generic, NamedTuple, TypeVar

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.errors import UnsupportedMotionError
from trimmer.hybrid.clock import Samplings
from trimmer.hybrid.series import ModeTables, tabulate
from trimmer.hybrid.sparse import Rows, moduli_times, step_of, with_rows
from trimmer.hybrid.system import ModeEquations, System
from trimmer.hybrid.taylor import DEGREE, LEVELS, bernstein_from_taylor
from trimmer.kept_property import cached_property

UNKNOWN = -1  # In place of a mode to go on in: not tabulated yet
NO_RESET = -1  # In place of the number of a reset: the state goes on
JOINT = -2  # In place of a mode to go on in: several parts at rest decide it together
CAPACITY = 12  # Modes for which there is room at first
MOST_ENTRIES = 40_000  # Numbers in the tables of a step of one mode beyond which modes are rows
MOST_OF_DENSE = 400_000
"""The same where matrices are dense, as those of a structure, and few parts make few modes."""
MOST_STATUSES = 4  # Statuses that a part has, about
MOST_MATRICES = 2_000_000
"""Numbers in the matrices of such modes that are kept; others are assembled anew where they are needed."""
MOST_BYTES = 2**30  # Memory that the tables may take


class Tables(NamedTuple):
    """First axis: mode; second: event function; last of transitions: fell to zero, or negative at once."""

    rows: Rows | None  # The modes as rows; then ``screen`` to ``hold`` are empty. None for small systems.
    statuses: Integers  # Of all parts, (modes, parts)
    settled: Integers  # The mode without states that decay by themselves, itself if there are none, (modes,)
    step: Reals  # Length h of a step, s, (modes,)
    # Side by side exp(M h), transposed, and the Bernstein coefficients of the event functions over a step,
    # (modes, N, N + functions (K + 1))
    screen: Reals
    series: Reals  # (M h)^k / k!, transposed and side by side, (modes, N, (K + 1) N)
    terms: Integers  # How many terms of the series do for fractions up to 4^-level of a step, (modes, LEVELS)
    taylor: Reals  # Coefficients of s^k of the event functions, (modes, functions, N, K + 1)
    sizes: Reals  # Sums of the moduli of what these are made of, (modes, functions, K + 1, N)
    flow: Reals  # The matrix M, (modes, N, N)
    hold: Reals  # The state, made to fit what is held, transposed, (modes, N, N)
    function_count: Integers  # Number of event functions, (modes,)
    owner: Integers  # The parts that they belong to, (modes, functions)
    action: Integers  # What it means that they fall to zero, (modes, functions)
    continuous: Integers  # How many of their derivatives do not jump with other parts, (modes, functions)
    # Rate over second rate down to which tables say what follows a reset, s, (modes, functions)
    shortest: Reals
    target: Integers  # The mode to go on in, (modes, functions, 2)
    kind: Integers  # What the event counts as, (modes, functions, 2)
    # How many derivatives of the event functions of the part vanish then, by their actions, (modes,
    # functions, 2, actions)
    zeros: Integers
    reset: Integers  # Number of the state's reset, ``NO_RESET`` for none, (modes, functions, 2)
    resets: Reals  # The resets, transposed, (resets, N, N)
    decaying_state: Integers  # Place of the state of each part that may decay by itself, -1 for none, (m,)
    decay: Reals  # Rates of those that decay, 1/s, 0 for others, (modes, m)
    # Rates of those that decay or have done so, and count as zero, 1/s, 0 for others, (modes, m)
    decayed: Reals
    scale: Reals  # Size by which it is measured what of it is negligible, (m,)
    bernstein_from_taylor: Reals  # Matrices of ``trimmer.hybrid.taylor.bernstein_from_taylor``


def _entries(system: System) -> int:
    """Return how many numbers the tables of a step of one mode have."""
    size, functions = system.layout.size, 2 * system.part_count
    return size * size * (DEGREE + 4) + 3 * size * functions * (DEGREE + 1)


def _is_dense(system: System, mode: ModeEquations, most_bytes: int) -> bool:
    """Say whether a step of a large system takes fewer products by tables than by rows.

    Args:
        system: The system.
        mode: The first of its modes that is met.
        most_bytes: Memory that the tables of all modes may take.
    """
    size, functions, entries = system.layout.size, len(mode.functions), _entries(system)
    by_tables = size * (size + functions * (DEGREE + 1))
    modes = min(MOST_STATUSES**system.part_count, most_bytes)
    fits = entries <= MOST_OF_DENSE and 8 * entries * modes <= most_bytes
    return fits and bool((DEGREE + 1) * np.count_nonzero(mode.flow) > by_tables)


def _empty(system: System, capacity: int, functions: int, is_sparse: bool) -> Tables:
    size, decaying, degree = system.layout.size, system.decaying_states, DEGREE + 1
    tabulated = 0 if is_sparse else size

    def integers(*shape: int) -> Integers:
        return np.full((capacity, *shape), UNKNOWN, dtype=np.int64)

    ends = np.zeros((capacity, 2 * size + functions + 1), dtype=np.int64)
    rows = Rows(ends, np.empty(0, dtype=np.int64), np.empty(0)) if is_sparse else None
    return Tables(
        rows=rows,
        statuses=integers(system.part_count),
        settled=integers(),
        step=np.zeros(capacity),
        screen=np.zeros((capacity, tabulated, tabulated + functions * degree)),
        series=np.zeros((capacity, tabulated, degree * tabulated)),
        terms=integers(LEVELS),
        taylor=np.zeros((capacity, functions, tabulated, degree)),
        sizes=np.zeros((capacity, functions, degree, tabulated)),
        flow=np.zeros((capacity, tabulated, tabulated)),
        hold=np.zeros((capacity, tabulated, tabulated)),
        function_count=integers(),
        owner=integers(functions),
        action=integers(functions),
        continuous=integers(functions),
        shortest=np.zeros((capacity, functions)),
        target=integers(functions, 2),
        kind=integers(functions, 2),
        zeros=integers(functions, 2, system.action_count),
        reset=integers(functions, 2),
        resets=np.empty((0, size, size)),
        decaying_state=decaying,
        decay=np.zeros((capacity, len(decaying))),
        decayed=np.zeros((capacity, len(decaying))),
        scale=system.scales,
        bernstein_from_taylor=bernstein_from_taylor(),
    )


FIXED = ("rows", "decaying_state", "scale", "bernstein_from_taylor", "resets")
"""Tables whose first axis is not the mode."""
_System = TypeVar("_System", bound=System)


@dataclass(eq=False)
class Modes(Generic[_System]):
    """The modes of a system by number; they are assembled and tabulated when they are first asked for.

    Attributes:
        system: What moves.
        most_bytes: Memory that their tables may take.
        tabulated: Number of transitions that were tabulated here, and not known before.
        tables: Tables of the modes that were asked for.
    """

    may_be_sparse: ClassVar[bool] = True  # Whether those of a large system are rows
    system: _System
    most_bytes: int = MOST_BYTES
    tabulated: int = field(default=0, init=False, repr=False)
    _statuses: list[tuple[int, ...]] = field(default_factory=list, init=False, repr=False)
    _known: dict[int, ModeEquations] = field(default_factory=dict, init=False, repr=False)
    _numbers: dict[tuple[int, ...], int] = field(default_factory=dict, init=False, repr=False)
    _dense: bool = field(default=False, init=False, repr=False)

    @cached_property
    def tables(self) -> Tables:
        """Tables of all modes so far; they are replaced where there is no room."""
        is_sparse = self.may_be_sparse and not self._dense and _entries(self.system) > MOST_ENTRIES
        fitting = CAPACITY if is_sparse else self.most_bytes // (8 * _entries(self.system))
        capacity = max(min(fitting, CAPACITY), 1)
        return _empty(self.system, capacity, 2 * self.system.part_count, is_sparse)

    @cached_property
    def samplings(self) -> Samplings | None:
        """What samples the motion does in the modes so far; None for nothing."""
        clockwork = self.system.clockwork
        return None if clockwork is None else Samplings(clockwork)

    @property
    def statuses(self) -> Sequence[tuple[int, ...]]:
        """Statuses of all parts in the modes so far, by their numbers."""
        return self._statuses

    def continued(self, system: _System, tables: Tables) -> Modes[_System]:
        """Return the modes of another system with the same statuses and numbers, whose tables are known."""
        modes = type(self)(system)
        modes._statuses, modes._numbers = self._statuses.copy(), self._numbers.copy()
        vars(modes)["tables"] = tables
        if modes.samplings is not None:
            for number in range(len(self._statuses)):
                modes.samplings.add(modes, number)
        return modes

    def __getitem__(self, number: int) -> ModeEquations:
        if number not in self._known:
            self._keep(number, self.system.mode(self._statuses[number]))
        return self._known[number]

    def _keep(self, number: int, mode: ModeEquations) -> None:
        """Keep the equations of a mode, those of a large system for a while."""
        most = max(MOST_MATRICES // mode.flow.size, 4)
        if self.tables.rows is not None and len(self._known) >= most:
            del self._known[next(iter(self._known))]
        self._known[number] = mode

    def number(self, statuses: tuple[int, ...]) -> int:
        """Return the number of a mode, which is tabulated when it is new.

        Raises:
            UnsupportedMotionError: if the tables of so many modes would take too much memory.
        """
        if statuses in self._numbers:
            return self._numbers[statuses]
        mode = self.system.mode(statuses)
        if "tables" not in vars(self) and _entries(self.system) > MOST_ENTRIES:
            self._dense = _is_dense(self.system, mode, self.most_bytes)
        settled = self.number(mode.settled) if mode.settled != statuses else None
        number = len(self._statuses)
        self._make_room(number + 1, len(mode.functions))
        self._statuses.append(statuses)
        self._keep(number, mode)
        self._tabulate(number, mode)
        if self.samplings is not None:
            self.samplings.add(self, number)
        self.tables.settled[number] = number if settled is None else settled
        self._numbers[statuses] = number  # Last, so that an interrupt leaves nothing half done.
        return number

    def held(self, number: int, state: Reals) -> Reals:
        """Return an extended state, (N,), made to fit what is held in a mode."""
        dense = self.tables.rows is None
        fitted: Reals = state @ self.tables.hold[number] if dense else self[number].hold @ state
        return fitted

    def moduli(self, number: int, state: Reals) -> Reals:
        """Return the moduli of what event functions of a mode and their changes over a step are made of."""
        tables, size = self.tables, abs(state)
        count = int(tables.function_count[number])
        if tables.rows is None:
            sizes: Reals = tables.sizes[number, :count, :2].sum(axis=1) @ size
            return sizes
        changes = tables.step[number] * moduli_times(tables.rows, number, 0, len(state), size)
        return moduli_times(tables.rows, number, 2 * len(state), count, size + changes)

    def follow(self, number: int, function: int, jumped: bool) -> None:
        """Tabulate the mode that follows an event, if the statuses decide it."""
        change = self.system.transition(self[number], self[number].functions[function], jumped)
        target = JOINT if change is None else self.number(change.statuses)
        place = number, function, int(jumped)
        if change is not None:
            self.tables.kind[place] = change.kind
            self.tables.zeros[place] = 0
            for action, zeros in change.zeros:
                self.tables.zeros[(*place, action)] = zeros
            self.tables.reset[place] = NO_RESET if change.reset is None else self._keep_reset(change.reset)
        self.tables.target[place] = target
        self.tabulated += 1

    def _make_room(self, modes: int, functions: int) -> None:
        tables = self.tables
        room, has = len(tables.step), tables.owner.shape[1]
        if modes <= room and functions <= has:
            return
        room = 2 * room if modes > room else room
        arrays = (*tables, *(tables.rows or ()))
        most = sum(each.nbytes for each in arrays if isinstance(each, np.ndarray))
        if most * (room / len(tables.step)) * (max(functions, has) / has) > self.most_bytes:
            raise UnsupportedMotionError(
                f"the motion meets more than {modes - 1} combinations of contact and stick, "
                f"and the tables of more would take more than {self.most_bytes / 2**30:g} GB"
            )
        larger = _empty(self.system, room, max(functions, has), tables.rows is not None)
        for name, old in tables._asdict().items():
            if name not in FIXED:
                new = getattr(larger, name)
                new[tuple(slice(0, length) for length in old.shape)] = old
        rows = larger.rows
        if rows is not None and tables.rows is not None:
            ends = tables.rows.ends
            rows.ends[: len(ends), : ends.shape[1]] = ends
            rows = tables.rows._replace(ends=rows.ends)
        self.__dict__["tables"] = larger._replace(resets=tables.resets, rows=rows)

    def _keep_reset(self, reset: Reals) -> int:
        """Keep a reset, and return its number."""
        tables = self.tables
        self.__dict__["tables"] = tables._replace(resets=np.concatenate([tables.resets, reset.T[None]]))
        return len(tables.resets)

    def _write_rows(self, number: int, mode: ModeEquations, rows: Rows) -> None:
        """Write a mode as rows, behind those of the others."""
        functions = np.array([each.row for each in mode.functions]).reshape(-1, len(mode.flow))
        rows = with_rows(rows, number, (mode.flow, mode.hold, functions))
        self.__dict__["tables"] = self.tables._replace(rows=rows)
        self.tables.step[number] = step_of(mode.flow, self.system.layout.state_count)

    def _write_step(self, number: int, mode: ModeEquations) -> None:
        """Write the tables of a step."""
        tables, count = self.tables, len(mode.functions)
        rows = np.array([each.row for each in mode.functions]).reshape(count, len(mode.flow))
        target = ModeTables(
            tables.screen[number],
            tables.series[number],
            tables.terms[number],
            tables.taylor[number],
            tables.sizes[number],
            tables.bernstein_from_taylor,
        )
        tables.step[number] = tabulate(mode.flow, self.system.layout.state_count, rows, target)
        tables.flow[number], tables.hold[number] = mode.flow, mode.hold.T

    def _tabulate(self, number: int, mode: ModeEquations) -> None:
        if self.tables.rows is None:
            self._write_step(number, mode)
        else:
            self._write_rows(number, mode, self.tables.rows)
        tables, count = self.tables, len(mode.functions)
        tables.statuses[number] = mode.statuses
        tables.function_count[number] = count
        tables.owner[number, :count] = [each.owner for each in mode.functions]
        tables.action[number, :count] = [each.action for each in mode.functions]
        tables.continuous[number, :count] = [each.continuous for each in mode.functions]
        tables.shortest[number, :count] = [each.shortest for each in mode.functions]
        tables.decay[number] = mode.decay
        for place, rate in mode.decayed:
            tables.decayed[number, tables.decaying_state == place] = rate
