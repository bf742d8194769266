"""Where the files beside the code are: in a checkout at the top, in an installed package inside of it."""

from pathlib import Path

PACKAGE = Path(__file__).parent


def templates() -> Path:
    """Return the folder of the templates, filters, styles and scripts of the pages."""
    installed = PACKAGE / "templates"
    return installed if installed.is_dir() else PACKAGE.parent / "templates"
