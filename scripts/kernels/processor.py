"""Kernels of OpenBLAS, what a processor needs for them, and how a process is made to compute as with them."""

import os
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

PROCESSOR = Path("/proc/cpuinfo")
CHOOSING = ("OPENBLAS_", "OMP_", "MKL_", "NUMBA_", "NPY_", "GLIBC_TUNABLES")
"""Beginnings of the variables that choose code or threads; what this machine says in them does not count."""


@dataclass(frozen=True)
class Kernel:
    """A generation of processors."""

    name: str  # As ``OPENBLAS_CORETYPE`` takes it
    called: str  # As OpenBLAS calls it when asked what it runs
    needs: frozenset[str]  # Flags of /proc/cpuinfo that its instructions need
    numpy_without: str  # Pattern of the features of NumPy that such a processor lacks
    libc_without: tuple[str, ...]  # Features that the C library is not to use

    def missing(self, flags: frozenset[str]) -> list[str]:
        """Return the flags that a processor lacks for it."""
        return sorted(self.needs - flags)

    def environment(self, threads: int, generic: bool, numpy_features: list[str]) -> Mapping[str, str]:
        """Return the variables of a process that computes with this kernel.

        Args:
            threads: Of BLAS.
            generic: Whether Numba compiles for any processor of 64 bits, or for this very one.
            numpy_features: Those that NumPy would choose between here.
        """
        lacking = [each for each in numpy_features if re.search(self.numpy_without, each)]
        variables = {
            "OPENBLAS_CORETYPE": self.name,
            "OPENBLAS_NUM_THREADS": str(threads),
            "NPY_DISABLE_CPU_FEATURES": " ".join(lacking),
        }
        if self.libc_without:
            variables["GLIBC_TUNABLES"] = "glibc.cpu.hwcaps=" + ",".join(
                f"-{each}" for each in self.libc_without
            )
        if generic:
            variables["NUMBA_CPU_NAME"] = "generic"
        return variables


WIDE = ("AVX512F", "AVX512VL")
NARROW = ("AVX", "AVX2", "FMA", "FMA4", *WIDE)
KERNELS = {
    kernel.name: kernel
    for kernel in (
        Kernel("Prescott", "Katmai", frozenset(), ".", NARROW),
        Kernel("Nehalem", "Nehalem", frozenset({"sse4_2"}), ".", NARROW),
        Kernel("Haswell", "Haswell", frozenset({"avx2", "fma"}), "AVX512|V4", WIDE),
        Kernel(
            "SkylakeX",
            "SkylakeX",
            frozenset({"avx512f", "avx512dq", "avx512bw", "avx512vl", "avx512cd"}),
            "$^",
            (),
        ),
    )
}


def processor_flags(listing: Path = PROCESSOR) -> frozenset[str]:
    """Return the flags of this processor; none where the system does not list them, or it is no x86."""
    try:
        found = re.search(r"^flags\s*:(.*)$", listing.read_text(encoding="utf-8"), re.MULTILINE)
    except OSError:
        return frozenset()
    return frozenset(found[1].split()) if found else frozenset()


def plain_environment() -> dict[str, str]:
    """Return the variables of this process without those that choose code."""
    return {name: value for name, value in os.environ.items() if not name.startswith(CHOOSING)}
