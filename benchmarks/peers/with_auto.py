"""AUTO-07p: the branch of the oscillator with a stop over omega.

The stop is smoothed, as AUTO follows smooth systems. The drive is an oscillator of two more states, as in the
demo ``frc`` of AUTO. The start is the motion without the stop.
"""

import os
import subprocess
from functools import partial
from pathlib import Path

from benchmarks.peers.telling import tell

LIBRARY = Path("/usr/lib/auto-07p/lib")
SETTINGS = {
    "stop smoothed over 0.01, NTST 50": ("1d-2", 50),
    "stop smoothed over 1e-4, NTST 200": ("1d-4", 200),
}
FOLD, DOUBLING = 5, 7  # AUTO's numbers of the types of special points, its manual, section 5.3
EQUATIONS = """
subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision :: depth, growth
  depth = u(1) - 10d0
  growth = 1d0 - u(3)**2 - u(4)**2
  f(1) = u(2)
  f(2) = 100d0*u(3) - 0.1d0*sqrt(40d0)*u(2) - 40d0*u(1) - 500d0*(depth + sqrt(depth**2 + par(2)**2))
  f(3) = growth*u(3) - par(1)*u(4)
  f(4) = growth*u(4) + par(1)*u(3)
end subroutine
subroutine stpnt(ndim, u, par, t)
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(inout) :: u(ndim), par(*)
  double precision, intent(in) :: t
  double precision, parameter :: omega = 5d0, turn = 6.283185307179586d0
  double complex :: x
  par(1) = omega
  par(2) = SMOOTHING
  par(11) = turn/omega
  x = 100d0/dcmplx(40d0 - omega**2, omega*0.1d0*sqrt(40d0))*exp(dcmplx(0d0, turn*t))
  u = [dble(x), dble(x*dcmplx(0d0, omega)), cos(turn*t), sin(turn*t)]
end subroutine
""" + "".join(f"subroutine {name}\nend subroutine\n" for name in ("bcnd", "icnd", "fopt", "pvls"))
CONSTANTS = """NDIM=4, IPS=2, IRS=0, ILP=1, ICP=[1,11], NTST={intervals}, NCOL=4, IAD=3, ISP=2, ISW=1, IPLT=0
NBC=0, NINT=0, NMX=20000, NPR=20000, MXBF=0, IID=0, ITMX=9, ITNW=7, NWTN=3, JAC=0
EPSL=1e-7, EPSU=1e-7, EPSS=1e-5, DS=0.01, DSMIN=1e-6, DSMAX=0.5, IADS=1
NPAR=11, THL={{11:0.0}}, UZSTOP={{1:12.0}}
"""


def made(smoothing: str) -> None:
    """Compile the equations; AUTO is a program for each set of them."""
    Path("stop.f90").write_text(EQUATIONS.replace("SMOOTHING", smoothing))
    objects = sorted(map(str, LIBRARY.glob("*.o")))
    flags = ["-O2", "-w", "-std=legacy", "-fopenmp", "-o", "stop"]
    subprocess.run(["gfortran", "stop.f90", *objects, *flags], check=True)


def special(intervals: int, kind: int, which: int) -> float:
    """Follow the branch from 5 to 12 rad/s and return a special point of a kind, rad/s.

    Raises:
        LookupError: if AUTO has not found the two that there are.
    """
    constants = CONSTANTS.format(intervals=intervals)
    threads = {**os.environ, "OMP_NUM_THREADS": "1"}
    subprocess.run(["./stop"], input=constants, text=True, capture_output=True, check=True, env=threads)
    rows = [line.split() for line in Path("fort.7").read_text().splitlines()]
    found = sorted(float(row[4]) for row in rows if row[0] != "0" and int(row[2]) == kind)
    if len(found) != 2:
        raise LookupError(f"{len(found)} of 2 were found")
    return found[which]


def version() -> str:
    """Return the version that Debian names."""
    asked = ["dpkg-query", "-W", "-f", "${Version}", "auto-07p"]
    return subprocess.run(asked, check=True, capture_output=True, text=True).stdout.partition("+")[0]


if __name__ == "__main__":
    name = f"AUTO-07p {version()}"
    for setting, (smoothing, intervals) in SETTINGS.items():
        made(smoothing)
        for digit, kind, which in (
            ("upper fold", FOLD, 1),
            ("lower fold", FOLD, 0),
            ("first period doubling", DOUBLING, 0),
            ("second period doubling", DOUBLING, 1),
        ):
            tell(name, setting, "oscillator-stop", digit, partial(special, intervals, kind, which))
