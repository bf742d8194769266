"""What is sampled: a mechanism or a loop, the targets, the distributions, as a file gives them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import cast

from trimmer.design.specification.design_file import (
    DesignFile,
    OpenRange,
    design_file_of_text,
    read_design_file,
)
from trimmer.design.specification.targets import Target
from trimmer.errors import MechanismError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.problems import Problem, as_message_of_file
from trimmer.motion.subject import Subject
from trimmer.uncertainty.distributions import Scatter, Uncertainty, Uniform
from trimmer.uncertainty.table import SECTION, uncertainty_of


@dataclass(frozen=True)
class SampleFile:
    """A mechanism or a loop with its targets and what scatters, as a file gives them.

    Attributes:
        subject: The mechanism, with the middle of each range that nobody knows better; or a loop.
        targets: What is wanted of it.
        uncertainty: What scatters. A number that the file leaves open scatters evenly over its range.
    """

    subject: Subject
    targets: tuple[Target, ...]
    uncertainty: Uncertainty

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism, if it is one that is sampled."""
        return cast("Mechanism", self.subject)


def read_sample_file(path: Path | str, changes: Sequence[tuple[str, float | str]] = ()) -> SampleFile:
    """Read a mechanism with ``[uncertainty]``, or standard input if the path is ``-``.

    Args:
        path: The file.
        changes: Places, and the numbers that stand there in place of those of the file.

    Raises:
        MechanismError: if it cannot be read, holds what cannot be used, or nothing in it scatters. Every
            problem is named, with file, line, key and value, and what to do.
    """
    return _sampled(read_design_file(path, changes))


def sample_file_of_text(text: str, name: str) -> SampleFile:
    """Read the text of such a file; see ``read_sample_file``."""
    return _sampled(design_file_of_text(text, name))


def _sampled(file: DesignFile) -> SampleFile:
    uncertainty = _uncertainty(file, tuple(map(_evenly, file.ranges)))
    if not uncertainty.scatters:
        raise MechanismError(
            f"{file.name}: nothing scatters: say what does below [{SECTION}], as in "
            '"plays.bridge.gap" = { normal = "5 um" }'
        )
    return SampleFile(file.mechanism, file.targets, uncertainty)


def with_uncertainty(file: DesignFile) -> DesignFile:
    """Return the file of a design with its ``[uncertainty]`` read, so that a ``Study`` looks at a series.

    Raises:
        MechanismError: if that cannot be used; every problem is named.
    """
    uncertainty = _uncertainty(file)
    return replace(file, uncertainty=uncertainty if uncertainty.scatters else None)


def _uncertainty(file: DesignFile, known: tuple[Scatter, ...] = ()) -> Uncertainty:
    problems: list[Problem] = []
    uncertainty = uncertainty_of(file.scatter, file.mechanism, problems, known)
    if problems:
        raise MechanismError(as_message_of_file(file.name, problems, {SECTION: file.scatter}, file.lines))
    return uncertainty


def _evenly(left_open: OpenRange) -> Scatter:
    distribution = Uniform(left_open.lowest, left_open.highest)
    return Scatter(left_open.place, left_open.unit, distribution, assumed=True)
