"""Exact travelling fronts of the lattice (James 2021, section 6): tails, profiles, stability.

A front is computed by two methods that share no code and check each other.  `profile` solves the
advance–delay equation of the front on a grid. `shooting` lets a window of beads move for one
bead-time and asks that it return to itself, shifted by one bead.  `linear` describes how a front
approaches its ends, at which damping it ceases to oscillate, and its Floquet multipliers.  `solve`
is the public face.
"""
