"""The ``trimmer`` command put together: its own subcommands, then those of installed packages."""

import codecs
import errno
import io
import os
import sys
import warnings
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path

import trimmer
from trimmer.command_line import check, completion, derive, linear, parameters, simulate
from trimmer.command_line.command import Command
from trimmer.command_line.help_text import EXIT_CODES, HelpText, epilog
from trimmer.command_line.located import located
from trimmer.command_line.loops import identify, limit_cycles, orbits
from trimmer.command_line.mechanisms import follow, init, motion_maps, respond, sample, step, sweep
from trimmer.command_line.output_options import add_quiet_option
from trimmer.command_line.parser import INTERRUPTED, WRONG_USE, Parser, drop, tell
from trimmer.command_line.signals import fit, overlay, spectrum
from trimmer.errors import TrimmerError
from trimmer.messages import listed, shown_value
from trimmer.progress import silenced
from trimmer.source_date import check_source_date

ENTRY_POINT_GROUP = "trimmer.commands"
"""Entry points of this group are ``Command`` objects; that is how another package adds a subcommand."""

_OWN = (
    *(linear.COMMAND, limit_cycles.COMMAND, identify.COMMAND),
    *(orbits.COMMAND, simulate.COMMAND, spectrum.COMMAND, overlay.COMMAND),
    *(init.COMMAND, respond.COMMAND, step.COMMAND, follow.COMMAND, sweep.COMMAND),
    *(motion_maps.COMMAND, sample.COMMAND, fit.COMMAND),
    *(check.COMMAND, parameters.COMMAND, derive.COMMAND, completion.COMMAND),
)
"""Commands of this package, which are found without a look at what else is installed."""
_SEVERAL = 5  # Words without use that are shown
_NUMERIC = ("numpy", "scipy", "control", "numba", "matplotlib")
_STRANGE = (
    "some numbers on the way became too large, too small or undefined, which may show in the result; use "
    "numbers of usual sizes"
)
_IN_ASCII = {"±": "+-", "µ": "u", "μ": "u", "ω": "omega", "·": "*", "…": "..."}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line, by default with the words of the process, and return its exit code.

    Returns:
        0, or 2 for what the user can put right, or 130 if interrupted, or what the subcommand returns. A
        reader that stops early, as in ``trimmer linear | head``, is no error.

    Raises:
        SystemExit: with the code, after help and for options that cannot be read.
    """
    _prepare_streams()
    if sys.stdout is None:
        tell("standard output is closed; send it to a file, or to /dev/null")
        return WRONG_USE
    parsed = Namespace()
    try:
        try:
            parsed = _parsed(arguments)
            check_source_date()
            _hush_drawing()
            with silenced() if parsed.quiet else _warnings_told():
                code: int = parsed.run(parsed)
        finally:
            sys.stdout.flush()
        return code
    except TrimmerError as error:
        tell(located(error, parsed))
        return WRONG_USE
    except BrokenPipeError:
        # The reader has seen enough, as in `trimmer linear | head`.
        drop(sys.stdout)
        return 0
    except OSError as error:
        tell(_told(error))
        drop(sys.stdout)
        return WRONG_USE
    except MemoryError as error:
        tell(f"there is not enough memory for that ({str(error) or 'no more could be had'}); ask for less")
        return WRONG_USE
    except KeyboardInterrupt:
        tell("interrupted before the result was complete")
        return INTERRUPTED


def _told(error: OSError) -> str:
    """Return what to say of an error of the system.

    Those of reading and writing files come as a TrimmerError. So this one is of printing, unless a library
    finds no folder to keep its own files in, which it says in its own words.
    """
    if error.errno is None:
        return str(error)
    if error.errno == errno.ENOENT and error.filename is None:
        return f"{error.strerror}; set TMPDIR to a folder that can be written to"
    return f"{error.filename or 'standard output'}: {error.strerror}; send the output elsewhere"


@contextmanager
def _warnings_told() -> Iterator[None]:
    """Tell warnings in a sentence, without the line of code that they come from.

    Those of libraries on numbers are in the words of whoever writes programs with them, and come in dozens:
    one sentence stands for them.
    """
    strange: list[Warning | str] = []

    def told(message: Warning | str, category: type[Warning], *_: object) -> None:
        if not _of_a_library(category):
            tell(f"warning: {message}")
        elif not strange:
            strange.append(message)
            tell(f"warning: {_STRANGE}")

    with warnings.catch_warnings():
        warnings.showwarning = told  # type: ignore[assignment]
        yield


def _of_a_library(category: type[Warning]) -> bool:
    """Say whether warnings of a kind come from NumPy, SciPy or their like, and not from this package."""
    return issubclass(category, RuntimeWarning) or category.__module__.partition(".")[0] in _NUMERIC


def _hush_drawing() -> None:
    """Keep Matplotlib from telling at length where it keeps its fonts if there is no home to keep them in."""
    import logging

    logging.getLogger("matplotlib").setLevel(logging.ERROR)


def _prepare_streams() -> None:
    """Make printing possible in every locale, and without standard error."""
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115 (for the rest of the process)
    codecs.register_error("trimmer", _in_ascii)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="trimmer")


def _in_ascii(error: UnicodeError) -> tuple[str | bytes, int]:
    """Write what an encoding has no sign for, such as that of the C locale, in signs that it has."""
    if isinstance(error, UnicodeEncodeError):
        plain = _IN_ASCII.get(error.object[error.start])
        if plain is not None:
            return plain, error.start + 1
    return codecs.backslashreplace_errors(error)


def installed_commands() -> list[Command]:
    """Return the commands of this package and those of others."""
    others = (_loaded(entry) for entry in entry_points(group=ENTRY_POINT_GROUP))
    return [*_OWN, *(command for command in others if command is not None)]


def _loaded(entry: EntryPoint) -> Command | None:
    """Load a command of another package; None for one that is broken, which must not stop the others."""
    try:
        command = entry.load()
    except Exception as error:
        tell(f"command {entry.name!r} ({entry.value}) does not load: {error}{_hiding(entry)}")
        return None
    if isinstance(command, Command):
        return command
    tell(f"command {entry.name!r} ({entry.value}) is not a Command")
    return None


def _hiding(entry: EntryPoint) -> str:
    """Name the file that was found under the name of an entry's package, if it is no package."""
    found = sys.modules.get(entry.value.partition(".")[0])
    place = getattr(found, "__file__", None)
    if found is None or (hasattr(found, "__path__") and (place is None or _is_own(place, entry))):
        return ""
    return f"; {place or 'another module'} hides the package: give it another name"


