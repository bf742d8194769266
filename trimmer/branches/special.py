"""Special points of a branch."""

from dataclasses import dataclass

from trimmer.arrays import Reals
from trimmer.choices import Choice
from trimmer.showing.shown import Shown


class SpecialKind(Choice):
    """What happens at a special point."""

    GRAZING = "a contact is born or dies tangentially"
    STICK = "a phase of stick is born or dies"
    FOLD = "the branch turns around"
    PERIOD_DOUBLING = "a multiplier passes -1: a branch of twice the period parts"
    TORUS = "a pair of multipliers passes the unit circle: a torus parts"
    SYMMETRY_BREAKING = "a multiplier passes 1 without a fold: a pair of asymmetric branches parts"


@dataclass(frozen=True, eq=False, repr=False)
class SpecialPoint(Shown):
    """A special point of a branch.

    Attributes:
        kind: What happens there.
        value: Value of the number that is varied.
        state: State at the start of a drive period, shape (n,); without a drive any on the motion, and the
            period last.
        parts: Names of the parts whose phases change there, in the order of their names.
        note: What else is to be said, empty if nothing.
    """

    kind: SpecialKind
    value: float
    state: Reals
    parts: tuple[str, ...] = ()
    note: str = ""

    def _told(self) -> str:
        parts = f" of {' and '.join(self.parts)}" if self.parts else ""
        return f"{self.kind.word}{parts} at {self.value:.9g}"
