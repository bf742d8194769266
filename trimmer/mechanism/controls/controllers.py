"""What controls a mechanism: it measures an output y, compares it with a reference r and acts with a force u.

The laws, with e = r - y, are in ``docs/mechanism.md``. SI units, that of y and that of what acts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar

from trimmer.mechanism.place_text import place_text

if TYPE_CHECKING:
    from control import StateSpace, TransferFunction

DIFFERENCE = "difference"
"""In place of an output: the speed of a sampled cascade is the difference of y over a sample."""


@dataclass(frozen=True, kw_only=True)
class Controller:
    """A controller: what it measures, between which ends it acts, its limit, sample and delay.

    Attributes:
        measure: Name of the output y.
        acts: Names of start and end of the force u, which pushes the end, and its opposite the start.
        reference: Name of the reference r; 0 without.
        limit: Largest modulus of u that acts, N or N m; None for no limit.
        tracking: Time in which the integral follows the limit, s, ``inf`` for never; None for the default.
        sample: Time between samples, s; None for a continuous controller.
        delay: Time from a sample to what acts, s.
        pade: Order of the Padé approximant of the delay of a continuous controller.
    """

    measure: str
    acts: tuple[str, str]
    reference: str | None = None
    limit: float | None = None
    tracking: float | None = None
    sample: float | None = None
    delay: float = 0.0
    pade: int | None = None

    word: ClassVar[str]
    """The word for the kind in a file."""
    speed: ClassVar[str | None] = None

    @property
    def integrates(self) -> bool:
        """Whether it has an integral part."""
        return False

    @property
    def default_tracking(self) -> float | None:
        """The time, s, in which the integral follows the limit if none is given; None if it must be."""
        return None

    @property
    def tracking_time(self) -> float | None:
        """The time in which the integral follows the limit, s; None where nothing follows."""
        if self.limit is None or not self.integrates:
            return None
        return self.default_tracking if self.tracking is None else self.tracking


@dataclass(frozen=True, kw_only=True)
class Pid(Controller):
    """PID control, u = kp e + I + D with I' = ki e, D = kd (e - z)/filter_time, z' = (e - z)/filter_time.

    Attributes:
        kp: Gain, N/m.
        ki: Gain of the integral, N/(m s).
        kd: Gain of the rate, N s/m; it needs a filter time.
        filter_time: Time constant of the filter of the rate, s.
    """

    kp: float = 0.0
    ki: float = 0.0
    kd: float = 0.0
    filter_time: float = 0.0

    word: ClassVar[str] = "pid"

    @property
    def integrates(self) -> bool:
        """Whether ki is not 0."""
        return self.ki != 0

    @property
    def default_tracking(self) -> float | None:
        """kp/ki where both are positive."""
        return self.kp / self.ki if self.kp > 0 and self.ki > 0 else None


@dataclass(frozen=True, kw_only=True)
class Cascade(Controller):
    """A speed loop in a position loop: f = kp e + feedforward r' - v, u = kv f + I, I' = (kv/ti) f.

    Attributes:
        kp: Gain of the position, 1/s.
        kv: Gain of the speed, N s/m.
        ti: Time of the integral, s; None for no integral.
        feedforward: Share of the rate of the reference.
        speed: Name of the output v; None for the rate of y. ``difference`` is that of y over a sample.
    """

    kp: float = 0.0
    kv: float = 0.0
    ti: float | None = None
    feedforward: float = 0.0
    speed: str | None = None  # type: ignore[misc]

    word: ClassVar[str] = "cascade"

    @property
    def integrates(self) -> bool:
        """Whether ti is given."""
        return self.ti is not None

    @property
    def default_tracking(self) -> float | None:
        """The time of the integral."""
        return self.ti


@dataclass(frozen=True, kw_only=True)
class TransferController(Controller):
    """Control by a proper transfer function C of the error, u = C(s) e.

    Attributes:
        numerator: Coefficients, descending powers of s.
        denominator: Coefficients, descending powers of s; the first is not 0.
    """

    numerator: tuple[float, ...]
    denominator: tuple[float, ...]

    word: ClassVar[str] = "transfer"

    @classmethod
    def of_system(cls, system: TransferFunction | StateSpace, **others: Any) -> TransferController:
        """Return the controller of a continuous system of python-control with one input and one output.

        Args:
            system: The system.
            **others: What all controllers have, such as ``measure`` and ``acts``.

        Raises:
            MechanismError: if the system is sampled, or has several inputs or outputs.
        """
        import control

        from trimmer.errors import MechanismError

        if system.ninputs != 1 or system.noutputs != 1 or system.dt not in (0, None):
            raise MechanismError("system: give a continuous one with one input and one output")
        found = control.tf(system)
        rows = (found.num[0][0], found.den[0][0])
        numerator, denominator = (tuple(map(float, row)) for row in rows)
        return cls(numerator=numerator, denominator=denominator, **others)


CONTROLLERS: Mapping[str, type[Controller]] = MappingProxyType(
    {each.word: each for each in (Pid, Cascade, TransferController)}
)
"""The kinds of controllers by their words in a file."""


def idle_controllers(controllers: Mapping[str, Controller]) -> Iterator[str]:
    """Yield a sentence on each controller that never acts, or never follows its reference."""
    for name, each in controllers.items():
        if reason := _reason(each):
            yield f"{place_text(('controllers', name))} {reason}"


def _reason(controller: Controller) -> str:
    match controller:
        case Pid(kp=0, ki=0, kd=0):
            return "never acts: kp, ki and kd are 0 where they are not given"
        case Cascade(kv=0):
            return "never acts: kv is 0 where it is not given"
        case Cascade(kp=0, reference=str()):
            return "does not follow its reference, but brakes alone: kp is 0 where it is not given"
        case TransferController() if not any(controller.numerator):
            return "never acts: all of its numerator is 0"
        case _:
            return ""
