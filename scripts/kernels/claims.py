"""Judge all claims and write ``claims.json``, without proofs, figures and pages: ``... claims FILE KERNEL``.

Before that it is made sure that OpenBLAS runs the kernel that it was asked for.
"""

import ctypes
import re
import sys
from argparse import ArgumentParser
from pathlib import Path

from report.building.collect import collect
from report.data.statements import read_inventory
from report.data.text_copy import read_text_copy
from report.judging.judge import judge
from report.numbers.evidence import gather
from report.rendering.json import claims_json
from scripts.kernels.processor import KERNELS

ASKING = re.compile(rb"\0(\w{0,20}openblas_get_corename\w{0,20})\0")


def main(file: str, kernel: str | None = None) -> int:
    """Write the file; return the exit code."""
    if kernel is not None and (running := running_kernels()) != {KERNELS[kernel].called}:
        print(
            f"error: OpenBLAS was asked for {kernel}, and runs {sorted(running) or 'nothing'}",
            file=sys.stderr,
        )
        return 1
    inventory, evidence = read_inventory(), gather()
    records = collect(inventory).by_id
    findings = tuple(judge(records[each].claim(evidence), entry) for each, entry in inventory.items())
    Path(file).write_text(claims_json(findings, read_text_copy().sha256), encoding="utf-8")
    return 0


def running_kernels() -> set[str]:
    """Return the names of the kernels that the loaded copies of OpenBLAS run; SciPy has one of its own."""
    mapped = Path("/proc/self/maps").read_text(encoding="utf-8")
    libraries = {line.split()[-1] for line in mapped.splitlines() if "openblas" in line}
    return {_running(Path(library)) for library in libraries}


def _running(library: Path) -> str:
    """Ask one copy; each build gives its functions a prefix and an ending of its own."""
    (name,) = set(ASKING.findall(library.read_bytes()))
    ask = getattr(ctypes.CDLL(str(library)), name.decode())
    ask.restype = ctypes.c_char_p
    return str(ask().decode())


if __name__ == "__main__":
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("file", metavar="FILE")
    parser.add_argument("kernel", nargs="?", choices=KERNELS, metavar="KERNEL")
    sys.exit(main(**vars(parser.parse_args())))
