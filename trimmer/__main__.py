"""``python -m trimmer`` is the command ``trimmer``.

Python puts the current folder before all others then, and the files there are the user's: a ``report.py`` or
``numpy.py`` would be run in place of the module of that name. So this folder is taken out again, unless the
package itself comes from there.
"""

import os
import sys


def _find_own_modules() -> str:
    """Take the current folder out of where modules are looked for, if Python has put it there.

    Returns:
        What is wrong if a file of it was taken for a module already; empty if none was.
    """
    own = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    if sys.flags.safe_path or not sys.path or sys.path[0] == own:
        return ""
    here = sys.path.pop(0)  # of `python -m` this is the current folder
    for name, module in sorted(sys.modules.items()):
        file = getattr(module, "__file__", None) or ""
        if os.path.dirname(file.removesuffix(f"{os.sep}__init__.py")) == here:
            return f"trimmer: {file} was taken for the module {name}: give it another name"
    return ""


if __name__ == "__main__":
    wrong = _find_own_modules()
    if wrong:
        print(wrong, file=sys.stderr)
        sys.exit(2)
    from trimmer.command_line.main import main

    sys.exit(main())
