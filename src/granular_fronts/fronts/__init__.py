"""Exact travelling fronts of the lattice (James 2021, section 6): tails, profiles, stability.

A front is computed by two methods that share no code and check each other.  `profile` solves the
advance–delay equation; `shooting` lets a window of beads move for one bead-time and asks that it
return to itself shifted by one bead.  `stability` reads the multipliers of the same map.
"""

from granular_fronts import compiled  # noqa: F401  (decides the cache folder before any kernel)
