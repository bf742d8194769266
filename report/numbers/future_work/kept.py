"""What an answer rests on and is dear to compute: kept with the code, with the hash of its inputs."""

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final, final

from report.numbers.twin.kept_files import FOLDER, digest_of, read_kept, rounded, write_kept
from trimmer import TrimmerParameters

PREFIX: Final = "future-"
DIGITS: Final = 10


@final
@dataclass(frozen=True)
class KeptAnswer:
    """The computed data of one answer."""

    name: str  # Of its file
    inputs: Any  # Everything that it is computed from beside the thesis's parameters, as JSON has it
    compute: Callable[[], Mapping[str, Any]]  # Computes it: tables of rows by name

    @property
    def path(self) -> Path:
        """Where it is kept."""
        return FOLDER / f"{PREFIX}{self.name}.json"

    def read(self) -> Mapping[str, Any]:
        """Return what is kept.

        Raises:
            KeptDataError: if it is not there, was made from something else, or has been changed since.
        """
        found: Mapping[str, Any] = read_kept(self.path, self._made_from())
        return found

    def write(self) -> None:
        """Compute it and keep it.

        Raises:
            FileWriteError: if it cannot be written.
        """
        write_kept(self.path, self._made_from(), shortened(self.compute()))

    def _made_from(self) -> str:
        return digest_of([self.inputs, asdict(TrimmerParameters.thesis())])


def shortened(value: Any) -> Any:
    """Return data with its numbers rounded to what is kept."""
    if isinstance(value, Mapping):
        return {name: shortened(each) for name, each in value.items()}
    if isinstance(value, list | tuple):
        return [shortened(each) for each in value]
    return rounded(value, DIGITS) if isinstance(value, float) else value
