"""Pictures: each function draws a result into axes.

The library's ``plot`` (``dispatch``), the command line's ``--plot`` and the report use the same functions.
Fonts and sizes come from the caller's Matplotlib settings, which nothing here changes. These modules alone
import Matplotlib: import them where a picture is wanted.
"""
