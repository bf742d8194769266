"""NLvib: the oscillator on a spring with corners, by harmonic balance in Octave; NLVIB names its folder.

It comes from its authors' site (M. Krack, J. Gross, Harmonic Balance for Nonlinear Vibration Problems, 2019)
and is not copied here. The spring is two unilateral ones beside a linear one. A second body without forces is
there since elements act along a direction. Only the equations at one frequency are solved.
"""

from __future__ import annotations

import os
import subprocess
import sys
from functools import partial
from pathlib import Path

from benchmarks.peers.telling import tell

SETTINGS = {
    "7 harmonics, 128 instants, with the start of Octave": (7, 128),
    "31 harmonics, 4096 instants, with the start of Octave": (31, 4096),
}
PROGRAM = """
addpath('{folder}/SRC');
function [R, J] = part(X, s, H, N, Om)
  [R, dR] = HB_residual([X; Om], s, H, N, 'FRF'); J = dR(:, 1:end-1);
end
spring = @(way) struct('type', 'unilateralSpring', 'stiffness', 3, 'gap', 1, ...
                       'force_direction', [way; 0], 'islocal', 1, 'ishysteretic', 0);
s = struct('M', eye(2), 'D', diag([.15 1]), 'K', diag([1 1]), 'Fex1', [-4i; 0], 'n', 2);
s.nonlinear_elements = {{spring(1), spring(-1)}};
settings = optimset('Display', 'off', 'Jacobian', 'on', 'MaxIter', 200, 'TolFun', 1e-13, 'TolX', 1e-13);
x0 = zeros(2*(2*{harmonics}+1), 1); x0(3) = -2.1; x0(5) = -2.1;
[x, f, info] = fsolve(@(X) part(X, s, {harmonics}, {instants}, pi/2), x0, settings);
t = linspace(0, 2*pi, 400001)(1:end-1); q = x(1) + zeros(size(t));
for h = 1:{harmonics}, q += x(4*h-1)*cos(h*t) + x(4*h+1)*sin(h*t); end
printf('%.17g %.17g %d\\n', max(q) - min(q), std(q, 1), info);
"""


def found(harmonics: int, instants: int, which: int) -> float:
    """Return peak to peak or rms.

    Raises:
        ArithmeticError: if it does not converge.
    """
    program = PROGRAM.format(folder=os.environ["NLVIB"], harmonics=harmonics, instants=instants)
    asked = ["octave-cli", "--quiet", "--eval", program]
    told = subprocess.run(asked, check=True, capture_output=True, text=True).stdout.split()
    if int(told[2]) <= 0:
        raise ArithmeticError("fsolve did not converge")
    return float(told[which])


if __name__ == "__main__":
    if not Path(os.environ.get("NLVIB", ""), "SRC", "HB_residual.m").exists():
        sys.exit("set NLVIB to its folder, in which SRC is")
    for setting, (harmonics, instants) in SETTINGS.items():
        for which, digit in enumerate(("peak to peak of x", "rms of x")):
            tell("NLvib", setting, "hardening-spring", digit, partial(found, harmonics, instants, which))
