"""Linear theory of fronts: tails, critical damping, Floquet multipliers."""
