"""A mechanism of numbers as one of symbols, which ``derivations`` takes: only this and the code touch SymPy.

``mechanism`` is the entry. ``translation`` turns parts into parts, ``structures`` those that matrices or
modes give; ``printed_symbols`` and ``structure_symbols`` choose the symbols, without SymPy.
"""