def _is_own(place: str, entry: EntryPoint) -> bool:
    """Say whether the first package of an entry's module is the one in which the module lies."""
    parts = entry.module.split(".")[1:]
    below = Path(place).parent.joinpath(*parts)
    return below.is_dir() or below.with_suffix(".py").is_file()


def _parsed(arguments: Sequence[str] | None) -> Namespace:
    words = sys.argv[1:] if arguments is None else list(arguments)
    parsed, unknown = _parser(_needed(words)).parse_known_args(words)
    if unknown:
        have, them = ("has", "it") if len(unknown) == 1 else ("have", "them")
        told = [*map(shown_value, unknown[:_SEVERAL])]
        if len(unknown) > _SEVERAL:
            told.append(f"{len(unknown) - _SEVERAL} words more")
        parsed.parser.error(f"{listed(told)} {have} no use here; leave {them} out")
    return parsed


def _needed(words: Sequence[str]) -> Sequence[Command]:
    """Return the command that words begin with, since all others take their time; or else all.

    ``completion`` tells of all commands.
    """
    own = [command for command in _OWN if words[:1] == [command.name]]
    if own and own != [completion.COMMAND]:
        return own
    commands = installed_commands()
    return [command for command in commands if words[:1] == [command.name] and not own] or commands


def _parser(commands: Sequence[Command]) -> ArgumentParser:
    parser = Parser(
        prog="trimmer",
        description="Exact motion of machines and control loops with play and friction.",
        epilog=EXIT_CODES,
    )
    parser.add_argument("--version", action="version", version=f"trimmer {trimmer.__version__}")
    subparsers = parser.add_subparsers(metavar="COMMAND", title="commands", required=True)
    for command in commands:
        subparser = subparsers.add_parser(
            command.name,
            help=command.help,
            description=command.help,
            epilog=epilog(command),
            formatter_class=HelpText,
        )
        command.configure(subparser)
        add_quiet_option(subparser)
        subparser.set_defaults(run=command.run, parser=subparser, whole=parser)
    return parser
