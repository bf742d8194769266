"""A line for who waits: what takes long, and that the first call of all compiles."""

from collections.abc import Iterator
from contextlib import contextmanager
from threading import Timer

from trimmer.command_line.parser import tell
from trimmer.progress import is_silenced

SOON = 2.0  # Time after which the line is printed, s
LINE = (
    "at work ...; the first call of all compiles its kernels for some ten seconds, which are kept for later"
)


@contextmanager
def patience(seconds: float = SOON) -> Iterator[None]:
    """Print a line on standard error if what is done inside takes longer than some time, s.

    Nothing with ``--quiet``.
    """
    if is_silenced():
        yield
        return
    timer = Timer(seconds, tell, (LINE,))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
