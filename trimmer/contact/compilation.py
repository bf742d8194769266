"""Entry points of the compiled code of this package, whose machine code is kept for the next process."""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path

from trimmer.motion.compilation import sources as sources_of_motion

SOURCES = (
    "integration",
    "nodes",
    "relaxing_root",
    "segment",
    "series",
    "statuses",
    "step_event",
    "tables",
    "tabulated_change",
    "work",
)
"""Modules that compiled code is made of, apart from those of ``trimmer.motion``."""


@cache
def sources() -> bytes:
    """Return a digest of all modules that compiled code is made of, 32 bytes; see ``motion.compilation``."""
    digest = hashlib.sha256(sources_of_motion())
    for module in SOURCES:
        digest.update(Path(__file__).with_name(f"{module}.py").read_bytes())
    return digest.digest()
