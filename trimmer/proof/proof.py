"""A proof: what is proven of given data, in a file that is verified again without what computed it."""

import json
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from hashlib import sha256
from pathlib import Path
from typing import Any

from trimmer.errors import MissingPackageError, TrimmerError
from trimmer.files import read_content, write_atomically
from trimmer.json_data import DataError, parsed_json, typed
from trimmer.messages import shown_value
from trimmer.proof.outcome import LIMIT, OutOfTimeError, UnprovenError, Verdict, time_limit
from trimmer.proof.statement import LimitCycles, StatedMotion, StatedSpecialPoint

_FORMAT = 2


class ProofFileError(TrimmerError, ValueError):
    """A file is no proof that can be verified; the message says which, and what is wrong."""


@dataclass(frozen=True)
class Proof:
    """What ball arithmetic says of a statement.

    Attributes:
        statement: Its kind: ``limit cycles``, ``orbit``, ``motion`` or ``special point``.
        verdict: ``proven``, ``undecided`` or ``refuted``; it equals the word.
        theorem: What is proven, a sentence; empty if nothing is.
        reason: Why nothing is proven, or what is wrong, without a full stop; empty if it is proven.
        data: What the statement is about, and all that is needed to verify it again.
        in_time: Whether the check ended before its limit of time; if not, the verdict is ``undecided``.
    """

    statement: str
    verdict: Verdict
    theorem: str
    reason: str
    data: dict[str, Any] = field(repr=False, compare=False)
    in_time: bool = field(default=True, repr=False)

    def __bool__(self) -> bool:
        """Return whether it is proven."""
        return self.verdict is Verdict.PROVEN

    def write(self, path: Path | str) -> None:
        """Write it as JSON, for ``trimmer check``.

        Raises:
            FileWriteError: see ``trimmer.files.write_atomically``.
        """
        head = {"trimmer proof": _FORMAT, "statement": self.statement, "verdict": str(self.verdict)}
        told = {**head, "theorem": self.theorem, "reason": self.reason, "sha256 of data": _digest(self.data)}
        lines = [f"{json.dumps(key)}: {json.dumps(value)}" for key, value in told.items()]
        lines += [f'"data": {json.dumps(self.data, allow_nan=False)}']
        write_atomically(path, "{" + ",\n ".join(lines) + "}\n")


def proof_of(statement: str, data: dict[str, Any], limit: float) -> Proof:
    """Check a statement about data, within a time, s.

    Raises:
        MissingPackageError: if python-flint is not installed.
        ValueError: if the data are not those of such a statement.
    """
    check = _checks()[statement]
    try:
        with time_limit(limit):
            theorem = check(typed(_STATEMENTS[statement], data))
    except UnprovenError as error:
        in_time = not isinstance(error, OutOfTimeError)
        return Proof(statement, error.verdict, "", str(error), data, in_time)
    return Proof(statement, Verdict.PROVEN, theorem, "", data)


def check_proof(path: Path | str, limit: float = LIMIT) -> Proof:
    """Verify the theorem of a file again, from its data alone.

    Args:
        path: The file.
        limit: Time after which the check gives up at its next step, s.

    Returns:
        What comes out: proven only if the file says so, its data are those with which it was written, and its
        theorem is, word for word, what is proven.

    Raises:
        ProofFileError: if the file cannot be read, or is no proof.
        MissingPackageError: if python-flint is not installed.
    """
    told = _read(Path(path))
    statement, data = told["statement"], told["data"]
    try:
        proof = proof_of(statement, data, limit)
    except (ArithmeticError, ValueError) as error:
        raise ProofFileError(
            f"{path}: its data are not those of a proof ({error}); write the proof again"
        ) from error
    if not proof:
        return proof
    if told["verdict"] != Verdict.PROVEN or told["reason"] or told["theorem"] != proof.theorem:
        reason = f"the file says another theorem than its data, which give: {proof.theorem}"
        return replace(proof, verdict=Verdict.REFUTED, theorem="", reason=reason)
    if told["sha256 of data"] != _digest(data):
        reason = f"its data are others than those with which it was written; they give: {proof.theorem}"
        return replace(proof, verdict=Verdict.REFUTED, theorem="", reason=reason)
    return proof


def _read(path: Path) -> dict[str, Any]:
    try:
        told = parsed_json(read_content(path))
    except OSError as error:
        raise ProofFileError(f"{path}: it cannot be read ({error.strerror})") from error
    except DataError as error:
        raise ProofFileError(f"{path}: {error}") from error
    if not isinstance(told, dict) or told.get("trimmer proof") != _FORMAT:
        raise ProofFileError(f'{path}: it is no proof, which begins with "trimmer proof": {_FORMAT}')
    wanted = {
        **dict.fromkeys(("statement", "verdict", "theorem", "reason", "sha256 of data"), str),
        "data": dict,
    }
    for name, kind in wanted.items():
        if not isinstance(told.get(name), kind):
            raise ProofFileError(f"{path}: {name} is missing, or of another type; write the proof again")
    if unknown := set(told) - {"trimmer proof", *wanted}:
        raise ProofFileError(f"{path}: a proof has no {shown_value(min(unknown))}; remove it")
    if told["statement"] not in _STATEMENTS:
        raise ProofFileError(
            f"{path}: statement {shown_value(told['statement'])} is none that can be checked: "
            f"{', '.join(_STATEMENTS)}"
        )
    return told


def _digest(data: dict[str, Any]) -> str:
    return sha256(json.dumps(data, sort_keys=True, allow_nan=False).encode()).hexdigest()


_STATEMENTS = {
    "limit cycles": LimitCycles,
    "orbit": StatedMotion,
    "motion": StatedMotion,
    "special point": StatedSpecialPoint,
}


def _checks() -> dict[str, Callable[[Any], str]]:
    try:
        from trimmer.proof.cycles import check_limit_cycles
        from trimmer.proof.motion_check import check_motion, check_orbit
        from trimmer.proof.special_check import check_special_point
    except ImportError as error:
        raise MissingPackageError(
            "proofs need python-flint, which is not installed: install it with 'pip install trimmer[proof]'"
        ) from error
    return {
        "limit cycles": check_limit_cycles,
        "orbit": check_orbit,
        "motion": check_motion,
        "special point": check_special_point,
    }
