"""The symbols of the describing functions, each with its meaning and SI unit, for the nomenclature."""

from derivations.elements.backlash import CONTACT, GAMMA, GAP, SEPARATION
from derivations.elements.backlash_harmonics import CONTACT_ANGLE, DECAY, FLIGHT, IMPACT_VELOCITY
from derivations.elements.friction import DAMPING, FORCE, LEVEL
from derivations.elements.harmonics import HARMONIC
from derivations.elements.waveform import THETA
from derivations.symbols import METRE, NEWTON, NEWTON_SECOND_PER_METRE, ONE, RADIAN, Quantity

ELEMENT_QUANTITIES = (
    Quantity(THETA, "phase of the input", RADIAN),
    Quantity(HARMONIC, "number of a harmonic", ONE),
    Quantity(LEVEL, "output level of a relay", ONE),
    Quantity(FORCE, "Coulomb friction force", NEWTON),
    Quantity(DAMPING, "viscous friction", NEWTON_SECOND_PER_METRE),
    Quantity(GAP, "total clearance of a backlash", METRE),
    Quantity(GAMMA, "angular frequency times the load's time constant M/D", ONE),
    Quantity(SEPARATION, "phase at which the load separates from the pin", RADIAN),
    Quantity(CONTACT, "phase at which the load meets the other wall", RADIAN),
    Quantity(FLIGHT, "angle of free flight", RADIAN),
    Quantity(CONTACT_ANGLE, "angle of contact", RADIAN),
    Quantity(DECAY, "what is left of the load's velocity after the flight", ONE),
    Quantity(IMPACT_VELOCITY, "relative velocity of the impact, over amplitude and angular frequency", ONE),
)
