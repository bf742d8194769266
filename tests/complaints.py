"""What a command says on standard error, whatever the time it takes."""

from trimmer.command_line.patience import LINE


def complaints(error_output: str) -> str:
    """Return it without the line for who waits: whether that comes depends on the machine."""
    return error_output.replace(f"trimmer: {LINE}\n", "")
