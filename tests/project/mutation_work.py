"""What the processes of ``test_mutation_running`` do."""

import os


def answers() -> int:
    return 42


def raises() -> float:
    return 1 / 0


def loops() -> None:
    while True:
        pass


def dies() -> None:
    os._exit(3)
