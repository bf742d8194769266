"""Harmonic balance, Newton's method, Loeb's rule and the proof of dissipation, each against another way."""

import re
from dataclasses import replace

import numpy as np
import pytest
import sympy

from derivations.algebra.identity import UnprovenError
from derivations.linear_trimmer import derive_linear_trimmer
from derivations.loop import dissipation
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


def test_the_proof_of_dissipation_holds_for_the_trimmer_alone(monkeypatch):
    trimmer = derive_linear_trimmer()
    step = dissipation.dissipation_step(trimmer)
    assert r"\left|C_{1}\right| = c_{1} + c_{2}" in step.formulas[-2].latex
    broken = replace(dissipation.incremental_dissipation(trimmer), residual=sympy.Integer(1))
    monkeypatch.setattr(dissipation, "incremental_dissipation", lambda _: broken)
    with pytest.raises(UnprovenError, match="not proven to come together"):
        dissipation.dissipation_step(trimmer)


@pytest.mark.parametrize("same", [True, False])
def test_the_three_cases_of_friction_are_those_of_the_proof(same):
    """(f_a - f_b)(w_a - w_b) by cases, as the step tells them, at numbers."""
    force, velocity, other, sticking = 2.0, 0.7, 1.9 if same else -1.9, 1.3
    sliding = (force - force * np.sign(other)) * (velocity - other)
    assert sliding == pytest.approx(0.0 if same else 2 * force * (abs(velocity) + abs(other)))
    assert (force - sticking) * velocity >= (force - abs(sticking)) * abs(velocity) - 1e-12
