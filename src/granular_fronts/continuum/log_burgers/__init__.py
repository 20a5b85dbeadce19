"""The logarithmic Burgers equation: fluxes, fronts, evolution (James 2021, section 4)."""
