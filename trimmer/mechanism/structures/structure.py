"""A linear part from elsewhere: matrices of a finite-element model, or measured modes.

M q'' + C q' + K q = forces. With matrices, q are the coordinates that are named, and forces act on them
directly: a Craig-Bampton reduction has this form (Craig and Bampton, AIAA Journal 6, 1968). With modes of
unit modal mass, q are those of the modes, M = 1, C = diag(2 ζ ω) and K = diag(ω²), and points stand for what
the modes move: their weights are the mode shapes there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from trimmer.mechanism.read_only import ReadOnly

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.mechanism.elimination import Solutions

MOST = 1000  # Coordinates of a structure; the equations of motion are dense

LETTERS = {"mass": "M", "stiffness": "K", "damping": "C"}  # Usual letters of the matrices
MATRICES = ("mass", "stiffness", "damping")  # Fields that are matrices


@dataclass(frozen=True, eq=False, repr=False)
class ModalModel:
    """Modes of a structure for unit modal mass.

    Attributes:
        frequency: Undamped natural frequencies, Hz, (modes,); 0 for one that is rigid.
        damping_ratio: Damping ratios, (modes,).
        shapes: By the name of a point, how far each mode moves it, kg^-1/2, (modes,).
    """

    frequency: Reals
    damping_ratio: Reals
    shapes: Mapping[str, Reals]


@dataclass(frozen=True, eq=False, repr=False)
class Structure:
    """A linear part given by matrices, or by modes.

    Attributes:
        mass: M, (n, n), symmetric and positive definite, kg; kg m² for rotations.
        stiffness: K, (n, n), symmetric, without negative eigenvalues, N/m.
        damping: C, (n, n), symmetric, N s/m; none by default.
        damping_ratio: In place of ``damping``, that of all modes but rigid ones.
        coordinates: A name for each row.
        rotations: Those of the names whose coordinates are angles.
        modes: In place of all others.
        files: Of what was read from files, their names for messages, by field.
    """

    mass: Reals | None = None
    stiffness: Reals | None = None
    damping: Reals | None = None
    damping_ratio: float | None = None
    coordinates: tuple[str, ...] = ()
    rotations: tuple[str, ...] = ()
    modes: ModalModel | None = None
    files: Mapping[str, str] = field(default_factory=dict)

    def taken(self) -> Structure:
        """Return the same with arrays of floats that cannot be written to, symmetric ones for matrices."""
        changes: dict[str, Any] = {
            name: _frozen(0.5 * (matrix + matrix.T))
            for name in MATRICES
            if (matrix := _array(getattr(self, name))) is not None
        }
        if self.modes is not None:
            shapes = {name: _frozen(shape) for name, shape in self.modes.shapes.items()}
            frequency, damping_ratio = (
                _frozen(each) for each in (self.modes.frequency, self.modes.damping_ratio)
            )
            changes["modes"] = ModalModel(frequency, damping_ratio, ReadOnly(shapes))
        changes |= {"coordinates": tuple(self.coordinates), "rotations": tuple(self.rotations)}
        return replace(self, **changes, files=ReadOnly(dict(self.files)))

    def __eq__(self, other: object) -> bool:
        return self._contents == other._contents if isinstance(other, Structure) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._contents)

    def __repr__(self) -> str:
        return f"<Structure: {len(self.names)} coordinates>"

    @cached_property
    def _contents(self) -> tuple[object, ...]:
        arrays = [_array(getattr(self, name)) for name in MATRICES]
        names = (tuple(self.coordinates), tuple(self.rotations))
        modes: tuple[object, ...] = ()
        if self.modes is not None:
            shapes = ((name, _array(shape)) for name, shape in self.modes.shapes.items())
            arrays += [_array(self.modes.frequency), _array(self.modes.damping_ratio)]
            modes = tuple((name, None if shape is None else shape.tobytes()) for name, shape in shapes)
        numbers = tuple(None if each is None else (each.shape, each.tobytes()) for each in arrays)
        return (*numbers, self.damping_ratio, *names, modes)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of its coordinates, without its own."""
        if self.modes is None:
            return tuple(self.coordinates)
        return tuple(f"mode{number}" for number in range(1, len(self.modes.frequency) + 1))

    @property
    def points(self) -> Mapping[str, Reals]:
        """By name, without its own, the weights of its coordinates at each of its points, (n,)."""
        return {} if self.modes is None else self.modes.shapes

    @cached_property
    def matrices(self) -> tuple[Reals, Reals, Reals]:
        """M, C and K, (n, n) each."""
        import numpy as np

        if self.modes is not None:
            omega = 2 * np.pi * self.modes.frequency
            return np.eye(len(omega)), np.diag(2 * self.modes.damping_ratio * omega), np.diag(omega**2)
        assert self.mass is not None and self.stiffness is not None
        if self.damping is not None:
            return self.mass, self.damping, self.stiffness
        return self.mass, self._modal_damping(self.damping_ratio or 0.0), self.stiffness

    @cached_property
    def shifts(self) -> Solutions:
        """The directions along which it may be moved without a change of its forces."""
        import numpy as np

        from trimmer.mechanism.elimination import solutions

        stiffness = self.matrices[2] if self.stiffness is None else self.stiffness
        return solutions(stiffness, np.zeros(len(stiffness)))

    @cached_property
    def strains(self) -> Reals:
        """Sums of its coordinates that are all 0 for such a movement, and for no other, (n - shifts, n)."""
        import numpy as np

        directions, free = self.shifts.directions, self.shifts.free
        sums = np.eye(len(directions))
        sums[:, free] -= directions
        return np.delete(sums, free, axis=0)

    def _modal_damping(self, ratio: float) -> Reals:
        """Return M P diag(2 ζ ω) Pᵀ M with the modes P of unit modal mass; rigid ones stay undamped."""
        import numpy as np

        assert self.mass is not None and self.stiffness is not None
        factor = np.linalg.cholesky(self.mass)
        relative = np.linalg.solve(factor, np.linalg.solve(factor, self.stiffness).T)
        values, vectors = np.linalg.eigh(0.5 * (relative + relative.T))
        values[: len(self.shifts.free)] = 0.0
        moved = factor @ vectors  # M P
        damping = (moved * (2 * ratio * np.sqrt(np.maximum(values, 0.0)))) @ moved.T
        return np.asarray(0.5 * (damping + damping.T))


def _array(values: Any) -> Reals | None:
    import numpy as np

    return None if values is None else np.asarray(values, dtype=np.float64)


def _frozen(values: Any) -> Reals:
    import numpy as np

    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array
