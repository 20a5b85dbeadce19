"""Exact traveling fronts of the chain (James 2021, section 6): tails, profiles, stability.

A front is computed by two methods that share no code and check each other.  `shooting` lets a
window of beads move for one bead-time and asks that it return to itself shifted by one bead;
`stability` reads the multipliers of the same map.
"""
