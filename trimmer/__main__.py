"""``python -m trimmer`` is the command ``trimmer``."""

from __future__ import annotations

import sys

from trimmer.command_line.main import main

if __name__ == "__main__":
    sys.exit(main())
