"""The logarithmic KdV–Burgers equation: its fronts and its evolution (James 2021, section 5)."""
