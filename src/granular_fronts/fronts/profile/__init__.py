"""Fronts by their advance–delay equation: Newton's iteration for the profile on a grid."""
