"""Amplitude equations of the chain and their fronts (James 2021, sections 4 and 5)."""
