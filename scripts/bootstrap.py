"""Run a command in .venv after bringing .venv up to date with a lock file.

    python3 scripts/bootstrap.py requirements.lock -- trimmer report

This file must parse on every Python, Python 2 included, so that an old one is told apart in one sentence;
the work is done in environment.py, which only needs to parse on Python 3.11.
"""

import sys

OLDEST = (3, 11)


def main():
    """Stop with one sentence on an old Python, hand over to environment.py otherwise."""
    if sys.version_info < OLDEST:
        sys.stderr.write(
            "error: this project needs Python %d.%d or newer, but %s is Python %d.%d; "
            "run make PYTHON=/path/to/newer/python\n"
            % (OLDEST + (sys.executable,) + tuple(sys.version_info[:2]))
        )
        return 1
    from environment import main as run

    return run(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
