"""Exact travelling fronts of the lattice (James 2021, section 6): tails, profiles, stability.

A front is computed by two methods that share no code and check each other.  `profile` solves the
advance–delay equation of the front on a grid; `shooting` lets a window of beads move for one
bead-time and asks that it return to itself shifted by one bead.  `tails` knows how a front
approaches its ends, `critical_damping` where it stops to oscillate, and `stability` reads the
multipliers of the bead-time map.  `solve` is the public face.
"""

from granular_fronts.fronts.warming import warm_up

__all__ = ["warm_up"]
