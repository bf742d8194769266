"""Loci of special points over two numbers of a mechanism.

``follow_special`` is the entry, and ``locus`` its result. ``steps`` goes along a locus, ``search`` finds the
point again where one number is held, by ``relocation`` on a short piece of branch over the other.
"""
