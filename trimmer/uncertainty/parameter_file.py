"""The table ``[uncertainty]`` of a parameter file: how numbers of the thesis's trimmer scatter."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from trimmer.mechanism.problems import Problem, as_message_of_file
from trimmer.mechanism.toml_lines import lines_of_keys
from trimmer.parameters import SCATTER, ParameterError, parameter_table
from trimmer.toml_files import parsed, read_text
from trimmer.uncertainty.table import uncertainty_of

if TYPE_CHECKING:
    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.uncertainty.distributions import Uncertainty
    from trimmer.uncertainty.table import Numbers

GAP = "gap"  # The clearance of the play, which stands among the parameters of a file that scatter
_SHORT: Mapping[str, str] = {}


def uncertainty_of_file(path: Path, numbers: Numbers, short: Mapping[str, str] = _SHORT) -> Uncertainty:
    """Read what scatters from a parameter file, which is no stream, since it is read for its numbers too."""
    text = read_text(path, ParameterError, "name a parameter file")
    content = parsed(text, str(path), ParameterError, "write one 'key = number' per line")
    problems: list[Problem] = []
    uncertainty = uncertainty_of(content.get(SCATTER, {}), numbers, problems, short=short)
    if problems:
        raise ParameterError(as_message_of_file(str(path), problems, content, lines_of_keys(text)))
    if not uncertainty.scatters:
        raise ParameterError(
            f'{path}: nothing scatters: say what does below [{SCATTER}], as in gap = {{ normal = "5 um" }}'
        )
    return uncertainty


def read_uncertainty_of_loop(path: Path, loop: TrimmerLoop) -> Uncertainty:
    """Read what scatters in a loop from the file of its parameters.

    In ``[uncertainty]`` stand places of the loop, such as ``"frictions.q2-q4.force"``; ``k2`` is short
    for ``parameters.k2``, and ``gap`` for ``element.gap``.
    """
    short = {each.symbol: f"parameters.{each.symbol}" for each in parameter_table()}
    return uncertainty_of_file(path, loop, short | {GAP: f"element.{GAP}"})
