"""Dissipative granular chains: equations, compiled integrator, scenes (James 2021, section 3)."""
