"""All that a report on a design shows."""

from collections.abc import Mapping
from dataclasses import dataclass

from trimmer.choices import Choice
from trimmer.deadline import NEVER, Deadline
from trimmer.design.analysis.found_motion import FoundMotion
from trimmer.design.analysis.linear import LinearState
from trimmer.design.analysis.plausible import Question
from trimmer.design.analysis.spectrum import OutputSpectrum
from trimmer.design.motions import Motions
from trimmer.design.parameter_studies.kept_map import DesignMap
from trimmer.design.parameter_studies.paths import NumberPath
from trimmer.design.parameter_studies.solved_grid import SolvedGrid
from trimmer.design.settings import DesignSettings
from trimmer.design.specification.design_file import DesignFile
from trimmer.design.trials.ranges import RangeStudy
from trimmer.design.trials.remedies import Remedies
from trimmer.design.trials.sensitivity import Sensitivities
from trimmer.design.trials.surroundings import Around
from trimmer.design.varied_places import VariedNumber
from trimmer.design.verdict import DesignVerdict


class Stage(Choice):
    """A stage of the work, whose words are shown while it goes on; what the verdict needs comes first."""

    MOTIONS = "motions from several starts"
    RANGES = "over what nobody knows"
    AROUND = "at neighbouring speeds, and as numbers scatter"
    SENSITIVITIES = "what each number changes"
    REMEDIES = "what would meet the targets"
    NEIGHBOURS = "motions of neighbours"
    MAP = "map"
    BRANCH = "branch"
    SLIDERS = "motions behind the sliders"


@dataclass(frozen=True)
class Design:
    """All that was computed of a design.

    Attributes:
        file: What the file says.
        settings: How closely it was looked at.
        linear: With contacts closed, then open.
        motions: The motions that were found.
        varied: The numbers that maps, branches and margins are over.
        spectra: Lines of each output of the first motion.
        ranges: Over what nobody knows; None where the file leaves nothing open.
        questions: What is asked about.
        verdict: On the targets.
        maps: Over gap and speed, gap and friction; as far as the mechanism has them.
        paths: The branch through the working point over each number; empty where the motion does not repeat.
        sensitivities: Of the first motion; None where it does not repeat.
        remedies: What would meet them; None where they are met or there are none.
        around: Whether the targets hold at neighbouring speeds, and as numbers scatter; None without targets.
        grid: Motions over a grid of up to three numbers, which sliders show; None where there is none.
        deadline: After which nothing more was begun.
        cut: What was ended early or left out for it: stages, with the places that each is over.
    """

    file: DesignFile
    settings: DesignSettings
    linear: tuple[LinearState, ...]
    motions: Motions
    varied: tuple[VariedNumber, ...]
    spectra: Mapping[str, OutputSpectrum]
    ranges: RangeStudy | None
    questions: tuple[Question, ...]
    verdict: DesignVerdict
    maps: tuple[DesignMap, ...] = ()
    paths: tuple[NumberPath, ...] = ()
    sensitivities: Sensitivities | None = None
    remedies: Remedies | None = None
    around: Around | None = None
    grid: SolvedGrid | None = None
    deadline: Deadline = NEVER
    cut: tuple[tuple[Stage, tuple[str, ...]], ...] = ()

    @property
    def motion(self) -> FoundMotion | None:
        """What the first start settles to; None if it could not be measured."""
        return self.motions.first
