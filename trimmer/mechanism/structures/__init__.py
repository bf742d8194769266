"""Linear parts given by matrices or modes: what they are, and what of them a mechanism can be attached to.

``structure`` holds one, ``reading`` takes it from tables and files, ``checks`` judges it by itself, and
``ends`` knows its coordinates and points by name, beside the bodies and other ends of a mechanism.
"""
