"""``trimmer check``: verify a proof again, without what computed it."""

from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import add_input
from trimmer.command_line.number_options import add_positive
from trimmer.command_line.parser import ENDED_EARLY, tell
from trimmer.errors import TrimmerError
from trimmer.proof.outcome import LIMIT


def _configure(parser: ArgumentParser) -> None:
    add_input(parser, "file", "proof, a JSON file that Proof.write has written")
    add_positive(
        parser, "--limit", "s", f"give up after that time, such as 30s, undecided (default: {LIMIT:g})"
    )


def _run(arguments: Namespace) -> int:
    from trimmer.proof.proof import check_proof

    proof = check_proof(arguments.file, arguments.limit or LIMIT)
    if not proof.in_time:
        tell(f"{arguments.file}: not verified, and not refuted: {proof.reason} with --limit")
        return ENDED_EARLY
    if not proof:
        raise TrimmerError(f"{arguments.file}: not proven ({proof.verdict}): {proof.reason}")
    print(f"Proven again. {proof.theorem}")
    return 0


COMMAND = Command(
    "check",
    "verify a proof by ball arithmetic again, from the data in its file alone",
    _configure,
    _run,
    examples=uses("""
    trimmer check examples/proofs/thesis-limit-cycles.json
        whether the thesis's loop has these two limit cycles and no other
    trimmer check examples/proofs/delayed-relay.json
        the same of a relay behind a delay, whose limit cycle is easily missed
    """),
)
