"""``trimmer derive``: derive the thesis's trimmer or any mechanism; write numeric module and LaTeX."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import (
    add_input,
    add_overwrite_option,
    check_targets,
    file_to_write,
    show,
)
from trimmer.command_line.output_options import add_file_option
from trimmer.command_line.parser import note
from trimmer.files import LATEX, MODULE, STANDARD_INPUT, write_atomically

DIRECTORY = Path("build") / "derivation"
MODULE_OF_THESIS = DIRECTORY / "linear_trimmer.py"
LATEX_OF_THESIS = DIRECTORY / "derivation.tex"
STANDARD_OUTPUT = Path("/dev/stdout")


def _configure(parser: ArgumentParser) -> None:
    add_input(
        parser,
        "file",
        "mechanism (TOML), - for standard input (default: the thesis's linear trimmer and its elements)",
        optional=True,
    )
    parser.add_argument(
        "--module",
        type=_module_to_write,
        metavar="FILE",
        help="where to write the numeric Python module, - for standard output "
        f"(default: {MODULE_OF_THESIS}, of a mechanism {DIRECTORY / 'NAME.py'})",
    )
    add_file_option(
        parser,
        "--latex",
        "where to write the derivations as LaTeX "
        f"(default: {LATEX_OF_THESIS}, of a mechanism {DIRECTORY / 'NAME.tex'})",
    )
    add_overwrite_option(parser)


def _module_to_write(text: str) -> Path:
    return STANDARD_OUTPUT if text == str(STANDARD_INPUT) else file_to_write(text)


def _run(arguments: Namespace) -> int:
    if arguments.file is None:
        return _run_for_thesis(_with_defaults(arguments, MODULE_OF_THESIS, LATEX_OF_THESIS))
    name = "mechanism" if arguments.file == STANDARD_INPUT else arguments.file.stem
    return _run_for_mechanism(_with_defaults(arguments, DIRECTORY / f"{name}.py", DIRECTORY / f"{name}.tex"))


def _run_for_thesis(arguments: Namespace) -> int:
    from trimmer.code_generation import derive_sources
    from trimmer.generated import linear_trimmer

    installed = Path(linear_trimmer.__file__).read_text(encoding="utf-8")
    note("deriving the linear trimmer and the describing functions ...")
    sources = derive_sources()
    state = "the same as the one in use" if sources.module == installed else "different from the one in use"
    _write(arguments, sources.module, sources.latex, f"numeric module, {state}", "derivations")
    return 0


def _run_for_mechanism(arguments: Namespace) -> int:
    from trimmer.mechanism.mechanism import Mechanism

    mechanism = Mechanism.from_toml(arguments.file)
    from trimmer.code_generation import derive_mechanism_sources

    note(f"deriving {mechanism.title or 'the mechanism'} ...")
    sources = derive_mechanism_sources(mechanism)
    told = "derivation, and the laws of contact and friction"
    _write(arguments, sources.module, sources.latex, "numeric module", told)
    return 0


def _with_defaults(arguments: Namespace, module: Path, latex: Path) -> Namespace:
    """Return the options with files to write for those that are not given, checked."""
    chosen = {"module": arguments.module or module, "latex": arguments.latex or latex}
    complete = Namespace(**{**vars(arguments), **chosen})
    check_targets(
        complete, {"module": {"": MODULE}, "latex": {"": LATEX}}, {"file": "the file of the mechanism"}
    )
    return complete


def _write(arguments: Namespace, module: str, latex: str, about_module: str, about_latex: str) -> None:
    write_atomically(arguments.module, module, overwrite=arguments.overwrite)
    write_atomically(arguments.latex, latex, overwrite=arguments.overwrite)
    text = f"{arguments.module}: {about_module}\n{arguments.latex}: {about_latex}"
    show(text, arguments.module, arguments.latex)


COMMAND = Command(
    "derive",
    "derive equations of motion, of the thesis or of a mechanism; write numeric module and LaTeX",
    _configure,
    _run,
    examples=uses("""
    trimmer derive examples/two-mass-stop.toml
        equations of motion of a mechanism, in build/derivation as LaTeX and as Python
    trimmer derive examples/two-mass-stop.toml --module - --latex two-mass.tex --quiet
        the same, the Python on standard output
    trimmer derive
        the thesis's trimmer and its describing functions, derived again
    """),
)
