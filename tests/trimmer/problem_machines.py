"""Files of the machines of the benchmark problems, whose digits ``tests/benchmarks`` asks in two ways."""

from benchmarks.problems.read import FOLDER, read


def machine_text(name: str) -> str:
    """Return the file of the machine of a problem."""
    return read(FOLDER / f"{name}.toml").machine
