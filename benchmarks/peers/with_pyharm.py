"""pyHarm: harmonic balance of the oscillator with a stop over omega, its own published example."""

import contextlib
import io
import logging
from importlib.metadata import version

import numpy as np
from pyHarm.Maestro import Maestro

from benchmarks.peers.telling import tell

SETTINGS = {"7 harmonics, 128 samples": (7, 128), "15 harmonics, 1024 samples": (15, 1024)}


def folds(harmonics: int, samples: int) -> tuple[float, float]:
    """Return upper and lower fold, rad/s: where omega turns along the branch, to the nearest point."""
    unit = np.eye(1)
    matrices = {"M": unit, "C": 0.1 * 40**0.5 * unit, "K": 40.0 * unit, "G": 0.0 * unit}
    system = {
        "system": {"type": "Base", "nh": harmonics, "nti": samples, "adim": {"status": False}},
        "substructures": {"body": {"matrix": matrices, "ndofs": 1}},
        "connectors": {
            "stop": {
                "type": "PenaltyUnilateralGap",
                "connect": {"body": [0]},
                "dirs": [0],
                "k": 1000.0,
                "g": 10.0,
            },
            "drive": {"type": "CosinusForcing", "connect": {"body": [0]}, "dirs": [0], "amp": 100.0},
        },
        "analysis": {
            "frf": {"study": "frf", "puls_inf": 6.0, "puls_sup": 10.0, "sign_ds": -1, "verbose": False}
        },
    }
    with contextlib.redirect_stdout(io.StringIO()):
        study = Maestro(system)
        study.operate()
    omega = np.array([each.x[-1] for each in study.nls["frf"].SolList if each.flag_accepted])
    turns = np.flatnonzero(np.diff(np.sign(np.diff(omega)))) + 1
    found = omega[turns]
    return float(max(found)), float(min(found))


if __name__ == "__main__":
    logging.disable(logging.CRITICAL)
    folds(7, 128)  # compiles, at its first call on a machine
    for setting, (harmonics, samples) in SETTINGS.items():
        name = f"pyHarm {version('pyHarm-os')}"
        tell(name, setting, "oscillator-stop", "upper fold", lambda h=harmonics, s=samples: folds(h, s)[0])
