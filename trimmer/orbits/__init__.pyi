"""The public names of this room, each imported on first use."""

from .multi_harmonic_balance import BalancedHarmonics as BalancedHarmonics
from .orbit_measures import ImpactEvent as ImpactEvent
from .periodic_orbit import PeriodicOrbit as PeriodicOrbit
from .search import BalanceSearch as BalanceSearch
from .search import OrbitSearch as OrbitSearch
from .search import OrbitSearched as OrbitSearched
from .search import OrbitSearchInterrupted as OrbitSearchInterrupted
from .search import PeriodicOrbits as PeriodicOrbits
from .search import RelaySearch as RelaySearch
from .search import Simulations as Simulations
from .search import SimulationSearch as SimulationSearch
