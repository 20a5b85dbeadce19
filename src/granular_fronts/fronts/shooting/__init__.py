"""Fronts by shooting: a window of beads that returns to itself, shifted by one bead."""
