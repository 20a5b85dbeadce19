"""Fronts of the chain with linear dashpots (β = 1) that are proved.

The same way as with β = α, but of the strain u itself: `existence`, `right_inverse` and `ahead`
hold the mathematics, `checker` proves, and `certificate` makes what it checks.
"""
