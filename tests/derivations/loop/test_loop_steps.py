"""Harmonic balance, Newton's method, Loeb's rule and the proof of dissipation, each against another way."""

import re
from dataclasses import replace

import numpy as np
import pytest
import sympy

from derivations.algebra.identity import UnprovenError
from derivations.loop.harmonic_balance import balance_step, newton_step, solution_step
from derivations.loop.loeb import SLOPES, growth_rate, loeb_step

STEPS = (balance_step, solution_step, loeb_step)


@pytest.mark.parametrize("step", STEPS)
def test_each_equation_is_proven_and_no_altered_one(step):
    whole = step()
    proven = whole.proven()
    assert proven.code
    assert f"Proven equations: {len(whole.equalities)}." in proven.text
    for equality in whole.equalities:
        for altered in (-equality.closed, equality.closed + sympy.Rational(1, 10**9)):
            with pytest.raises(UnprovenError, match=re.escape(equality.name)):
                replace(equality, closed=altered).prove()


def test_newtons_step_solves_the_linear_equation():
    random = np.random.default_rng(7)
    residual, by_angle, by_omega = random.normal(size=3) + 1j * random.normal(size=3)
    values = {}
    for name, value in (("F", residual), ("F_ell", by_angle), ("F_omega", by_omega)):
        values |= dict(
            zip(sympy.symbols(f"{name}_r {name}_i", real=True), (value.real, value.imag), strict=True)
        )
    changes = [float(each.subs(values)) for each in newton_step()]
    matrix = np.array([[by_angle.real, by_omega.real], [by_angle.imag, by_omega.imag]])
    expected = np.linalg.solve(matrix, [-residual.real, -residual.imag])
    assert changes == pytest.approx(expected)


@pytest.mark.parametrize("seed", range(5))
def test_loebs_rule_is_the_sign_of_a_complex_quotient(seed):
    random = np.random.default_rng(seed)
    by_amplitude, by_omega = random.normal(size=2) + 1j * random.normal(size=2)
    parts = (by_amplitude.real, by_amplitude.imag, by_omega.real, by_omega.imag)
    rate = float(growth_rate().subs(dict(zip(SLOPES, parts, strict=True))))
    assert rate == pytest.approx((by_amplitude / by_omega).imag)
    x_a, y_a, x_omega, y_omega = parts
    assert (rate < 0) == (x_a * y_omega - x_omega * y_a > 0)
