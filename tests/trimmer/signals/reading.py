"""What the tests of reading share."""

from pathlib import Path

import pytest

from trimmer import read_signal
from trimmer.signals.text_file import SignalFileError


def message_for(path: Path, **options: object) -> str:
    """Read a file that cannot be read, and give the message without the name of the file."""
    with pytest.raises(SignalFileError) as raised:
        read_signal(path, **options)
    assert str(raised.value).startswith(str(path))
    return str(raised.value).removeprefix(str(path))
