"""``trimmer completion``: a script with which a shell completes the words of ``trimmer``."""

from argparse import Action, ArgumentParser, Namespace, _SubParsersAction
from itertools import permutations
from pathlib import Path

from trimmer.command_line.command import Command, Example
from trimmer.command_line.file_options import PICTURES, file_to_read, file_to_write, folder_to_write

SHELLS = ("bash", "zsh", "tcsh")
ENDINGS = {
    "--against": (".toml",),
    "--csv": (".csv",),
    "--latex": (".tex",),
    "--module": (".py",),
    "--parameters": (".toml",),
    "--plot": tuple(PICTURES),
    "--wav": (".wav",),
    "MEASURED": (".csv", ".txt", ".wav"),
}
"""Ends of the names of files that are offered for an option, or a word of this name."""
ENDINGS_OF_COMMAND = {
    **dict.fromkeys(("simulate", "respond", "follow", "map", "derive", "fit"), (".toml",)),
    **dict.fromkeys(("spectrum", "overlay"), (".csv", ".txt", ".wav")),
}
"""The same for the file that a command reads."""
BODIES = ("q1", "q2", "q3", "q4")
DISPLACEMENTS = (*BODIES, *("-".join(pair) for pair in permutations(BODIES, 2)))


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument("shell", choices=SHELLS, metavar="SHELL", help="bash, zsh or tcsh")


def _run(arguments: Namespace) -> int:
    import shtab

    parser: ArgumentParser = arguments.whole
    _prepare(parser, "")
    print(shtab.complete(parser, arguments.shell))
    return 0


def _prepare(parser: ArgumentParser, command: str) -> None:
    """Tell shtab what to offer for each word of a command, and of the commands below it."""
    for action in parser._actions:
        if isinstance(action, _SubParsersAction):
            for name, below in action.choices.items():
                _prepare(below, name)
        elif action.metavar == "DISPLACEMENT":
            action.choices = DISPLACEMENTS
        elif action.type in (Path, folder_to_write) or _takes_file(action):
            action.complete = _offered(action, command)  # type: ignore[attr-defined]


def _takes_file(action: Action) -> bool:
    return action.metavar == "FILE" or action.type in (file_to_read, file_to_write)


def _offered(action: Action, command: str) -> object:
    """Return what shtab offers: folders, files with certain ends, or any file."""
    import shtab

    if action.metavar == "DIR":
        return shtab.DIRECTORY
    option = action.option_strings[0] if action.option_strings else None
    endings = ENDINGS.get(option or str(action.metavar))
    if option is None and endings is None:
        endings = ENDINGS_OF_COMMAND.get(command)
    return shtab.glob(*(f"*{ending}" for ending in endings)) if endings else shtab.FILE


COMMAND = Command(
    "completion",
    "script with which a shell completes commands, options, choices and files",
    _configure,
    _run,
    examples=(
        Example(
            "trimmer completion bash",
            "for bash: put the line `source <(trimmer completion bash)` into ~/.bashrc",
        ),
        Example("trimmer completion zsh", "for zsh: write it into a file _trimmer in a folder of $fpath"),
        Example("trimmer completion tcsh", "for tcsh: write it into a file, and source that in ~/.tcshrc"),
    ),
)
