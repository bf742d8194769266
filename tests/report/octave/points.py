"""Where the listings are compared with Python, and the Octave script that evaluates them there."""

import numpy as np

from trimmer import ViscousBacklash
from trimmer.arrays import Reals

GAP = 3e-5
FRICTION_RATIOS = np.array([1e-6, 1e-3, 0.1, 0.5, 1.0, 1.5, 1.9, 1.99, 2.0, 2.5, 7.0])
INERTIA_RATIOS = np.array([1e-4, 1e-2, 0.1, 0.7, 1.5, 2.0, 2.4, 3.0, 3.14, 3.2, 5.0])
GAMMAS = np.array([0.02, 0.3, 1.0, 1.25, 5.0, 60.0])
VISCOUS_SHARES = np.array([1e-3, 0.05, 0.3, 0.6, 0.9, 0.99, 1.01])
FORCE, STIFFNESS = 0.8, 2.5e4
AMPLITUDE, FREQUENCY = 7e-5, 109.845
# Five periods in steps that meet the instants of separation and come close to those of contact.
TIMES = np.arange(0, 5 * 400) / (400 * FREQUENCY)
OMEGAS = np.array([1.0, 628.0, 1397.0, 3453.0, 4608.5, 7160.0, 5e4])
NUMERATOR = 1.5  # Of 1.5/(s (s + 1)^2), whose limit cycles lie near 1 rad/s, and which has a pole at zero
LOOP_GAIN = 3.0
"""Raises the trimmer's transfer function until friction-controlled backlash has four limit cycles."""
WALK = 1e-5 * np.cumsum(np.random.default_rng(5).normal(size=300))
VISCOUS_RATIOS = VISCOUS_SHARES[:, None] * ViscousBacklash(gap=1.0, time_constant=1.0).domain(GAMMAS)


def column(values: Reals) -> str:
    """Return an array of one dimension as an Octave column, to the last bit."""
    return f"[{'; '.join(repr(float(value)) for value in values.ravel())}]"


DRIVER = f"""
warning('on', 'Octave:language-extension');
disp(jsonencode(main_numbers()));
parts = @(values) struct('real', real(values), 'imaginary', imag(values));
amplitude = {GAP!r}./{column(FRICTION_RATIOS)};
grid.friction = parts(listing_a_2(amplitude, {GAP!r}));
grid.friction_again = parts(listing_a_3(amplitude, {GAP!r}));
grid.inertia = parts(listing_a_4({column(INERTIA_RATIOS)}));
grid.inertia_again = parts(listing_a_10({column(INERTIA_RATIOS)}));
gamma = {column(np.broadcast_to(GAMMAS, VISCOUS_RATIOS.shape))};
grid.viscous = parts(listing_a_5({column(VISCOUS_RATIOS)}, gamma));
grid.combined = parts(listing_a_6(amplitude, {GAP!r}, {FORCE!r}, {STIFFNESS!r}));
time = {column(TIMES)};
pin = {AMPLITUDE!r}*sin(2*pi*{FREQUENCY!r}*time);
grid.friction_motion = listing_a_7(pin, {GAP!r}, 0);
grid.walk = listing_a_7({column(WALK)}, {GAP!r}, 0);
grid.inertia_motion = listing_a_8(time, {AMPLITUDE!r}, {GAP!r}, {FREQUENCY!r});
[~, contact] = listing_a_4({GAP!r}/{AMPLITUDE!r});
instants = [contact; pi; pi + contact]/(2*pi*{FREQUENCY!r});
grid.at_contact = listing_a_8(instants, {AMPLITUDE!r}, {GAP!r}, {FREQUENCY!r});
grid.instants = instants;
none = listing_a_9({GAP!r}, @(ratio, omega) NaN(size(ratio)));
grid.none = numel(none.amplitude);
model = listing_a_1();
friction = @(ratio, omega) listing_a_2(1./ratio, 1);
grid.raised = listing_a_9(1, friction, {LOOP_GAIN!r}*model.numerator_displacement, model.denominator);
grid.raised.N = [];
grid.textbook = listing_a_9(1, friction, {NUMERATOR}, [1 2 1 0]);
grid.textbook.N = [];
[~, state_space] = listing_a_1();
grid.response = parts(squeeze(freqresp(state_space, {column(OMEGAS)})));
disp(jsonencode(grid));
"""
