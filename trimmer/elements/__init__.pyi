"""The public names of this room, each imported on first use."""

from .backlashes.friction_backlash import FrictionBacklash as FrictionBacklash
from .backlashes.inertia_backlash import InertiaBacklash as InertiaBacklash
from .backlashes.viscous_backlash import ViscousBacklash as ViscousBacklash
from .control_element import ControlElement as ControlElement
from .coulomb_friction import CoulombFriction as CoulombFriction
from .dead_zone import DeadZone as DeadZone
from .element import Element as Element
from .element_at_frequency import ElementAtFrequency as ElementAtFrequency
from .own_element import OwnElement as OwnElement
from .own_element import StaticElement as StaticElement
from .preload import Preload as Preload
from .quadrature import QuadratureEstimate as QuadratureEstimate
from .relay import Relay as Relay
from .saturation import Saturation as Saturation
from .scaled_element import ScaledElement as ScaledElement
from .sum_of_elements import SumOfElements as SumOfElements
from .viscous_friction import ViscousFriction as ViscousFriction
