"""``trimmer judge FOLDER``: judge a text of one's own, and write the report on it."""

from argparse import ArgumentParser, Namespace
from functools import partial
from pathlib import Path

from report.command import add_build_options, formats_of, made
from report.pages.formats import Paper
from report.rendering.request import Request
from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import folder_to_read
from trimmer.errors import TrimmerError

DIRECTORY = Path("build") / "judge"


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument(
        "folder",
        type=folder_to_read,
        metavar="FOLDER",
        help="folder with judge.toml, inventory.csv, the text, and the Python that judges it, which is run",
    )
    add_build_options(parser, DIRECTORY)


def _run(arguments: Namespace) -> int:
    formats = formats_of(arguments)
    from report.building.folder import FolderError, read_folder

    folder = read_folder(arguments.folder)
    request = Request((), formats, Paper(arguments.paper), arguments.overwrite, folder.copy)
    from report.building.folder_content import folder_content
    from report.pages.pandoc import PandocError
    from report.pages.pdf import TypesettingError

    try:
        return made(arguments, request, partial(folder_content, folder))
    except TrimmerError:
        raise
    except (ValueError, PandocError, TypesettingError) as error:
        raise FolderError(
            f"{arguments.folder}: the pages cannot be made: {error}; mend the text, link or formula "
            "of the claim"
        ) from error


COMMAND = Command(
    "judge",
    "judge a text of your own, a thesis or a paper, claim by claim; HTML, PDF and JSON",
    _configure,
    _run,
    examples=uses("""
    trimmer judge examples/judged-paper
        which statements of a paper on dry friction hold, in build/judge
    trimmer judge examples/judged-paper --format html --directory build/paper
        the same as a page alone, in a folder of its own
    """),
)
