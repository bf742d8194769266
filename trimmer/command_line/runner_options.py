"""Options that say who does the work of many cells: processes of this computer, or a cluster."""

import logging
from argparse import ArgumentParser, Namespace

from trimmer.command_line.parser import OptionError
from trimmer.runners.runner import Runner


def add_runner_options(parser: ArgumentParser) -> None:
    """Add ``--jobs N`` and ``--scheduler ADDRESS``."""
    parser.add_argument("--jobs", type=int, metavar="N", help="processes (default: as many as cores)")
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="let the workers of a Dask cluster do the work, as in tcp://127.0.0.1:8786; "
        "needs pip install 'trimmer[cluster]'",
    )


def check_runner_options(arguments: Namespace) -> None:
    """Refuse options that contradict each other."""
    check_jobs(arguments.jobs)
    if arguments.scheduler is None:
        return
    if arguments.jobs is not None:
        raise OptionError("--jobs is of this computer, and --scheduler of a cluster: leave one of them out")
    if not arguments.scheduler.strip():
        raise OptionError("--scheduler: give the address of a Dask scheduler, as in tcp://127.0.0.1:8786")


def check_jobs(jobs: int | None) -> None:
    """Refuse a number of processes that cannot be, or that would only fill the memory."""
    from trimmer.runners.processes import cores, most_processes

    if jobs is not None and jobs < 1:
        raise OptionError(f"--jobs {jobs}: give a whole number from 1 on")
    if jobs is not None and jobs > most_processes():
        raise OptionError(
            f"--jobs {jobs}: this computer has {cores()} cores, and so many processes would only wait for "
            f"each other; give at most {most_processes()}"
        )


def check_resuming(arguments: Namespace) -> None:
    """Refuse ``--resume`` without the file of ``--output``, or beside ``--overwrite``."""
    if arguments.resume and arguments.output is None:
        raise OptionError("--resume goes on with the file of --output: name it")
    if arguments.resume and arguments.overwrite:
        raise OptionError("--resume and --overwrite contradict each other: leave one of them out")


def chosen_runner(arguments: Namespace, chunk: int | None = None) -> Runner | None:
    """Return who does the work, in chunks of a tenth of a second if not given; None if nothing was chosen."""
    from trimmer.runners.cluster import ClusterRunner
    from trimmer.runners.processes import ProcessRunner
    from trimmer.runners.runner import CHUNK, SerialRunner

    if arguments.scheduler is not None:
        _silence_dask()
        return ClusterRunner(arguments.scheduler, chunk or CHUNK)
    if arguments.jobs is None:
        return None
    return SerialRunner() if arguments.jobs == 1 else ProcessRunner(arguments.jobs, chunk or CHUNK)


def _silence_dask() -> None:
    """Leave it to one sentence to tell what goes wrong, where Dask would print how it got there."""
    try:
        import distributed
    except ImportError:
        return  # which the runner tells
    for name in logging.root.manager.loggerDict:
        if name.split(".")[0] == distributed.__name__:
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)
