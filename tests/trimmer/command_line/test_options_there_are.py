"""Which options each command has, with other names, defaults and choices: what scripts of users rely on."""

from __future__ import annotations

from argparse import Action
from pathlib import Path

import pytest

from trimmer.command_line.main import installed_commands
from trimmer.command_line.parser import Parser

LOOP = "--parameters --output=q2-q4 --channels=both:2"
ELEMENT = "--element:8 --gap --time-constant --force --threshold --slope --hysteresis --dead-zone"
SHOWN = "--json=False --plot --overwrite=False"
RECORD = (
    "--rate,--sample-rate --time --delimiter:3 --decimal:2 --missing=refuse:3 --channel --ignore-time=False "
    "--resample=False --gaps=refuse:2 --from>begin --until --scale --unit --clipped=mark:2"
)
SIGNAL = f"file --column {RECORD} --as>quantity:3 --lowest --highest --sensor-corner"
MECHANISM = "file --set=[]"
RUNNER = "--jobs --scheduler"
COMMANDS = {
    "linear": f"{LOOP} {SHOWN}",
    "limit-cycles": f"{ELEMENT} {LOOP} --omega-range*2 {SHOWN}",
    "identify": f"--gap --frequency --uncertainty=0.0 {LOOP} {SHOWN}",
    "orbits": f"{ELEMENT} {LOOP} --simulate=False {SHOWN}",
    "simulate": f"file*? --set=[] --state=[] {ELEMENT} {LOOP} --friction=[] --drive,--drive-frequency "
    f"--amplitude --impulse --duration=0.5 --sample-rate,--rate=20000.0 --csv --wav {SHOWN}",
    "spectrum": f"{SIGNAL} --drive,--drive-frequency --gap --closed-loop=False --window=hann:4 --limit=20 "
    f"--average {LOOP} --wav --csv --bits=16:2 {SHOWN}",
    "overlay": f"{SIGNAL} --against --set=[] --output --drive {SHOWN}",
    "init": "file*?=trimmer.toml --example=thesis-play:14",
    "respond": f"{MECHANISM} --state=[] --starts=1 --seed=0 --periods,--wait=1000 {SHOWN}",
    "follow": f"{MECHANISM} --vary --from>start --to>stop --periods --points=2000 --wait=2000 --switches=1:5 "
    f"--harmonics {SHOWN}",
    "map": f"{MECHANISM} --vary=[] --periods,--wait=300 --starts=1 --seed=0 --coexisting=False --special "
    f"--output --resume=False {RUNNER} {SHOWN}",
    "sample": "file --gap --channels:2 --count=512 --plan=latin-hypercube:2 --seed=0 --periods=300 "
    f"--indices=False --balance --output --resume=False {RUNNER} {SHOWN}",
    "fit": f"{MECHANISM} measured --free=[] --column>columns=[] {RECORD} --drive --starts=5 --seed=0 "
    f"--output {SHOWN}",
    "parameters": "--output",
    "derive": "file*? --module --latex --overwrite=False",
    "completion": "shell:3",
}
"""Names, ``>`` where it is kept, ``*`` how many values, ``=`` default, ``:`` number of choices."""


def written(action: Action) -> str:
    """Write an option as in the table."""
    names = ",".join(action.option_strings) or action.dest
    usual = action.option_strings[0][2:].replace("-", "_") if action.option_strings else action.dest
    kept = "" if action.dest == usual else f">{action.dest}"
    count = f"*{action.nargs}" if action.nargs else ""
    default = "" if action.default is None else f"={action.default}"
    return f"{names}{kept}{count}{default}{f':{len(list(action.choices))}' if action.choices else ''}"


@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_has_its_options(name: str) -> None:
    (command,) = (each for each in installed_commands() if each.name == name)
    parser = Parser()
    command.configure(parser)
    assert sorted(written(each) for each in parser._actions[1:]) == sorted(COMMANDS[name].split())


def test_values_have_the_type_that_fits() -> None:
    types = {
        (command.name, action.dest): action.type
        for command in installed_commands()
        for parser in [Parser()]
        for action in (command.configure(parser), parser._actions)[1]
    }
    assert types["map", "output"] is not None
    read = types["respond", "file"]
    assert callable(read) and read("a.toml") == Path("a.toml")
    for key in (("linear", "parameters"), ("fit", "measured"), ("overlay", "against"), ("sample", "file")):
        assert types[key] is read, key
    write = types["linear", "plot"]
    for key in (("fit", "output"), ("sample", "output"), ("simulate", "csv"), ("spectrum", "wav")):
        assert types[key] is write, key
    for key in (("simulate", "gap"), ("simulate", "duration"), ("identify", "uncertainty")):
        assert types[key] is float, key
    for key in (("map", "starts"), ("map", "jobs"), ("spectrum", "bits"), ("respond", "seed")):
        assert types[key] is int, key
