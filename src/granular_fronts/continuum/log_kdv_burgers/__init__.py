"""The logarithmic KdV–Burgers equation and its heteroclinic orbits (James 2021, section 5)."""
