"""Which changes of ``derivations``, ``trimmer`` and ``report`` are noticed: by claims, by tests, by neither.

    python -m scripts.mutation map                which test file runs which line, and how long that takes
    python -m scripts.mutation run --seed 1       changes the sources at random, one place at a time
    python -m scripts.mutation summary --seed 1   counts what was noticed; with --write for the report

``make mutate`` does all three. Nothing is changed in the working tree, but in a copy of it in
``build/mutation``: in functions where a process has them loaded with all tests, else in the sources, as what
is compiled or stands in no function. Each outcome is a line of a file there, so that an interrupted run goes
on where it was.

Why not a known tool (both were tried on this project):

* mutmut 3.8 puts all variants of a function behind a switch in Python, which Numba cannot compile. So it
  leaves compiled functions alone, and also properties and what a module computes on import. It makes all
  mutants in the order of the files (6143 in two folders), and cannot draw some by a seed.
* cosmic-ray 8.7 knows neither removed statements nor swapped arguments or functions. Most operators are
  shifts and bitwise operators between floats, which fail at once and say nothing about the tests. It gives
  every mutant the same command, changes the working tree, and limits the time on the clock, not the
  processor's.
* Both know tests only. Here claims are judged too, and compared with those of the unaltered project.
"""
