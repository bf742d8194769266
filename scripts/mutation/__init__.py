"""Which changes of ``derivations`` and ``trimmer`` are noticed: by claims, by tests, by neither.

    python -m scripts.mutation map                    which test file runs which line, and how long that takes
    python -m scripts.mutation run --seed 1           changes the sources at random, one place at a time
    python -m scripts.mutation summary --seed 1       counts what was noticed; --write keeps that for the report

``make mutate`` does all three. Nothing is changed in the working tree: mutants are made in a copy of it in
``build/mutation``. Each outcome is a line of a file there, so that an interrupted run goes on where it was.

Why not a known tool (both were tried on this project):

* mutmut 3.8 puts every variant of a function behind a switch in Python. Numba cannot compile such a switch, so it
  leaves every compiled function alone, and with them properties and all that a module computes when it is imported.
  It makes all mutants in the order of the files (6143 in two folders), and cannot draw some by a seed.
* cosmic-ray 8.7 knows neither removed statements nor swapped arguments or functions. Most of its operators put shifts
  and bitwise operators between floats, which fails at once and says nothing about the tests. Every mutant gets the
  same command, changed is the working tree, and a limit counts seconds of the clock instead of the processor's.
* Both know tests only. Here claims are judged too, and compared with those of the unaltered project.
"""
