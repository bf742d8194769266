"""Runs the tests that rest on digits as other processors would, and under other versions of Python.

    make test-kernels                          what continuous integration runs
    make test-kernels ARGS="--list"            what would be run here; what is left out, with the reason
    make test-kernels ARGS="--only Haswell"    one of them
    make test-kernels ARGS="--whole"           all quick tests: shows that the marker "digits" misses none

OpenBLAS, NumPy, Numba and the C library choose their code by the processor, and each choice rounds
differently. A run asks all four for what a processor of the given generation has. It also judges all claims;
their texts, verdicts and digits have to be the same in every run.
"""
